#include "striate/app/doctor/look_at_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>

#include "striate/base/user_error.hpp"
#include "striate/platform/pioneer/camera/frame_source.hpp"
#include "striate/platform/pioneer/transport.hpp"
#include "striate/platform/pioneer/who_answers.hpp"

namespace striate::app {
namespace {

namespace fs = std::filesystem;
using Grade = Finding::Grade;
/// A turret's reply waits so long in an FTDI's buffer unless it is told otherwise.
constexpr int kSlowLatency_ms = 2;
/// A host that answers at all has by then, one lost SYN (1 s) included
constexpr auto kOpenPatience = std::chrono::milliseconds(1500);
constexpr auto kTick = std::chrono::milliseconds(10);  // between looks: not felt by who waits

bool may_use(const fs::path& device) {
  return ::access(device.c_str(), R_OK | W_OK) == 0;
}

/// What answers must be what the robot file says, or its driver would wait for ever.
Finding look_at_answer(const std::string& about, pioneer::Transport& line,
                       pioneer::Answerer expected, const pioneer::ServoIds& servos) {
  using pioneer::Answerer;
  const Answerer heard = pioneer::who_answers(line, expected, servos);
  const std::string wanted = pioneer::name_of(expected);
  if (heard == expected) return {Grade::good, about, wanted + " answers", {}};
  if (heard == Answerer::nobody) {
    return {Grade::wrong, about, "can be opened, but nothing there answers as " + wanted + " does",
            "switch it on, look at the baud rate, and whether another program holds it"};
  }
  return {Grade::wrong, about,
          fmt::format("there answers {}, not {}", pioneer::name_of(heard), wanted),
          "correct the places, or the kind of laser, in the robot file"};
}

}  // namespace

Finding permission(const fs::path& device, const char* kind, const char* group) {
  if (may_use(device)) return {Grade::good, device, std::string(kind) + ", may be opened", {}};
  return {Grade::wrong, device, std::string(kind) + ", but this user may not open it",
          fmt::format("sudo usermod -aG {} $USER, then log in again", group)};
}

void look_at_latency(const fs::path& port, const fs::path& sys, Findings& findings) {
  std::ifstream file(sys / "bus/usb-serial/devices" / port.filename() / "latency_timer");
  int latency_ms = 0;
  if (!(file >> latency_ms) || latency_ms <= kSlowLatency_ms) return;
  findings.push_back(
      {Grade::note, port, fmt::format("holds bytes back for up to {} ms", latency_ms),
       fmt::format("for a turret: echo 1 | sudo tee {}/bus/usb-serial/devices/{}/latency_timer",
                   sys.string(), port.filename().string())});
}

Finding look_at_line(const std::string& name, const std::string& url, pioneer::Answerer expected,
                     const pioneer::ServoIds& servos) {
  const std::string about = name + " " + url;
  try {
    const auto line = pioneer::make_transport(url);
    const auto end = std::chrono::steady_clock::now() + kOpenPatience;
    line->open();
    while (line->is_opening() && std::chrono::steady_clock::now() < end) line->wait(kTick);
    if (line->is_open()) return look_at_answer(about, *line, expected, servos);
    const std::string why = line->trouble();
    return {Grade::wrong, about, why.empty() ? "does not answer" : why,
            "switch it on, look at the cable, and at the place in the robot file"};
  } catch (const UserError& error) {
    return {Grade::wrong, about, error.what(), "correct the place in the robot file"};
  }
}

}  // namespace striate::app
