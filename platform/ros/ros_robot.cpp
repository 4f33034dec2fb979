#include "striate/platform/ros/ros_robot.hpp"

#include <ros/callback_queue.h>
#include <ros/spinner.h>
#include <std_msgs/Float64.h>

#include <algorithm>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <thread>

#include "striate/base/pioneer_devices.hpp"
#include "striate/platform/ros/cmd_vel_keeper.hpp"
#include "striate/platform/ros/command_lease.hpp"
#include "striate/platform/ros/gap_watch.hpp"
#include "striate/platform/ros/hold_reason.hpp"
#include "striate/platform/ros/mailbox.hpp"
#include "striate/platform/ros/master_watch.hpp"
#include "striate/platform/ros/motion_echo.hpp"
#include "striate/platform/ros/node.hpp"

namespace striate::ros {
namespace {

constexpr double kPublishEvery_s = 0.05;  ///< odometry and tf at 20 Hz, twice a cycle
/// Two leases: to hear, to begin and to tell of it (ours)
constexpr Duration kFollowsWithin = std::chrono::seconds(1);
/// Four questions that it did not answer.
constexpr Duration kMasterSilent = std::chrono::seconds(1);
/// How long the last zero may take to the robot.
constexpr auto kGoodBye = std::chrono::milliseconds(100);

}  // namespace

struct RosRobot::Parts {
  Parts(const RosSettings& given, const RobotDescription& description, CmdVelKeeper& keeper);
  void publish();
  /// In ROS's thread, which an error must not end.
  void publish_if_it_goes() noexcept {
    try {
      publish();
    } catch (...) {  // nothing goes out: the robot's own deadline on cmd_vel stops it
    }
  }
  [[nodiscard]] std::string hold_reason(TimePoint now) const;
  [[nodiscard]] std::string missing() const;

  RosSettings settings;
  RobotDescription description;
  TimePoint next_cycle;
  Mailbox mail;  ///< its mutex guards the five below, too
  CommandLease lease;
  GapWatch gaps;
  MotionEcho echo{kFollowsWithin};
  std::optional<TimePoint> seen_at;  ///< the newest image that was handed out
  bool drives = false;  ///< something was sent: from now on silence would not be a stop
  MasterWatch master;
  CmdVelKeeper& keeper;

