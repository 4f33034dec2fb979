#include "platform/ros/ros_robot.hpp"

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <std_msgs/Float64.h>

#include <boost/bind/bind.hpp>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "platform/interface/steady_clock.hpp"
#include "platform/ros/command_lease.hpp"
#include "platform/ros/inbox.hpp"
#include "platform/ros/node.hpp"

namespace striate::ros1 {
namespace {

constexpr double kPublishEvery_s = 0.05;
constexpr Duration kSonarFresh = std::chrono::milliseconds(700);
/// How long the last zero may take to the robot.
constexpr auto kGoodBye = std::chrono::milliseconds(100);

bool is_compressed(const std::string& topic) {
  const std::string end = "/compressed";
  return topic.size() > end.size() &&
         topic.compare(topic.size() - end.size(), end.size(), end) == 0;
}

}  // namespace

struct RosRobot::Parts {
  Parts(const RosSettings& given, const RobotDescription& description);
  void subscribe();
  void subscribe_eye(Eye eye, const std::string& pictures, const std::string& info);
  template <class Message>
  void hear(const std::string& topic);
  void publish();
  [[nodiscard]] std::string hold_reason(TimePoint now) const;
  [[nodiscard]] std::string missing() const;

  RosSettings settings;
  RobotDescription description;
  SteadyClock clock;
  TimePoint next_cycle;
  mutable std::mutex mutex;  ///< guards the three below
  Inbox inbox;
  CommandLease lease;
  bool drives = false;  ///< something was sent: from now on silence would not be a stop

