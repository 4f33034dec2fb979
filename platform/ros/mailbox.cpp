#include "striate/platform/ros/mailbox.hpp"

#include <string>

namespace striate::ros {
namespace {

/// How many messages of a topic may wait; what is more is thrown away, the oldest first.
constexpr std::uint32_t kImagesWaiting = 2;
constexpr std::uint32_t kOthersWaiting = 4;  // a cycle of odometry at 40 Hz

bool is_compressed(const std::string& topic) {
  const std::string end = "/compressed";
  return topic.size() > end.size() &&
         topic.compare(topic.size() - end.size(), end.size(), end) == 0;
}

/// A message that cannot be taken has not come: what it tells of gets old, and the robot stands.
/// ROS's thread would end the program for an error that leaves it.
template <class Take>
void take_or_leave(Mailbox& box, const Take& take) noexcept {
  try {
    const std::lock_guard lock(box.mutex);
    take(box.inbox);
  } catch (...) {
  }
}

class Subscribing {
 public:
  Subscribing(::ros::NodeHandle& node, Mailbox& mailbox) : node_(node), mailbox_(mailbox) {}

  template <class Message>
  void hear(const std::string& topic) {
    boost::function<void(const boost::shared_ptr<const Message>&)> take =
        [&box = mailbox_](const auto& message) {
          take_or_leave(box, [&](Inbox& inbox) { inbox.take(*message, box.clock.now()); });
        };
    subscribers_.push_back(
        node_.subscribe<Message>(topic, kOthersWaiting, take, nullptr, at_once()));
  }
  template <class Message>
  void hear_images(Eye eye, const std::string& topic) {
    boost::function<void(const boost::shared_ptr<const Message>&)> take =
        [&box = mailbox_, eye](const auto& message) {
          take_or_leave(box, [&](Inbox& inbox) { inbox.take(eye, *message, box.clock.now()); });
        };
    subscribers_.push_back(
        node_.subscribe<Message>(topic, kImagesWaiting, take, nullptr, at_once()));
  }
  void hear_eye(Eye eye, const std::string& pictures, const std::string& info) {
    if (is_compressed(pictures)) {
      hear_images<sensor_msgs::CompressedImage>(eye, pictures);
    } else {
      hear_images<sensor_msgs::Image>(eye, pictures);
    }
    boost::function<void(const sensor_msgs::CameraInfoConstPtr&)> take =
        [&box = mailbox_, eye](const auto& message) {
          take_or_leave(box, [&](Inbox& inbox) { inbox.take(eye, *message); });
        };
    subscribers_.push_back(node_.subscribe<sensor_msgs::CameraInfo>(info, kImagesWaiting, take));
  }
  [[nodiscard]] std::vector<::ros::Subscriber> all() const { return subscribers_; }

 private:
  static ::ros::TransportHints at_once() { return ::ros::TransportHints().tcpNoDelay(); }
  ::ros::NodeHandle& node_;
  Mailbox& mailbox_;
  std::vector<::ros::Subscriber> subscribers_;
};

}  // namespace

std::vector<::ros::Subscriber> subscribe(::ros::NodeHandle& node, const RosSettings& settings,
                                         Mailbox& mailbox) {
  Subscribing to(node, mailbox);
  to.hear_eye(Eye::left, settings.left_image, settings.left_info);
  to.hear_eye(Eye::right, settings.right_image, settings.right_info);
  to.hear<nav_msgs::Odometry>(settings.odometry);
  to.hear<sensor_msgs::LaserScan>(settings.scan);
  to.hear<sensor_msgs::PointCloud>(settings.sonar);
  to.hear<sensor_msgs::JointState>(settings.joints);
  return to.all();
}

}  // namespace striate::ros
