#include "striate/platform/served/robot_server.hpp"

#include <boost/asio/post.hpp>
#include <deque>
#include <optional>
#include <thread>

#include "striate/base/steady_clock.hpp"
#include "striate/platform/pioneer/camera/image_stream.hpp"
#include "striate/platform/served/camera_feed.hpp"
#include "striate/platform/served/served_line.hpp"

namespace striate::served {
namespace {

namespace asio = boost::asio;
using Steady = std::chrono::steady_clock;

/// By which images are as old as they are, also where the machine slept in between.
TimePoint machine_time() {
  return TimePoint(SteadyClock::since_boot());
}

/// Later than this the clock is set anew instead of catching up in a burst.
constexpr auto kMostLate = std::chrono::milliseconds(200);
/// Two images of the largest kind.
constexpr std::size_t kMostImages = std::size_t{64} << 20U;
constexpr int kTurretPort = 1;  // added to the base's port
constexpr int kLaserPort = 2;   // added to the base's port
constexpr int kCameraPort = 3;  // added to the base's port

}  // namespace

struct RobotServer::Parts {
  Parts(ServedPioneer& robot_in, simulator::ImageSource* pictures, const ServeSettings& settings_in,
        Log log_in);

  [[nodiscard]] std::unique_ptr<ServedLine> line(const std::string& name, int port_after_base,
                                                 ServedLine::Events events);
  void greet();
  void serve_base();
  void serve_devices();
  void serve_images();
  void answer_camera(ByteView bytes);
  void tend_lines();
  void watch_the_judge();
  void one_step();
  void tell();
  [[nodiscard]] double connected_s() const { return to_seconds(robot.now() - connected_at); }
  [[nodiscard]] bool due(double fault_at_s) const {
    return base->has_client() && fault_at_s > 0.0 && connected_s() >= fault_at_s;
  }

  ServedPioneer& robot;
  ServeSettings settings;
  Log log;
  asio::io_context io{1};
  ServedUrls urls;

  TimePoint connected_at;
  bool was_stopped = false;
  std::size_t collisions_told = 0;
  bool goal_told = false;
  std::optional<FaultyWay> to_robot;
  std::optional<FaultyWay> to_client;
  struct Packet {
    Bytes bytes;
    TimePoint exposed_at;
  };
  std::deque<Packet> images_under_way;
  std::uint32_t exposures = 0;
  pioneer::image_stream::QuestionReader camera_questions;
  bool camera_tells_time = false;  ///< its client has asked

  mutable std::mutex mutex;
  ServedState state;

