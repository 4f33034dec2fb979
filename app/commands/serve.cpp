#include "striate/app/commands/serve.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <boost/asio/ip/address.hpp>
#include <cstdio>

#include "striate/agent/robot_settings.hpp"
#include "striate/app/interrupt.hpp"
#include "striate/app/late_opencv.hpp"
#include "striate/base/say.hpp"
#include "striate/base/user_error.hpp"
#include "striate/platform/pioneer/robot_model.hpp"
#include "striate/platform/served/robot_server.hpp"
#include "striate/platform/simulator/render/renderer_images.hpp"
#include "striate/platform/simulator/world_reader.hpp"

namespace striate::app {
namespace {

constexpr const char* kGroup = "Serving";

/// Who can connect can drive: there is no password in any of these protocols.
void warn_of_the_network(const std::string& address) {
  boost::system::error_code error;
  const auto listens = boost::asio::ip::make_address(address, error);
  if (error || listens.is_loopback()) return;
  say(stderr, fmt::format("warning: --listen {} lets everybody on the network drive this robot, "
                          "since nothing asks for a password\n",
                          address));
}

}  // namespace

void add_serve_options(CLI::App& command, ServeOptions& options) {
  options.command = &command;
  const std::string group = kGroup;
  command.add_flag("--serve", options.tcp, "serves the robot on TCP, in real time")->group(group);
  command.add_flag("--pty", options.pty, "base, turret and laser on pseudo-terminals instead")
      ->group(group);
  command
      .add_option("--listen", options.address,
                  "address to listen at; 0.0.0.0 lets other machines drive")
      ->type_name("ADDRESS")
      ->group(group)
      ->capture_default_str();
  command
      .add_option("--port", options.port,
                  "TCP port of the base; turret, laser and camera have the next three; 0 takes any "
                  "free ones")
      ->check(CLI::Range(0, 65532))
      ->group(group)
      ->capture_default_str();
  command
      .add_option("--kind", options.kind,
                  "the Pioneer's kind; also as ARIA names one with a laser, p3dx-sh-lms200")
      ->check(CLI::Validator(
          [](const std::string& kind) {
            return pioneer::find_model(kind) != nullptr
                       ? std::string()
                       : fmt::format("{}: not one of {}", kind,
                                     fmt::join(pioneer::model_names(), ", "));
          },
          fmt::format("{{{}}}", fmt::join(pioneer::model_names(), ","))))
      ->group(group)
      ->capture_default_str();
  command
      .add_option("--laser", options.laser,
                  "what is at the laser's line; without it a hokuyo, or the lms200 that the kind "
                  "names")
      ->check(CLI::IsMember({"hokuyo", "lms200"}))
      ->group(group);
  served::LineFaults& faults = options.faults;
  command.add_option("--loss", faults.loss, "share of packets that never come, 0 .. 1")
      ->check(CLI::Range(0.0, 1.0))
      ->group(group);
  command.add_option("--corruption", faults.corruption, "share of bytes with a wrong bit, 0 .. 1")
      ->check(CLI::Range(0.0, 1.0))
      ->group(group);
  command.add_option("--delay-s", faults.delay_s, "each way")
      ->check(CLI::Range(0.0, 5.0))
      ->group(group);
  CLI::Option* silent_at = command
                               .add_option("--silent-at-s", faults.silent_at_s,
                                           "after the connection nothing passes any more; 0 never")
                               ->check(CLI::Range(0.0, 36000.0))
                               ->group(group);
  command.add_option("--silent-for-s", faults.silent_for_s, "then it passes again")
      ->check(CLI::Range(0.0, 36000.0))
      ->group(group)
      ->needs(silent_at)
      ->capture_default_str();
  command
      .add_option("--laser-silent-at-s", options.devices.laser_silent_at_s,
                  "after the connection the laser says nothing any more; 0 never")
      ->check(CLI::Range(0.0, 36000.0))
      ->group(group);
  command
      .add_option("--turret-sticks-at-s", options.devices.turret_sticks_at_s,
                  "after the connection something holds the pan servo; 0 never")
      ->check(CLI::Range(0.0, 36000.0))
      ->group(group);
  command
      .add_option("--break-at-s", faults.break_at_s, "after the connection it is closed; 0 never")
      ->check(CLI::Range(0.0, 36000.0))
      ->group(group);
}

void ServeOptions::check() const {
  if (serves() || command == nullptr) return;
  for (const CLI::Option* option : command->get_options()) {
    if (option->get_group() != kGroup || option->count() == 0) continue;
    throw UserError(
        fmt::format("striate sim: {} does nothing without --serve or --pty", option->get_name()));
  }
}

int serve(const ServeOptions& options) {
  load_opencv_codecs();
  const simulator::World world = simulator::load_world(options.world);
  const agent::RobotSettings settings = agent::load_robot_settings(options.robot);
  served::ServedDevices devices;
  devices.base.subclass = options.kind;
  const bool by_kind = options.laser.empty() && options.kind.ends_with("-lms200");
  devices.laser = by_kind || options.laser == "lms200" ? pioneer::LaserKind::lms200
                                                       : pioneer::LaserKind::hokuyo;
  served::ServedPioneer robot(world, options.seed, settings.simulator, devices,
                              agent::simulated_robot(settings));
  served::ServeSettings serving;
  serving.address = options.address;
  serving.port = options.port;
  serving.pty = options.pty;
  serving.faults = options.faults;
  serving.seed = options.seed;
  serving.devices = options.devices;
  serving.camera_latency_s = settings.simulator.sensors.camera_latency_s;
  simulator::RendererImages pictures(world, robot.plan(), settings.camera, options.seed);
  const Interrupt interrupt;
  served::RobotServer server(robot, &pictures, serving, [&robot](const std::string& line) {
    say_without_waiting(stdout, fmt::format("{:8.2f} s  {}\n", to_seconds(robot.now()), line));
  });
  const served::ServedUrls& urls = server.urls();
  say(stdout,
      fmt::format(
          "a {} in {}; Ctrl-C ends it\n  base    {}\n  turret  {}\n  laser   {}\n  camera  {}\n",
          options.kind, world.name, urls.base, urls.turret, urls.laser, urls.camera));
  warn_of_the_network(options.address);
  server.run([] { return !Interrupt::requested(); });
  return 0;
}

}  // namespace striate::app