  ::ros::CallbackQueue queue;
  ::ros::NodeHandle node;
  std::vector<::ros::Subscriber> subscribers;
  ::ros::Publisher cmd_vel;
  ::ros::Publisher pan;
  ::ros::Publisher tilt;
  ::ros::SteadyTimer timer;
  std::unique_ptr<::ros::AsyncSpinner> spinner;
};

RosRobot::Parts::Parts(const RosSettings& given, const RobotDescription& body, CmdVelKeeper& keeps)
    : settings(given),
      description(body),
      mail(given),
      lease(from_seconds(given.lease_s)),
      gaps(from_seconds(given.longest_gap_s), from_seconds(given.command_gap_s)),
      keeper(keeps) {
  node.setCallbackQueue(&queue);
  subscribers = subscribe(node, settings, mail);
  cmd_vel = node.advertise<geometry_msgs::Twist>(settings.cmd_vel, 1);
  pan = node.advertise<std_msgs::Float64>(settings.pan_command, 1);
  tilt = node.advertise<std_msgs::Float64>(settings.tilt_command, 1);
  timer = node.createSteadyTimer(::ros::WallDuration(kPublishEvery_s),
                                 [this](const ::ros::SteadyTimerEvent&) { publish_if_it_goes(); });
  spinner = std::make_unique<::ros::AsyncSpinner>(1, &queue);
  spinner->start();
}

std::string RosRobot::Parts::hold_reason(TimePoint now) const {
  if (gaps.holds()) return "the program stood still";
  if (echo.holds()) return "the robot does not follow its commands, or is late";
  if (master.silent_for() > kMasterSilent) return "the ROS master is gone";
  std::string reason = stale_sense(mail.inbox, from_seconds(settings.stale_s), now);
  if (!reason.empty()) return reason;
  if (!lease.at(now)) return "no fresh command";
  if (seen_at && now - *seen_at > from_seconds(settings.seen_old_s)) {
    return "what it has seen is too old";
  }
  if (cmd_vel.getNumSubscribers() == 0) return "nobody listens on " + cmd_vel.getTopic();
  return {};
}

/// The only place from which `cmd_vel` is published while the robot drives.
void RosRobot::Parts::publish() {
  const std::lock_guard lock(mail.mutex);
  if (!drives) return;
  const TimePoint now = mail.clock.now();
  gaps.look(now);
  const auto command = lease.at(now);
  const bool holds = !hold_reason(now).empty();
  const MotorCommand sent = holds ? MotorCommand{} : *command;
  echo.felt(mail.inbox.senses().odometry);
  echo.commanded(sent, now);
  cmd_vel.publish(twist_of(sent));
  keeper.hear(sent.forward_m_s != 0.0 || sent.turn_rad_s != 0.0);
  if (!command) return;
  std_msgs::Float64 angle;
  angle.data = command->pan_rad;
  pan.publish(angle);
  angle.data = command->tilt_rad;
  tilt.publish(angle);
}

std::string RosRobot::Parts::missing() const {
  const std::lock_guard lock(mail.mutex);
  if (!mail.inbox.odometry_came())
    return "no odometry came on " + node.resolveName(settings.odometry);
  if (mail.inbox.images_came()) return {};
  std::string text = "no image pair came on " + node.resolveName(settings.left_image) + " and " +
                     node.resolveName(settings.right_image);
  if (!mail.inbox.camera_known())
    text += ", no usable CameraInfo on " + node.resolveName(settings.left_info) + " and " +
            node.resolveName(settings.right_info);
  if (!mail.inbox.trouble().empty()) text += " (" + mail.inbox.trouble() + ")";
  return text;
}

RosRobot::RosRobot(const RosSettings& settings, const RobotDescription& description,
                   Duration patience)
    : keeper_(std::make_unique<CmdVelKeeper>(settings.cmd_vel)) {
  join_ros("striate");
  parts_ = std::make_unique<Parts>(settings, description, *keeper_);
  const TimePoint end = parts_->mail.clock.now() + patience;
  for (std::string missing = parts_->missing(); !missing.empty(); missing = parts_->missing()) {
    if (parts_->mail.clock.now() > end)
      throw std::runtime_error("the robot cannot be used: " + missing);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  parts_->next_cycle = parts_->mail.clock.now();
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
  return parts_->mail.clock;
}

bool RosRobot::sense(Senses& senses) {
  Parts& p = *parts_;
  p.next_cycle = std::max(p.next_cycle + p.description.cycle, p.mail.clock.now());
  std::this_thread::sleep_for(p.next_cycle - p.mail.clock.now());
  if (!::ros::ok()) return false;
  const std::lock_guard lock(p.mail.mutex);
  senses = p.mail.inbox.senses();
  senses.now = p.mail.clock.now();
  p.seen_at = senses.stereo.stamp;
  if (senses.now - senses.sonar.stamp > kSonarFresh) senses.sonar.readings.clear();
  const Duration lost = from_seconds(p.settings.lost_s);
  if (senses.now - *p.mail.inbox.odometry_came() > lost) {
    throw std::runtime_error("the robot is lost: no odometry on " + p.settings.odometry);
  }
  if (senses.now - *p.mail.inbox.images_came() > lost) {
    throw std::runtime_error("the robot is lost: no images on " + p.settings.left_image);
  }
  if (p.master.silent_for() > std::max(lost, kMasterSilent)) {
    throw std::runtime_error("the robot is lost: the ROS master is gone");
  }
  return true;
}

void RosRobot::send(const MotorCommand& command) {
  {
    const std::lock_guard lock(parts_->mail.mutex);
    const TimePoint now = parts_->mail.clock.now();
    parts_->gaps.commanded(command, now);
    parts_->lease.give(command, now);
    parts_->drives = true;
  }
  parts_->publish();
}

void RosRobot::stop() noexcept {
  try {
    {
      const std::lock_guard lock(parts_->mail.mutex);
      parts_->lease.end();
      parts_->gaps.commanded({}, parts_->mail.clock.now());
    }
    parts_->publish();
  } catch (...) {  // what cannot be said is left to the robot's own watchdog
  }
}

void RosRobot::reset() {
  const std::lock_guard lock(parts_->mail.mutex);
  parts_->gaps.reset();
  parts_->echo.reset();
  parts_->lease.end();  // what was decided before does not drive
}

bool RosRobot::waits_for_reset() const {
  const std::lock_guard lock(parts_->mail.mutex);
  return parts_->gaps.holds() || parts_->echo.holds();
}

std::string RosRobot::hold() const {
  const std::lock_guard lock(parts_->mail.mutex);
  return parts_->hold_reason(parts_->mail.clock.now());
}

}  // namespace striate::ros
