#include "striate/platform/rosbridge/rosbridge_robot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>

#include "striate/base/steady_clock.hpp"
#include "striate/platform/remote/command_gate.hpp"
#include "striate/platform/rosbridge/bridge_client.hpp"
#include "striate/platform/rosbridge/check_settings.hpp"
#include "striate/platform/rosbridge/message_reader.hpp"
#include "striate/platform/rosbridge/operations.hpp"
#include "striate/platform/rosbridge/twist_keeper.hpp"

namespace striate::rosbridge {
namespace {

/// Ten pings that it did not answer; as the silence of a ROS master
constexpr Duration kServerSilent = std::chrono::seconds(1);
/// How long the last zero may take through the server to the robot, as in RosRobot
constexpr auto kGoodByeTakes = std::chrono::milliseconds(100);
constexpr auto kLookEvery = std::chrono::milliseconds(20);  // while it is waited for (by hand)
constexpr const char* kServerHint =
    "\n  hint: on the robot, roslaunch rosbridge_server rosbridge_websocket.launch (ROS 2: ros2 "
    "launch rosbridge_server rosbridge_websocket_launch.xml)";

}  // namespace

struct RosbridgeRobot::Parts {
  Parts(const BridgeSettings& given, const BridgeAddress& address, const RobotDescription& body,
        const MakeCamera& make_camera, remote::ZeroKeeper& keeps);
  [[nodiscard]] BridgeClient::Hears hears();
  void hear(std::string_view message);
  void publish();
  void look();
  [[nodiscard]] bool drives() const {
    const std::lock_guard lock(mutex);
    return gate.drives();
  }
  [[nodiscard]] std::vector<std::string> last_words() const;
  [[nodiscard]] std::string line_trouble() const;
  [[nodiscard]] std::string missing() const;
  [[nodiscard]] std::string with_trouble(std::string what) const;
  void throw_if_lost(TimePoint now) const;

  BridgeSettings settings;
  std::string url;
  RobotDescription description;
  remote::ZeroKeeper& keeper;
  SteadyClock clock;
  TimePoint next_cycle;
  OwnCamera camera;      ///< empty: images come as topics
  MessageReader reader;  ///< the client's thread alone

  mutable std::mutex mutex;  ///< guards the two below
  remote::Inbox inbox;
  remote::CommandGate gate;

