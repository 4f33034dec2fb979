#include "striate/platform/pioneer/device_thread.hpp"

#include <algorithm>
#include <exception>

namespace striate::pioneer {
namespace {

/// A device's bytes wait so long at most; at 115200 baud 58 of them
constexpr Duration kTick = std::chrono::milliseconds(5);
constexpr double kFirstBackOff_s = 0.2;    // before the first opening again; doubles each time
constexpr double kLongestBackOff_s = 4.0;  // so soon after it is plugged in a device is used again

}  // namespace

DeviceThread::DeviceThread(Device& device, std::unique_ptr<Transport> line, const Clock& clock)
    : device_(device), line_(std::move(line)), clock_(clock), thread_([this] { run(); }) {}

DeviceThread::~DeviceThread() {
  ends_ = true;
  thread_.join();
}

void DeviceThread::care_for_the_line(TimePoint now) {
  if (line_->is_open()) {
    if (!was_open_) {
      device_.line_up(now);
      trouble_.put({});
    }
    was_open_ = true;
    back_off_s_ = 0.0;
    return;
  }
  if (line_->is_opening()) return;
  const std::string why = line_->trouble();
  if (was_open_ || !why.empty()) trouble_.put(why.empty() ? "the line is closed" : why);
  was_open_ = false;
  if (now < open_again_at_) return;
  line_->open();
  back_off_s_ = std::clamp(2.0 * back_off_s_, kFirstBackOff_s, kLongestBackOff_s);
  open_again_at_ = now + from_seconds(back_off_s_);
}

void DeviceThread::send(const Bytes& bytes) {
  if (!bytes.empty() && line_->is_open()) line_->write(bytes);
}

void DeviceThread::run() {
  while (!ends_) {
    try {
      line_->wait(kTick);
      const TimePoint now = clock_.now();
      care_for_the_line(now);
      if (line_->is_open()) {
        if (const Bytes bytes = line_->read(); !bytes.empty()) device_.receive(bytes, now);
      }
      device_.tick(now);
      send(device_.take_output());
    } catch (const std::exception& error) {
      begin_anew(error.what());
    } catch (...) {
      begin_anew("an unknown error");
    }
  }
  try {
    device_.close();
    send(device_.take_output());
    line_->close();
  } catch (...) {  // nobody is there any more who would ask why
  }
}

/// A device that cannot be understood is one that is lost: what it senses gets old, and the robot
/// stands. Nothing may leave the thread, for that would end the program.
void DeviceThread::begin_anew(const char* why) noexcept {
  try {
    trouble_.put(why);
    line_->close();
  } catch (...) {  // no memory for the words: the next round tries again
  }
  std::this_thread::sleep_for(kTick);
}

}  // namespace striate::pioneer