  ::ros::CallbackQueue queue;
  ::ros::NodeHandle node;
  std::vector<::ros::Subscriber> subscribers;
  ::ros::Publisher cmd_vel;
  ::ros::Publisher pan;
  ::ros::Publisher tilt;
  ::ros::SteadyTimer timer;
  std::unique_ptr<::ros::AsyncSpinner> spinner;
};

RosRobot::Parts::Parts(const RosSettings& given, const RobotDescription& body)
    : settings(given), description(body), inbox(given), lease(from_seconds(given.lease_s)) {
  node.setCallbackQueue(&queue);
  subscribe();
  cmd_vel = node.advertise<geometry_msgs::Twist>(settings.cmd_vel, 1);
  pan = node.advertise<std_msgs::Float64>(settings.pan_command, 1);
  tilt = node.advertise<std_msgs::Float64>(settings.tilt_command, 1);
  timer = node.createSteadyTimer(::ros::WallDuration(kPublishEvery_s),
                                 [this](const ::ros::SteadyTimerEvent&) { publish(); });
  spinner = std::make_unique<::ros::AsyncSpinner>(1, &queue);
  spinner->start();
}

template <class Message>
void RosRobot::Parts::hear(const std::string& topic) {
  boost::function<void(const boost::shared_ptr<const Message>&)> take =
      [this](const auto& message) {
        const std::lock_guard lock(mutex);
        inbox.take(*message, clock.now());
      };
  subscribers.push_back(node.subscribe<Message>(topic, 4, take));
}

void RosRobot::Parts::subscribe_eye(Eye eye, const std::string& pictures, const std::string& info) {
  const ::ros::TransportHints at_once = ::ros::TransportHints().tcpNoDelay();
  if (is_compressed(pictures)) {
    boost::function<void(const sensor_msgs::CompressedImageConstPtr&)> take =
        [this, eye](const auto& message) {
          const std::lock_guard lock(mutex);
          inbox.take(eye, *message, clock.now());
        };
    subscribers.push_back(
        node.subscribe<sensor_msgs::CompressedImage>(pictures, 2, take, nullptr, at_once));
  } else {
    boost::function<void(const sensor_msgs::ImageConstPtr&)> take = [this,
                                                                     eye](const auto& message) {
      const std::lock_guard lock(mutex);
      inbox.take(eye, *message, clock.now());
    };
    subscribers.push_back(node.subscribe<sensor_msgs::Image>(pictures, 2, take, nullptr, at_once));
  }
  boost::function<void(const sensor_msgs::CameraInfoConstPtr&)> take_info =
      [this, eye](const auto& message) {
        const std::lock_guard lock(mutex);
        inbox.take(eye, *message);
      };
  subscribers.push_back(node.subscribe<sensor_msgs::CameraInfo>(info, 2, take_info));
}

void RosRobot::Parts::subscribe() {
  subscribe_eye(Eye::left, settings.left_image, settings.left_info);
  subscribe_eye(Eye::right, settings.right_image, settings.right_info);
  hear<nav_msgs::Odometry>(settings.odometry);
  hear<sensor_msgs::LaserScan>(settings.scan);
  hear<sensor_msgs::PointCloud>(settings.sonar);
  hear<sensor_msgs::JointState>(settings.joints);
}

std::string RosRobot::Parts::hold_reason(TimePoint now) const {
  const Duration stale = from_seconds(settings.stale_s);
  const auto silent = [&](const std::optional<TimePoint>& came) {
    return !came || now - *came > stale;
  };
  if (silent(inbox.odometry_came())) return "no odometry";
  if (silent(inbox.pictures_came())) return "no pictures";
  if (inbox.laser_came() && silent(inbox.laser_came())) return "the laser is silent";
  if (!lease.at(now)) return "no fresh command";
  return {};
}

/// The only place from which `cmd_vel` is published while the robot drives.
void RosRobot::Parts::publish() {
  const std::lock_guard lock(mutex);
  if (!drives) return;
  const TimePoint now = clock.now();
  const auto command = lease.at(now);
  const bool holds = !hold_reason(now).empty();
  cmd_vel.publish(twist_of(holds ? MotorCommand{} : *command));
  if (!command) return;
  std_msgs::Float64 angle;
  angle.data = command->pan_rad;
  pan.publish(angle);
  angle.data = command->tilt_rad;
  tilt.publish(angle);
}

std::string RosRobot::Parts::missing() const {
  const std::lock_guard lock(mutex);
  if (!inbox.odometry_came()) return "no odometry came on " + node.resolveName(settings.odometry);
  if (inbox.pictures_came()) return {};
  std::string text = "no picture pair came on " + node.resolveName(settings.left_image) + " and " +
                     node.resolveName(settings.right_image);
  if (!inbox.camera_known())
    text += ", no usable CameraInfo on " + node.resolveName(settings.left_info) + " and " +
            node.resolveName(settings.right_info);
  if (!inbox.trouble().empty()) text += " (" + inbox.trouble() + ")";
  return text;
}

RosRobot::RosRobot(const RosSettings& settings, const RobotDescription& description,
                   Duration patience) {
  join_ros("striate");
  parts_ = std::make_unique<Parts>(settings, description);
  const TimePoint end = parts_->clock.now() + patience;
  for (std::string missing = parts_->missing(); !missing.empty(); missing = parts_->missing()) {
    if (parts_->clock.now() > end) throw std::runtime_error("the robot cannot be used: " + missing);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  parts_->next_cycle = parts_->clock.now();
}

RosRobot::~RosRobot() {
  if (!parts_) return;
  stop();
  parts_->timer.stop();
  if (parts_->drives) std::this_thread::sleep_for(kGoodBye);
  parts_->spinner->stop();
}

const RobotDescription& RosRobot::description() const {
  return parts_->description;
}

const Clock& RosRobot::clock() const {
  return parts_->clock;
}

bool RosRobot::sense(Senses& senses) {
  Parts& p = *parts_;
  p.next_cycle = std::max(p.next_cycle + p.description.cycle, p.clock.now());
  std::this_thread::sleep_for(p.next_cycle - p.clock.now());
  if (!::ros::ok()) return false;
  const std::lock_guard lock(p.mutex);
  senses = p.inbox.senses();
  senses.now = p.clock.now();
  if (senses.now - senses.sonar.stamp > kSonarFresh) senses.sonar.readings.clear();
  const Duration lost = from_seconds(p.settings.lost_s);
  if (senses.now - *p.inbox.odometry_came() > lost) {
    throw std::runtime_error("the robot is lost: no odometry on " + p.settings.odometry);
  }
  if (senses.now - *p.inbox.pictures_came() > lost) {
    throw std::runtime_error("the robot is lost: no pictures on " + p.settings.left_image);
  }
  return true;
}

void RosRobot::send(const MotorCommand& command) {
  {
    const std::lock_guard lock(parts_->mutex);
    parts_->lease.give(command, parts_->clock.now());
    parts_->drives = true;
  }
  parts_->publish();
}

void RosRobot::stop() noexcept {
  try {
    {
      const std::lock_guard lock(parts_->mutex);
      parts_->lease.end();
    }
    parts_->publish();
  } catch (...) {  // what cannot be said is left to the robot's own watchdog
  }
}

std::string RosRobot::hold() const {
  const std::lock_guard lock(parts_->mutex);
  return parts_->hold_reason(parts_->clock.now());
}

}  // namespace striate::ros1
