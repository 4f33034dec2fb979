#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <memory>

#include "striate/agent/robot_settings.hpp"
#include "striate/app/command_line/found_file.hpp"
#include "striate/app/commands/commands.hpp"
#include "striate/app/interrupt.hpp"
#include "striate/app/operator_reset.hpp"
#include "striate/base/say.hpp"
#include "striate/base/user_error.hpp"
#include "striate/platform/pioneer/pioneer_robot.hpp"

namespace striate::app {
namespace {

struct DriveOptions {
  std::string url;
  std::string robot;
  double forward_m_s = 0.0;  // stands, unless asked
  double turn_deg_s = 0.0;   // stands, unless asked
  double for_s = 0.0;        // seconds to drive, where no way is given
  double way_m = 0.0;        // 0: no way to drive
  bool force = false;
};

constexpr double kStands_m_s = 0.005;  // five times the resolution of a SIP's wheel speeds, 1 mm/s
/// 0.6 deg/s: six times the resolution of a SIP's turning speed
constexpr double kStands_rad_s = 0.01;
/// So long a person stays beside a robot that is driven by hand (ours)
constexpr double kLongestDrive_s = 600.0;

void print_state(const Senses& senses, const pioneer::DriverReport& report) {
  const Pose2& pose = senses.odometry.pose;
  const std::string line =
      fmt::format("{:7.2f} s  x {:+.3f} m  y {:+.3f} m  {:+6.1f} deg  {:+.2f} m/s  {:.1f} V  {}\n",
                  to_seconds(senses.now), pose.x_m, pose.y_m, degrees(pose.heading_rad),
                  senses.odometry.forward_m_s, senses.battery_v,
                  report.hold == pioneer::HoldReason::none ? "" : name_of(report.hold));
  say_without_waiting(stdout, line);
}

/// The way or the time that was asked for is over.
bool done(const DriveOptions& options, const Senses& senses, double since_s, double braking_m_s2) {
  if (Interrupt::requested() || since_s > kLongestDrive_s) return true;
  if (options.way_m <= 0.0) return since_s >= options.for_s;
  const Pose2& pose = senses.odometry.pose;
  // It rolls on while it brakes.
  const double v = senses.odometry.forward_m_s;
  const double braking_m = v * v / (2.0 * braking_m_s2);
  return std::hypot(pose.x_m, pose.y_m) + braking_m >= options.way_m;
}

void print_counters(const pioneer::LinkCounters& counters) {
  say(stdout,
      fmt::format("packets {}, bad checksums {}, bad lengths {}, incomplete {}, junk bytes {}, "
                  "malformed {}, "
                  "unknown {}, connections {}\n",
                  counters.stream.packets, counters.stream.bad_checksum, counters.stream.bad_length,
                  counters.stream.incomplete, counters.stream.junk_bytes, counters.malformed,
                  counters.unknown, counters.connections));
}

int drive(const DriveOptions& options) {
  const Interrupt interrupt;
  OperatorReset operator_reset;
  pioneer::BaseDriverSettings settings = agent::load_robot_settings(options.robot).pioneer.base;
  if (options.force) settings.session.force_unknown_model = true;
  pioneer::PioneerRobot robot(settings, options.url);
  say_without_waiting(stdout, fmt::format("connected to {}\n", robot.driver().report().robot));
  Senses senses;
  robot.sense(senses);
  const double began_s = to_seconds(senses.now);
  const MotorCommand command{.forward_m_s = options.forward_m_s,
                             .turn_rad_s = radians(options.turn_deg_s)};
  while (!done(options, senses, to_seconds(senses.now) - began_s,
               settings.session.acceleration_m_s2)) {
    if (operator_reset.asked()) robot.reset();
    robot.send(command);
    robot.sense(senses);
    print_state(senses, robot.driver().report());
  }
  robot.stop();
  do {
    robot.send({});
    robot.sense(senses);
  } while (std::abs(senses.odometry.forward_m_s) > kStands_m_s ||
           std::abs(senses.odometry.turn_rad_s) > kStands_rad_s);
  robot.driver().ask_true_pose();
  robot.sense(senses);
  robot.sense(senses);
  const pioneer::DriverReport report = robot.driver().report();
  print_state(senses, report);
  if (report.true_pose) {
    say(stdout, fmt::format("true pose: x {:.3f} m, y {:.3f} m, {} deg in the world\n",
                            report.true_pose->x_mm / 1000.0, report.true_pose->y_mm / 1000.0,
                            report.true_pose->heading_deg));
  }
  print_counters(report.counters);
  return Interrupt::requested() ? 130 : 0;
}

}  // namespace

void add_drive_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<DriveOptions>();
  CLI::App* command = app.add_subcommand(
      "drive",
      "Drives a Pioneer, real or served, and tells what it says.\n"
      "Examples: striate drive tcp://localhost:8101 --forward-m-s 0.3 --way-m 1\n"
      "          striate drive serial:/dev/ttyUSB0?baud=9600 --robot pioneer");
  command
      ->add_option("robot", options->url,
                   "tcp://host:8101, serial:/dev/ttyUSB0?baud=38400 or pty:/dev/pts/3")
      ->type_name("URL")
      ->required();
  command->add_option("--forward-m-s", options->forward_m_s, "backwards is negative")
      ->check(CLI::Range(-0.75, 0.75));
  command->add_option("--turn-deg-s", options->turn_deg_s, "counter-clockwise")
      ->check(CLI::Range(-68.0, 68.0));
  command->add_option("--for-s", options->for_s, "stops after this time")
      ->check(CLI::Range(0.0, kLongestDrive_s));
  command->add_option("--way-m", options->way_m, "stops after this way instead")
      ->check(CLI::Range(0.0, 100.0))
      ->excludes("--for-s");
  command->add_option("--robot", options->robot, "settings; the section 'pioneer' counts");
  command->add_flag("--force", options->force, "drives a robot of an unknown kind, too");
  command->callback([options, &exit_code] {
    const bool moves = options->forward_m_s != 0.0 || options->turn_deg_s != 0.0;
    const bool ends = options->for_s > 0.0 || options->way_m > 0.0;
    if (moves && !ends) {
      throw UserError(
          "striate drive: --forward-m-s and --turn-deg-s do nothing without --for-s or --way-m");
    }
    find_robot(options->robot);
    exit_code = drive(*options);
  });
}

}  // namespace striate::app
