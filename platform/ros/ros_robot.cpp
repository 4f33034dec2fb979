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
#include "striate/platform/remote/command_gate.hpp"
#include "striate/platform/ros/cmd_vel_keeper.hpp"
#include "striate/platform/ros/mailbox.hpp"
#include "striate/platform/ros/master_watch.hpp"
#include "striate/platform/ros/node.hpp"

namespace striate::ros {
namespace {

constexpr double kPublishEvery_s = 0.05;  ///< odometry and tf at 20 Hz, twice a cycle
/// Four questions that it did not answer.
constexpr Duration kMasterSilent = std::chrono::seconds(1);
/// How long the last zero may take to the robot.
constexpr auto kGoodBye = std::chrono::milliseconds(100);

}  // namespace

struct RosRobot::Parts {
  Parts(const RosSettings& given, const RobotDescription& description, remote::ZeroKeeper& keeper);
  void publish();
  /// In ROS's thread, which an error must not end.
  void publish_if_it_goes() noexcept {
    try {
      publish();
    } catch (...) {  // nothing goes out: the robot's own deadline on cmd_vel stops it
    }
  }
  /// Why nothing can be said to anybody, or "".
  [[nodiscard]] std::string master_trouble() const;
  /// The same, or why nobody hears it.
  [[nodiscard]] std::string line_trouble() const;
  [[nodiscard]] std::string hold() const;
  [[nodiscard]] std::string missing() const;

  RosSettings settings;
  RobotDescription description;
  TimePoint next_cycle;
  Mailbox mail;  ///< its mutex guards the gate, too
  remote::CommandGate gate;
  MasterWatch master;
  remote::ZeroKeeper& keeper;

  ::ros::CallbackQueue queue;
  ::ros::NodeHandle node;
  std::vector<::ros::Subscriber> subscribers;
  ::ros::Publisher cmd_vel;
  ::ros::Publisher pan;
  ::ros::Publisher tilt;
  ::ros::SteadyTimer timer;
  std::unique_ptr<::ros::AsyncSpinner> spinner;
};

RosRobot::Parts::Parts(const RosSettings& given, const RobotDescription& body,
                       remote::ZeroKeeper& keeps)
    : settings(given), description(body), mail(given), gate(given), keeper(keeps) {
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

std::string RosRobot::Parts::master_trouble() const {
  return master.silent_for() > kMasterSilent ? "the ROS master is gone" : "";
}

std::string RosRobot::Parts::line_trouble() const {
  std::string trouble = master_trouble();
  if (trouble.empty() && cmd_vel.getNumSubscribers() == 0) {
    trouble = "nobody listens on " + cmd_vel.getTopic();
  }
  return trouble;
}

/// Who does not listen is told last: a robot that went silent hears nothing either.
std::string RosRobot::Parts::hold() const {
  std::string reason = gate.hold_reason(mail.inbox, master_trouble(), mail.clock.now());
  return reason.empty() ? line_trouble() : reason;
}

/// The only place from which `cmd_vel` is published while the robot drives.
void RosRobot::Parts::publish() {
  const std::lock_guard lock(mail.mutex);
  const TimePoint now = mail.clock.now();
  const auto told = gate.tell(mail.inbox, line_trouble(), now);
  if (!told) return;
  cmd_vel.publish(twist_of(*told));
  keeper.hear(told->forward_m_s != 0.0 || told->turn_rad_s != 0.0);
  const auto command = gate.fresh(now);
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
    : keeper_(make_cmd_vel_keeper(settings.cmd_vel)) {
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
  if (parts_->gate.drives()) std::this_thread::sleep_for(kGoodBye);
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
  p.gate.seen(senses.stereo.stamp);
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
    parts_->gate.command(command, parts_->mail.clock.now());
  }
  parts_->publish();
}

void RosRobot::stop() noexcept {
  try {
    {
      const std::lock_guard lock(parts_->mail.mutex);
      parts_->gate.end(parts_->mail.clock.now());
    }
    parts_->publish();
  } catch (...) {  // what cannot be said is left to the robot's own watchdog
  }
}

void RosRobot::reset() {
  const std::lock_guard lock(parts_->mail.mutex);
  parts_->gate.reset();
}

bool RosRobot::waits_for_reset() const {
  const std::lock_guard lock(parts_->mail.mutex);
  return parts_->gate.waits_for_reset();
}

std::string RosRobot::hold() const {
  const std::lock_guard lock(parts_->mail.mutex);
  return parts_->hold();
}

}  // namespace striate::ros