  BridgeClient client;  ///< last: its thread uses all the others
};

RosbridgeRobot::Parts::Parts(const BridgeSettings& given, const BridgeAddress& address,
                             const RobotDescription& body, const MakeCamera& make_camera,
                             remote::ZeroKeeper& keeps)
    : settings(given),
      url(address.url),
      description(body),
      keeper(keeps),
      camera(make_camera ? make_camera(clock) : OwnCamera{}),
      reader(given),
      inbox(given),
      gate(given),
      client(address, static_cast<std::size_t>(given.most_message_mb) * 1'000'000, hears()) {}

BridgeClient::Hears RosbridgeRobot::Parts::hears() {
  return {.greetings = [this] { return greetings(settings, !camera.newest); },
          .message = [this](std::string_view message) { hear(message); },
          .broke =
              [this] {
                const std::lock_guard lock(mutex);
                gate.line_broke();
              },
          .tick =
              [this] {
                look();
                publish();
              }};
}

/// What takes long, to parse and to decode, does not hold up the cycle.
void RosbridgeRobot::Parts::hear(std::string_view message) {
  const TimePoint arrived = clock.now();
  Heard heard = reader.read(message);
  const std::lock_guard lock(mutex);
  take(std::move(heard), arrived, inbox);
}

void RosbridgeRobot::Parts::look() {
  if (!camera.newest) return;
  StereoFrame frame = camera.newest();
  const std::lock_guard lock(mutex);
  if (frame.left.empty() || frame.stamp == inbox.senses().stereo.stamp) return;
  inbox.take_frame(std::move(frame), clock.now());
}

/// The only place from which `cmd_vel` is published while the robot drives.
void RosbridgeRobot::Parts::publish() {
  const std::lock_guard lock(mutex);
  const TimePoint now = clock.now();
  const auto told = gate.tell(inbox, line_trouble(), now);
  if (!told) return;
  client.say_newest(publish_twist(settings, *told, inbox.sender_ns(now)));
  keeper.hear(told->forward_m_s != 0.0 || told->turn_rad_s != 0.0);
}

/// A zero where anything was driven, and then that nobody listens any more.
std::vector<std::string> RosbridgeRobot::Parts::last_words() const {
  std::vector<std::string> words = good_byes(settings, !camera.newest);
  const std::lock_guard lock(mutex);
  if (gate.drives()) {
    words.insert(words.begin(), publish_twist(settings, {}, inbox.sender_ns(clock.now())));
  }
  return words;
}

std::string RosbridgeRobot::Parts::line_trouble() const {
  if (!client.is_open()) return fmt::format("no line to {}: {}", url, client.trouble());
  if (client.silent_for() > kServerSilent) return fmt::format("{} does not answer", url);
  return {};
}

/// With what the camera says, what the newest message was refused for, or why the line broke.
/// Under the mutex.
std::string RosbridgeRobot::Parts::with_trouble(std::string what) const {
  std::string trouble = camera.trouble ? camera.trouble() : std::string();
  if (trouble.empty()) trouble = inbox.trouble();
  if (trouble.empty() && client.is_open()) trouble = client.trouble();
  if (!trouble.empty()) what += " (" + trouble + ")";
  return what;
}

std::string RosbridgeRobot::Parts::missing() const {
  const std::lock_guard lock(mutex);
  if (!client.is_open() && !client.trouble().empty()) {
    return fmt::format("no rosbridge server at {}: {}{}", url, client.trouble(), kServerHint);
  }
  if (!inbox.odometry_came()) {
    return with_trouble(
        fmt::format("no odometry came on {} from {}", settings.topics.odometry, url));
  }
  if (inbox.images_came()) return {};
  if (camera.newest) return with_trouble("no images came from its camera");
  std::string text = fmt::format("no image pair came on {} and {}", settings.topics.left_image,
                                 settings.topics.right_image);
  if (!inbox.camera_known()) {
    text += fmt::format(", no usable CameraInfo on {} and {}", settings.topics.left_info,
                        settings.topics.right_info);
  }
  return with_trouble(std::move(text));
}

void RosbridgeRobot::Parts::throw_if_lost(TimePoint now) const {
  const Duration lost = from_seconds(settings.lost_s);
  const auto lose = [this](const std::string& why) {
    throw std::runtime_error("the robot is lost: " + with_trouble(why));
  };
  const std::string line = line_trouble();
  const bool wheels = now - *inbox.odometry_came() > lost;
  const bool eyes = now - *inbox.images_came() > lost;
  const bool server = client.silent_for() > std::max(lost, kServerSilent);
  if ((wheels || eyes || server) && !line.empty()) lose(line);
  if (wheels) lose("no odometry on " + settings.topics.odometry);
  if (eyes) lose(camera.newest ? "no images" : "no images on " + settings.topics.left_image);
}

RosbridgeRobot::RosbridgeRobot(const BridgeSettings& settings, const RobotDescription& description,
                               const MakeCamera& camera, Duration patience) {
  const BridgeAddress address = check_settings(settings);
  keeper_ = make_twist_keeper(settings);
  parts_ = std::make_unique<Parts>(settings, address, description, camera, *keeper_);
  const TimePoint end = parts_->clock.now() + patience;
  for (std::string missing = parts_->missing(); !missing.empty(); missing = parts_->missing()) {
    if (parts_->clock.now() > end) {
      throw std::runtime_error("the robot cannot be used: " + missing);
    }
    std::this_thread::sleep_for(kLookEvery);
  }
  parts_->next_cycle = parts_->clock.now();
}

RosbridgeRobot::~RosbridgeRobot() {
  if (!parts_) return;
  stop();
  try {
    if (parts_->drives()) std::this_thread::sleep_for(kGoodByeTakes);
    parts_->client.end(parts_->last_words());
  } catch (...) {  // no memory for a good-bye: the keeper and the robot's own deadline are left
  }
}

const RobotDescription& RosbridgeRobot::description() const {
  return parts_->description;
}

const Clock& RosbridgeRobot::clock() const {
  return parts_->clock;
}

bool RosbridgeRobot::sense(Senses& senses) {
  Parts& p = *parts_;
  p.next_cycle = std::max(p.next_cycle + p.description.cycle, p.clock.now());
  std::this_thread::sleep_for(p.next_cycle - p.clock.now());
  const std::lock_guard lock(p.mutex);
  senses = p.inbox.senses();
  senses.now = p.clock.now();
  p.gate.seen(senses.stereo.stamp);
  p.throw_if_lost(senses.now);
  return true;
}

void RosbridgeRobot::send(const MotorCommand& command) {
  {
    const std::lock_guard lock(parts_->mutex);
    parts_->gate.command(command, parts_->clock.now());
  }
  parts_->publish();
}

void RosbridgeRobot::stop() noexcept {
  try {
    {
      const std::lock_guard lock(parts_->mutex);
      parts_->gate.end(parts_->clock.now());
    }
    parts_->publish();
  } catch (...) {  // what cannot be said is left to the keeper and the robot's own deadline
  }
}

void RosbridgeRobot::reset() {
  const std::lock_guard lock(parts_->mutex);
  parts_->gate.reset();
}

bool RosbridgeRobot::waits_for_reset() const {
  const std::lock_guard lock(parts_->mutex);
  return parts_->gate.waits_for_reset();
}

std::string RosbridgeRobot::hold() const {
  const std::lock_guard lock(parts_->mutex);
  return parts_->gate.hold_reason(parts_->inbox, parts_->line_trouble(), parts_->clock.now());
}

}  // namespace striate::rosbridge
