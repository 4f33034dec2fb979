#include "striate/platform/ros/bag_robot.hpp"

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <stdexcept>
#include <utility>

#include "striate/base/user_error.hpp"
#include "striate/platform/ros/bag_topics.hpp"
#include "striate/platform/ros/inbox.hpp"

namespace striate::ros {
namespace {

class BagClock final : public Clock {
 public:
  [[nodiscard]] TimePoint now() const override { return now_; }
  void set(TimePoint now) { now_ = now; }

 private:
  TimePoint now_;
};

/// Opens it. What the library throws for a file that is no bag differs with the damage.
std::unique_ptr<rosbag::Bag> open(const std::string& file) {
  try {
    return std::make_unique<rosbag::Bag>(file, rosbag::bagmode::Read);
  } catch (const std::exception& error) {
    throw UserError(file + ": is no ROS bag that can be read (" + error.what() + ")");
  }
}

BagTopics topics_of(rosbag::Bag& bag) {
  BagTopics topics;
  rosbag::View all(bag);
  for (const rosbag::ConnectionInfo* one : all.getConnections()) topics[one->topic] = one->datatype;
  return topics;
}

/// Errors name the file.
RosSettings topics_to_read(const std::string& file, const BagTopics& topics,
                           const RosSettings& given, const std::string& camera) {
  try {
    return find_topics(topics, given, camera);
  } catch (const UserError& error) {
    throw UserError(file + ": " + error.what());
  }
}

}  // namespace

struct BagRobot::Parts {
  Parts(const std::string& file, const RosSettings& given, const RobotDescription& body,
        const std::string& camera);
  void take(const rosbag::MessageInstance& message);
  template <class Message>
  bool take_eyes(const rosbag::MessageInstance& message, const std::string& left,
                 const std::string& right);
  template <class Message>
  bool take_other(const rosbag::MessageInstance& message);
  /// CameraInfo may come after the first images, or once only: it is read beforehand.
  void read_camera();

  std::string file;
  std::unique_ptr<rosbag::Bag> bag;
  BagTopics topics;
  RosSettings settings;
  RobotDescription description;
  Inbox inbox;
  BagClock clock;
  rosbag::View view;
  rosbag::View::iterator next;
  ::ros::Time begin;
};

BagRobot::Parts::Parts(const std::string& name, const RosSettings& given,
                       const RobotDescription& body, const std::string& camera)
    : file(name),
      bag(open(name)),
      topics(topics_of(*bag)),
      settings(topics_to_read(name, topics, given, camera)),
      description(body),
      inbox(settings),
      view(*bag, rosbag::TopicQuery(std::vector<std::string>{
                     settings.left_image, settings.right_image, settings.odometry, settings.scan,
                     settings.sonar, settings.joints})),
      next(view.begin()),
      begin(view.getBeginTime()) {
  read_camera();
}

void BagRobot::Parts::read_camera() {
  const auto is_there = [this](const std::string& topic) { return topics.count(topic) > 0; };
  if (!is_there(settings.left_image) || !is_there(settings.right_image)) {
    throw UserError(file + ": has no stereo images; its topics:" + list_of(topics) +
                    "\n  hint: the settings ros.left_image and ros.right_image name them");
  }
  rosbag::View infos(
      *bag, rosbag::TopicQuery(std::vector<std::string>{settings.left_info, settings.right_info}));
  for (const rosbag::MessageInstance& message : infos) {
    if (const auto info = message.instantiate<sensor_msgs::CameraInfo>()) {
      inbox.take(message.getTopic() == settings.left_info ? Eye::left : Eye::right, *info);
    }
    if (inbox.camera_known()) return;
  }
  if (inbox.camera_known()) return;
  throw UserError(file + ": does not tell the camera's focal length and baseline" +
                  (inbox.camera_swapped() ? ": by CameraInfo left and right are swapped" : "") +
                  "; its topics:" + list_of(topics) +
                  "\n  hint: the settings ros.focal and ros.baseline give them");
}

template <class Message>
bool BagRobot::Parts::take_eyes(const rosbag::MessageInstance& message, const std::string& left,
                                const std::string& right) {
  const auto content = message.instantiate<Message>();
  if (!content) return false;
  if (message.getTopic() == left) inbox.take(Eye::left, *content, clock.now());
  if (message.getTopic() == right) inbox.take(Eye::right, *content, clock.now());
  return true;
}

template <class Message>
bool BagRobot::Parts::take_other(const rosbag::MessageInstance& message) {
  const auto content = message.instantiate<Message>();
  if (!content) return false;
  inbox.take(*content, clock.now());
  return true;
}

void BagRobot::Parts::take(const rosbag::MessageInstance& message) {
  clock.set(TimePoint(Duration((message.getTime() - begin).toNSec())));
  (void)(take_eyes<sensor_msgs::Image>(message, settings.left_image, settings.right_image) ||
         take_eyes<sensor_msgs::CompressedImage>(message, settings.left_image,
                                                 settings.right_image) ||
         take_other<nav_msgs::Odometry>(message) || take_other<sensor_msgs::LaserScan>(message) ||
         take_other<sensor_msgs::PointCloud>(message) ||
         take_other<sensor_msgs::JointState>(message));
}

BagRobot::BagRobot(const std::string& file, const RosSettings& settings,
                   const RobotDescription& description, const std::string& camera)
    : parts_(std::make_unique<Parts>(file, settings, description, camera)) {}

BagRobot::~BagRobot() = default;

const RosSettings& BagRobot::settings() const {
  return parts_->settings;
}

const RobotDescription& BagRobot::description() const {
  return parts_->description;
}

const Clock& BagRobot::clock() const {
  return parts_->clock;
}

bool BagRobot::sense(Senses& senses) {
  Parts& p = *parts_;
  const TimePoint seen = p.inbox.senses().stereo.stamp;
  const bool none_yet = !p.inbox.images_came();
  try {
    for (; p.next != p.view.end(); ++p.next) {
      p.take(*p.next);
      const bool is_new =
          p.inbox.images_came() && (none_yet || p.inbox.senses().stereo.stamp != seen);
      if (!is_new) continue;
      ++p.next;
      senses = p.inbox.senses();
      senses.now = p.clock.now();
      return true;
    }
  } catch (const rosbag::BagException& error) {
    throw std::runtime_error(p.file + ": the bag is damaged: " + error.what());
  }
  if (none_yet && !p.inbox.trouble().empty()) {
    throw std::runtime_error(p.file + ": no image pair could be used: " + p.inbox.trouble());
  }
  return false;
}

}  // namespace striate::ros
