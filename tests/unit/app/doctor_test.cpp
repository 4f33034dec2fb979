#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <opencv2/imgproc.hpp>

#include "striate/app/doctor/bridge.hpp"
#include "striate/app/doctor/configuration.hpp"
#include "striate/app/doctor/devices.hpp"
#include "striate/app/doctor/eyes.hpp"
#include "striate/app/doctor/machine.hpp"
#include "striate/platform/pioneer/camera/stereo_calibration.hpp"
#include "tests/reference/scattered_pair.hpp"
#include "tests/reference/temporary_folder.hpp"
#include "tests/reference/write_motion_jpeg.hpp"

namespace striate::app {
namespace {

namespace fs = std::filesystem;
using Grade = Finding::Grade;

const Finding* about(const Findings& findings, const std::string& what) {
  for (const Finding& finding : findings) {
    if (finding.about.find(what) != std::string::npos) return &finding;
  }
  return nullptr;
}

void write(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

TEST(Doctor, FindsThisMachineGoodEnoughAndTellsABadOne) {
  const Machine here = this_machine();
  EXPECT_GT(here.cores, 0u);
  EXPECT_GT(here.memory_bytes, 0u);
  EXPECT_FALSE(here.simd.empty());
  const Findings bad = look_at_machine(
      {.cores = 1, .simd = "SCALAR", .memory_bytes = 1 << 20, .disk_free_bytes = 0});
  EXPECT_TRUE(any_wrong(bad));
  EXPECT_EQ(about(bad, "cores")->grade, Grade::note);
  EXPECT_EQ(about(bad, "SIMD")->grade, Grade::note);
  EXPECT_EQ(about(bad, "memory")->grade, Grade::wrong);
  EXPECT_EQ(about(bad, "disk")->grade, Grade::wrong);
  for (const Finding& finding : bad) EXPECT_NE(finding.mend, "") << finding.about;
  EXPECT_FALSE(any_wrong(look_at_machine(
      {.cores = 4, .simd = "AVX2", .memory_bytes = 1ULL << 32U, .disk_free_bytes = 1ULL << 34U})));
}

TEST(Doctor, LooksAtSerialPortsAndTheirLatency) {
  const reference::TemporaryFolder folder;
  const fs::path root = folder / "";
  write(root / "dev/ttyUSB0", "");
  write(root / "dev/video0", "");
  write(root / "sys/bus/usb-serial/devices/ttyUSB0/latency_timer", "16\n");
  const Findings findings = look_at_devices({root / "dev", root / "sys"});
  EXPECT_EQ(about(findings, "ttyUSB0")->grade, Grade::good);
  EXPECT_EQ(about(findings, "video0")->grade, Grade::good);
  bool told_latency = false;
  for (const Finding& finding : findings) {
    told_latency = told_latency || finding.what.find("16 ms") != std::string::npos;
  }
  EXPECT_TRUE(told_latency);
  const Findings none = look_at_devices({root / "nothing", root / "sys"});
  EXPECT_EQ(about(none, "serial ports")->grade, Grade::note);
  EXPECT_EQ(about(none, "cameras")->grade, Grade::note);
  EXPECT_FALSE(any_wrong(none));
}

TEST(Doctor, TriesThePlacesOfARobotFile) {
  pioneer::PioneerSettings settings;
  EXPECT_FALSE(any_wrong(look_at_places(settings))) << "for the simulator";
  settings.devices = {"tcp://127.0.0.1:1", "serial:/dev/no_such_port", "nonsense",
                      "video:/no/such/video"};
  const Findings findings = look_at_places(settings);
  for (const char* name : {"base", "turret", "laser", "camera"}) {
    ASSERT_NE(about(findings, name), nullptr) << name;
    EXPECT_EQ(about(findings, name)->grade, Grade::wrong) << name;
    EXPECT_NE(about(findings, name)->what, "") << name;
  }
}

TEST(Doctor, TriesTheRosbridgeServerOfARobotFile) {
  agent::RobotSettings settings;
  EXPECT_TRUE(look_at_bridge(settings).empty()) << "none is named";
  settings.rosbridge.url = "ws://127.0.0.1:1";
  const Findings refused = look_at_bridge(settings, std::chrono::milliseconds(300));
  ASSERT_NE(about(refused, "ws://127.0.0.1:1"), nullptr);
  EXPECT_EQ(about(refused, "ws://127.0.0.1:1")->grade, Grade::wrong);
  EXPECT_THAT(about(refused, "ws://127.0.0.1:1")->what, testing::HasSubstr("no rosbridge server"));
  settings.rosbridge.url = "http://robot";
  EXPECT_THAT(look_at_bridge(settings)[0].what, testing::HasSubstr("must begin with ws://"));
}

TEST(Doctor, JudgesACalibrationByTheErrorThatStandsInIt) {
  const reference::TemporaryFolder folder;
  pioneer::PioneerSettings settings;
  settings.devices = {"tcp://127.0.0.1:1", "", "", "video:/no/such/video"};
  settings.camera.calibration = folder / "stereo.yaml";
  pioneer::StereoCalibration calibration;
  calibration.size_px = {320, 240};
  calibration.left.matrix =
      calibration.right.matrix = {400.0, 0.0, 159.5, 0.0, 400.0, 119.5, 0.0, 0.0, 1.0};
  calibration.translation_m = {-0.12, 0.0, 0.0};
  for (const auto& [error_px, grade] : {std::pair{0.2, Grade::good},
                                        {1.5, Grade::note},
                                        {42.0, Grade::wrong},
                                        {0.0, Grade::note}}) {
    calibration.reprojection_px = error_px;
    pioneer::write_calibration(settings.camera.calibration, calibration);
    const Findings findings = look_at_places(settings);
    const Finding* finding = about(findings, "stereo.yaml");
    ASSERT_NE(finding, nullptr);
    EXPECT_EQ(finding->grade, grade) << error_px << ": " << finding->what;
    EXPECT_EQ(finding->mend.empty(), grade == Grade::good);
  }
}

cv::Mat3b colour(const cv::Mat1b& grey) {
  cv::Mat3b image;
  cv::cvtColor(grey, image, cv::COLOR_GRAY2BGR);
  return image;
}

TEST(Doctor, SaysWhenTheEyesOfACameraAreExchangedOrOneIsShownTwice) {
  const reference::EyeImages eyes = reference::scattered_pair(3);
  const cv::Mat3b left = colour(eyes.left);
  const cv::Mat3b right = colour(eyes.right);
  EXPECT_EQ(look_at_pair_of("eyes", left, right).grade, Grade::good);
  EXPECT_EQ(look_at_pair_of("eyes", right, left).grade, Grade::wrong);
  EXPECT_THAT(look_at_pair_of("eyes", right, left).what, testing::HasSubstr("exchanged"));
  EXPECT_THAT(look_at_pair_of("eyes", left, left).what, testing::HasSubstr("same picture"));
  const cv::Mat3b plain(120, 160, cv::Vec3b::all(80));
  EXPECT_EQ(look_at_pair_of("eyes", plain, plain).grade, Grade::note);
  for (const cv::Mat3b* second : {&left, &right}) {
    EXPECT_EQ(look_at_pair_of("eyes", left, *second).mend.empty(), second == &right);
  }
}

TEST(Doctor, LooksAtTheEyesOfACameraThatGivesPairs) {
  const reference::TemporaryFolder folder;
  const reference::EyeImages eyes = reference::scattered_pair(4, 60.0, 6.0, {320, 240});
  cv::Mat3b both;
  cv::hconcat(colour(eyes.left), colour(eyes.right), both);
  reference::write_motion_jpeg(folder / "d.avi", std::vector<cv::Mat>(20, both), 20);
  pioneer::PioneerSettings settings;
  settings.devices = {"tcp://127.0.0.1:1", "", "", "video:" + (folder / "d.avi")};
  ASSERT_NE(about(look_at_places(settings), "eyes of"), nullptr);
  EXPECT_EQ(about(look_at_places(settings), "eyes of")->grade, Grade::good);
  settings.camera.swap = true;
  EXPECT_EQ(about(look_at_places(settings), "eyes of")->grade, Grade::wrong);
}

TEST(Doctor, FindsTheShippedConfigurationGoodAndNamesAFileThatIsNot) {
  const Findings shipped = look_at_configuration(STRIATE_SOURCE_DIR "/config");
  EXPECT_FALSE(any_wrong(shipped));
  EXPECT_EQ(shipped.size(), 3u);
  const reference::TemporaryFolder folder;
  const fs::path root = folder / "";
  write(root / "robots/odd.yaml", "pioneer: {wheels: 3}\n");
  const Findings findings = look_at_configuration(root);
  ASSERT_NE(about(findings, "odd.yaml"), nullptr);
  EXPECT_EQ(about(findings, "odd.yaml")->grade, Grade::wrong);
  EXPECT_THAT(about(findings, "odd.yaml")->what, testing::HasSubstr("wheels"));
  EXPECT_EQ(about(findings, "worlds")->grade, Grade::note);
}

TEST(Doctor, LooksIntoTheMemory) {
  const reference::TemporaryFolder folder;
  EXPECT_EQ(look_at_memory(folder / "none.db").grade, Grade::note);
  const std::string file = folder / "text.db";
  std::ofstream(file) << "this is no memory at all, but a text of some length";
  EXPECT_EQ(look_at_memory(file).grade, Grade::wrong);
}

}  // namespace
}  // namespace striate::app
