#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>

#include "striate/platform/pioneer/camera/frame_source.hpp"
#include "striate/platform/pioneer/camera/grabbing_camera.hpp"
#include "striate/platform/pioneer/device_thread.hpp"
#include "striate/platform/pioneer/steady_clock.hpp"
#include "tests/unit/pioneer/test_bed.hpp"

/// An error in the thread of a device must not end the program: what the device senses gets old.
namespace striate::pioneer {
namespace {

using namespace std::chrono_literals;

template <class Condition>
bool comes_true(const Condition& condition) {
  const auto end = std::chrono::steady_clock::now() + 10s;
  while (!condition() && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(2ms);
  return condition();
}

/// Throws what is no std::exception, for some time, also at its end.
class BrokenDevice final : public Device {
 public:
  void receive(ByteView /*bytes*/, TimePoint /*now*/) override {}
  void tick(TimePoint /*now*/) override {
    if (++ticks < 5) throw 7;
  }
  void close() override { throw 7; }
  std::atomic<int> ticks{0};
};

TEST(DeviceThread, OutlivesWhateverItsDeviceThrowsAndBeginsAnew) {
  const SteadyClock clock;
  BrokenDevice device;
  const DeviceThread thread(device, std::make_unique<MemoryLine>(), clock);
  EXPECT_TRUE(comes_true([&] { return device.ticks > 10; }));
}

class BrokenSource final : public FrameSource {
 public:
  explicit BrokenSource(std::atomic<int>& closed) : closed_(closed) {}
  void open() override {}
  bool grab(cv::Mat3b& /*left*/, cv::Mat3b& /*right*/) override { throw 7; }
  void close() override {
    ++closed_;
    throw std::runtime_error("it does not close");
  }

 private:
  std::atomic<int>& closed_;
};

TEST(GrabbingCamera, OutlivesWhateverItsSourceThrowsAndOpensItAgain) {
  const SteadyClock clock;
  std::atomic<int> closed{0};
  const GrabbingCamera camera(std::make_unique<BrokenSource>(closed), {}, clock);
  EXPECT_TRUE(comes_true([&] { return closed > 1; }));
  EXPECT_EQ(camera.trouble(), "an unknown error");
  EXPECT_TRUE(camera.newest().left.empty());
}

}  // namespace
}  // namespace striate::pioneer
