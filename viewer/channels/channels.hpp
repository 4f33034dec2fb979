#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "striate/platform/interface/robot.hpp"
#include "striate/viewer/channels/channel_list.hpp"
#include "striate/viewer/channels/reports.hpp"
#include "striate/viewer/messages/navigation_messages.hpp"
#include "striate/viewer/messages/sensor_messages.hpp"

namespace striate::viewer {

/// Turns the facts of cycles into messages, for whoever shows or keeps them. The same facts give
/// the same bytes.
class Channels {
 public:
  /// Takes a message as it is made. The bytes hold until it returns.
  using Sink = std::function<void(Topic topic, std::uint64_t log_time_ns, ByteView message)>;

  Channels(const RobotDescription& robot, const tasks::Task& task)
      : robot_(robot), mission_(task.mission), tree_(task_tree(task.outline)) {}

  [[nodiscard]] const RobotDescription& robot() const { return robot_; }
  /// Only these from now on: nobody takes the others, so they are not made. At first all.
  void want(const TopicSet& topics) { wanted_ = topics; }
  /// The messages of a cycle. @throws as the sink
  void publish(const CycleFacts& facts, const Sink& sink);

 private:
  [[nodiscard]] bool wants(Topic topic) const { return wanted_[static_cast<std::size_t>(topic)]; }
  template <class Message>
  void send(Topic topic, const Message& message);
  void send_json(Topic topic, const Json& json);
  void publish_body(const CycleFacts& facts);
  void publish_images(const CycleFacts& facts);
  void publish_vision(const CycleFacts& facts);
  void publish_slow(const CycleFacts& facts);
  void publish_reports(const CycleFacts& facts);

  RobotDescription robot_;
  std::string mission_;
  Json tree_;
  LogTeller log_;
  TimePoint laser_stamp_{Duration::min()};
  TimePoint sonar_stamp_{Duration::min()};
  std::string nodes_said_;  ///< of the last message about its nodes
  std::string task_said_;   ///< state and action of the last message about the task

  TopicSet wanted_ = TopicSet().set();

  // Of the cycle in hand.
  const Sink* sink_ = nullptr;
  std::uint64_t log_time_ns_ = 0;
  // Kept, so that a cycle allocates little.
  Bytes bytes_;
  msgs::CompressedImage image_;
  msgs::DisparityImage disparity_;
  msgs::Image saliency_;
  msgs::OccupancyGrid grid_;
};

}  // namespace striate::viewer