  std::unique_ptr<ServedLine> base;
  std::unique_ptr<ServedLine> turret;
  std::unique_ptr<ServedLine> laser;
  std::unique_ptr<ServedLine> camera;
  std::optional<CameraFeed> feed;  // last: its thread uses the above
};

RobotServer::Parts::Parts(ServedPioneer& robot_in, simulator::ImageSource* pictures,
                          const ServeSettings& settings_in, Log log_in)
    : robot(robot_in), settings(settings_in), log(std::move(log_in)) {
  const auto to_base = [this](ByteView bytes) { to_robot->put(bytes, connected_s()); };
  // A base streams to whoever has opened a session, but such a client must speak, too.
  base = line("base", 0,
              {[this] { greet(); }, to_base, log,
               [this] {
                 return Dealings{robot.firmware().counters().packets, false};
               }});
  turret = line("turret", kTurretPort,
                {[] {}, [this](ByteView bytes) { robot.servos().receive(bytes); }, log,
                 [this] {
                   return Dealings{robot.servos().understood(), false};
                 }});
  laser = line("laser", kLaserPort,
               {[this] { robot.laser().reboot(); },
                [this](ByteView bytes) { robot.laser().receive(bytes); }, log,
                [this] {
                  return Dealings{robot.laser().understood(), robot.laser().streams()};
                }});
  urls = {base->url(), turret->url(), laser->url(), {}};
  if (pictures == nullptr) return;
  const auto new_client = [this] {
    camera_questions.clear();
    camera_tells_time = false;
  };
  camera = line("camera", kCameraPort,
                {new_client, [this](ByteView bytes) { answer_camera(bytes); }, log,
                 [] {
                   return Dealings{0, true};
                 }});
  urls.camera = camera->url();
  feed.emplace(*pictures, [this](Bytes bytes, TimePoint exposed_at) {
    asio::post(io, [this, packet = Packet{std::move(bytes), exposed_at}]() mutable {
      images_under_way.push_back(std::move(packet));
    });
  });
}

std::unique_ptr<ServedLine> RobotServer::Parts::line(const std::string& name, int port_after_base,
                                                     ServedLine::Events events) {
  ServedPlace place;
  place.name = name;
  place.address = settings.address;
  place.port = settings.port == 0 ? 0 : settings.port + port_after_base;
  place.idle_limit = settings.idle_limit;
  place.pty = settings.pty && port_after_base != kCameraPort;
  if (port_after_base == kCameraPort) place.most_waiting = kMostImages;
  return std::make_unique<ServedLine>(io, std::move(place), std::move(events));
}

/// Like a robot that was switched off and on: the newcomer meets no older session.
void RobotServer::Parts::greet() {
  robot.firmware().reboot();
  connected_at = robot.now();
  to_robot.emplace(settings.faults, 2 * settings.seed);
  to_client.emplace(settings.faults, 2 * settings.seed + 1);
}

void RobotServer::Parts::serve_base() {
  if (due(settings.faults.break_at_s)) base->let_go("the link was broken on request");
  const Bytes bytes = robot.firmware().take_output();
  if (to_client) {
    to_client->put(bytes, connected_s());
    base->write(to_client->take(connected_s()));
  }
  const bool stopped = robot.firmware().watchdog_has_stopped();
  if (stopped && !was_stopped) log("silence: the watchdog stops the robot");
  was_stopped = stopped;
}

void RobotServer::Parts::serve_devices() {
  if (due(settings.devices.turret_sticks_at_s)) robot.servos().servos[0].blocked = true;
  turret->write(robot.servos().take_output());
  Bytes scan = robot.laser().take_output();
  if (!due(settings.devices.laser_silent_at_s)) laser->write(std::move(scan));
}

void RobotServer::Parts::answer_camera(ByteView bytes) {
  camera_questions.push(bytes);
  for (auto question = camera_questions.next(); question; question = camera_questions.next()) {
    camera_tells_time = true;
    camera->write(pioneer::image_stream::tell_time(*question, machine_time().time_since_epoch()));
  }
}

void RobotServer::Parts::serve_images() {
  const bool exposes = robot.exposes();
  if (!camera) return;
  if (exposes && camera->has_client()) {
    feed->expose({robot.scene(), exposures++, machine_time()});
  }
  const Duration latency = from_seconds(settings.camera_latency_s);
  while (!images_under_way.empty()) {
    Packet& packet = images_under_way.front();
    const TimePoint now = machine_time();
    const Duration age = now - packet.exposed_at;
    if (age < latency) return;
    pioneer::image_stream::set_age(packet.bytes, age);
    // A client that is too slow for all of them gets the newer ones.
    if (camera->idle()) {
      if (camera_tells_time) {
        camera->write(pioneer::image_stream::tell_time(0, now.time_since_epoch()));
      }
      camera->write(std::move(packet.bytes));
    }
    images_under_way.pop_front();
  }
}

/// What a person beside the robot would call out.
void RobotServer::Parts::watch_the_judge() {
  const simulator::Judge& judge = robot.judge();
  for (; collisions_told < judge.collisions().size(); ++collisions_told) {
    log("the robot touches " + judge.collisions()[collisions_told].hit);
  }
  if (judge.reached_goal() && !goal_told) {
    goal_told = true;
    log("the robot is beyond the goal line");
  }
}

void RobotServer::Parts::tend_lines() {
  for (ServedLine* line : {base.get(), turret.get(), laser.get(), camera.get()}) {
    if (line != nullptr) line->tend();
  }
}

void RobotServer::Parts::one_step() {
  if (to_robot) {
    const Bytes bytes = to_robot->take(connected_s());
    if (!bytes.empty()) robot.firmware().receive(bytes, robot.now());
  }
  robot.step();
  serve_base();
  serve_devices();
  serve_images();
  tend_lines();
  watch_the_judge();
  tell();
}

void RobotServer::Parts::tell() {
  const simulator::SceneState scene = robot.scene();
  const std::lock_guard lock(mutex);
  state.time_s = to_seconds(robot.now());
  state.connected_s = connected_s();
  state.true_pose = scene.robot;
  state.true_forward_m_s = scene.forward_m_s;
  state.true_head = scene.head;
  state.connected = robot.firmware().connected();
  state.commanded_to_stand = robot.firmware().commanded_to_stand();
  state.motors_on = robot.firmware().motors_on();
  state.collisions = robot.judge().collisions().size();
  state.beyond_goal = robot.judge().reached_goal();
}

RobotServer::RobotServer(ServedPioneer& robot, simulator::ImageSource* pictures,
                         const ServeSettings& settings, Log log)
    : parts_(std::make_unique<Parts>(robot, pictures, settings, std::move(log))) {}

RobotServer::~RobotServer() = default;

const ServedUrls& RobotServer::urls() const {
  return parts_->urls;
}

ServedState RobotServer::state() const {
  const std::lock_guard lock(parts_->mutex);
  return parts_->state;
}

void RobotServer::run(const std::function<bool()>& goes_on) {
  Steady::time_point due = Steady::now();
  while (goes_on()) {
    due += ServedPioneer::kStep;
    if (Steady::now() > due + kMostLate) due = Steady::now();
    parts_->io.restart();
    parts_->io.run_until(due);
    std::this_thread::sleep_until(due);  // nothing may be left to wait for
    parts_->one_step();
  }
}

}  // namespace striate::served
