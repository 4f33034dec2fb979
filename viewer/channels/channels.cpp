#include "striate/viewer/channels/channels.hpp"

#include <algorithm>

#include "striate/viewer/cdr/cdr_writer.hpp"
#include "striate/viewer/channels/body_messages.hpp"
#include "striate/viewer/channels/mind_messages.hpp"
#include "striate/viewer/channels/ros_stamps.hpp"
#include "striate/viewer/channels/seen_json.hpp"

namespace striate::viewer {

template <class Message>
void Channels::send(Topic topic, const Message& message) {
  if (!wants(topic)) return;
  encode_cdr(message, bytes_);
  (*sink_)(topic, log_time_ns_, bytes_);
}

void Channels::send_json(Topic topic, const Json& json) {
  if (!wants(topic)) return;
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  (*sink_)(topic, log_time_ns_, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

void Channels::publish(const CycleFacts& facts, const Sink& sink) {
  sink_ = &sink;
  log_time_ns_ = static_cast<std::uint64_t>(
      std::max<std::int64_t>(0, facts.senses.now.time_since_epoch().count()));
  publish_body(facts);
  if (facts.new_image) publish_images(facts);
  if (facts.new_percept) publish_vision(facts);
  if (facts.slow_is_new) publish_slow(facts);
  if (facts.new_global) {
    write_grid(facts.global, ros_header(facts.senses.now, kMapFrame), grid_);
    send(Topic::map_global, grid_);
  }
  publish_reports(facts);
}

void Channels::publish_body(const CycleFacts& facts) {
  const Senses& senses = facts.senses;
  send(Topic::tf, tf_of(facts, robot_));
  send(Topic::odom, odometry_of(facts));
  if (facts.on_map) send(Topic::pose, pose_of(facts));
  if (!senses.laser.readings.empty() && senses.laser.stamp != laser_stamp_) {
    laser_stamp_ = senses.laser.stamp;
    send(Topic::scan, scan_of(senses.laser));
  }
  if (!senses.sonar.readings.empty() && senses.sonar.stamp != sonar_stamp_) {
    sonar_stamp_ = senses.sonar.stamp;
    send(Topic::sonar, sonar_of(senses.sonar));
  }
  send(Topic::cmd_vel, cmd_vel_of(facts));
}

void Channels::publish_images(const CycleFacts& facts) {
  const StereoFrame& frame = facts.senses.stereo;
  send(Topic::left_info, camera_info_of(frame, false));
  if (wants(Topic::left_image)) {
    write_image(frame.left, frame.stamp, image_);
    send(Topic::left_image, image_);
  }
  if (frame.right.empty()) return;
  send(Topic::right_info, camera_info_of(frame, true));
  if (wants(Topic::right_image)) {
    write_image(frame.right, frame.stamp, image_);
    send(Topic::right_image, image_);
  }
}

void Channels::publish_vision(const CycleFacts& facts) {
  if (!facts.disparity.disparity_px.empty() && wants(Topic::disparity)) {
    write_disparity(facts, disparity_);
    send(Topic::disparity, disparity_);
  }
  if (!facts.salience.empty() && wants(Topic::saliency)) {
    write_saliency(facts, saliency_);
    send(Topic::saliency, saliency_);
  }
  send(Topic::obstacles, obstacles_of(facts));
  if (wants(Topic::seen)) send_json(Topic::seen, seen_json(facts, robot_));
}

void Channels::publish_slow(const CycleFacts& facts) {
  write_grid(facts.slow.local, ros_header(facts.senses.now, kOdometryFrame), grid_);
  send(Topic::map_local, grid_);
  send(Topic::trajectory, trajectory_of(facts));
  send(Topic::landmarks, landmarks_of(facts));
  if (facts.on_map) send(Topic::route, routes_of(facts));
  send(Topic::battery, battery_of(facts.senses));
  send(Topic::diagnostics, diagnostics_of(facts));
  send_json(Topic::short_term, facts.slow.short_term);
}

void Channels::publish_reports(const CycleFacts& facts) {
  for (const msgs::Log& line : log_.news(facts)) send(Topic::log, line);
  const std::string said = std::string(name_of(facts.state)) + " " + facts.doing;
  if (said != task_said_) {
    task_said_ = said;
    send_json(Topic::task, task_json(facts, mission_, tree_));
  }
  if (const std::string nodes = facts.nodes + facts.node_reason; nodes != nodes_said_) {
    nodes_said_ = nodes;
    send_json(Topic::task_nodes, {{"states", facts.nodes}, {"reason", facts.node_reason}});
  }
  send_json(Topic::wish, wish_json(facts));
  if (!facts.recognised.empty() || !facts.lessons.empty()) {
    send_json(Topic::memory_events, memory_events_json(facts));
  }
  send_json(Topic::cycle, cycle_json(facts));
}

}  // namespace striate::viewer
