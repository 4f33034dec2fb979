#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <sstream>

#include "striate/agent/teaching/image_view.hpp"
#include "striate/agent/teaching/keep_taught.hpp"
#include "striate/app/perceive_sequence.hpp"
#include "striate/app/recognise.hpp"
#include "striate/base/user_error.hpp"
#include "striate/memory/long_term/long_term_settings.hpp"
#include "tests/reference/scattered_pair.hpp"
#include "tests/reference/temporary_folder.hpp"

namespace striate::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using testing::HasSubstr;

/// A printed cover: letters and shapes that no other seed has.
cv::Mat3b cover(int seed, cv::Size size = {220, 160}) {
  cv::RNG random(static_cast<std::uint64_t>(seed) * 7919 + 1);
  cv::Mat3b image(size, cv::Vec3b(230, 230, 225));
  for (int k = 0; k < 60; ++k) {
    const cv::Point at(random.uniform(0, size.width), random.uniform(0, size.height));
    const cv::Scalar ink(random.uniform(0, 200), random.uniform(0, 200), random.uniform(0, 200));
    if (k % 2 == 0) {
      cv::rectangle(image, at, at + cv::Point(random.uniform(5, 30), random.uniform(5, 30)), ink,
                    -1);
    } else {
      cv::circle(image, at, random.uniform(3, 14), ink, -1, cv::LINE_AA);
    }
  }
  return image;
}

/// The cover in a scene of noise, turned and scaled.
cv::Mat3b scene_with(const cv::Mat3b& thing, double scale, double turn_deg, cv::Point2d at) {
  cv::Mat3b scene(480, 640);
  cv::RNG(5).fill(scene, cv::RNG::UNIFORM, 90, 110);
  cv::Mat1d map =
      cv::getRotationMatrix2D({0.5F * (thing.cols - 1), 0.5F * (thing.rows - 1)}, -turn_deg, scale);
  map(0, 2) += at.x - 0.5 * (thing.cols - 1);
  map(1, 2) += at.y - 0.5 * (thing.rows - 1);
  cv::warpAffine(thing, scene, map, scene.size(), cv::INTER_LINEAR, cv::BORDER_TRANSPARENT);
  return scene;
}

void teach(const std::string& memory, const std::string& name, const cv::Mat3b& picture) {
  const memory::LongTermSettings settings;
  (void)agent::keep_taught(memory, name, {agent::view_of_image(picture, settings)}, settings);
}

struct Printed {
  int exit_code = 0;
  std::vector<Json> lines;
  std::string text;
};

template <class Run>
Printed printed(const Run& run) {
  testing::internal::CaptureStdout();
  Printed result;
  try {
    result.exit_code = run();
  } catch (...) {
    (void)testing::internal::GetCapturedStdout();
    throw;
  }
  std::fflush(stdout);
  result.text = testing::internal::GetCapturedStdout();
  std::istringstream in(result.text);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("{")) result.lines.push_back(Json::parse(line));
  }
  return result;
}

RecogniseOptions asked(const reference::TemporaryFolder& folder, const std::string& source) {
  RecogniseOptions options;
  options.source = source;
  options.memory = folder / "m.db";
  options.json = true;
  return options;
}

TEST(Recognise, NamesWhatWasTaughtWithItsCornersAndSaysWhatIsAbsent) {
  const reference::TemporaryFolder folder;
  teach(folder / "m.db", "red", cover(1));
  teach(folder / "m.db", "blue", cover(2));
  cv::imwrite(folder / "scene.png", scene_with(cover(1), 1.3, 20.0, {300, 220}));
  RecogniseOptions options = asked(folder, folder / "scene.png");
  options.out = folder / "out";
  const Printed found = printed([&] { return recognise(options); });
  EXPECT_EQ(found.exit_code, 0);
  ASSERT_EQ(found.lines.size(), 2U);
  ASSERT_EQ(found.lines[0]["things"].size(), 1U);
  const Json& thing = found.lines[0]["things"][0];
  EXPECT_EQ(thing["name"], "red");
  EXPECT_NEAR(thing["turned_deg"], 20.0, 2.0);
  EXPECT_NEAR(thing["scale"], 1.3, 0.05);
  double u = 0.0;
  double v = 0.0;
  for (const Json& corner : thing["quad"]) {
    u += 0.25 * corner[0].get<double>();
    v += 0.25 * corner[1].get<double>();
  }
  EXPECT_NEAR(u, 300, 4);
  EXPECT_NEAR(v, 220, 4);
  EXPECT_EQ(found.lines[1]["summary"]["seen_in"]["blue"], 0);
  EXPECT_EQ(cv::imread(folder / "out/recognised_000000.png").size(), cv::Size(640, 480));
  options.only = {"blue"};
  options.json = false;
  const Printed absent = printed([&] { return recognise(options); });
  EXPECT_EQ(absent.exit_code, 1);
  EXPECT_THAT(absent.text, HasSubstr("not seen: blue"));
}

TEST(Recognise, AQuadFollowsWhatIsSeenAslant) {
  const reference::TemporaryFolder folder;
  const cv::Mat3b thing = cover(3);
  teach(folder / "m.db", "box", thing);
  cv::Mat3b scene(480, 640, cv::Vec3b(100, 100, 100));
  const cv::Matx23d aslant(1.5, 0.2, 150, 0.1, 1.0,
                           120);  // one way is drawn out half as much again
  cv::warpAffine(thing, scene, aslant, scene.size(), cv::INTER_LINEAR, cv::BORDER_TRANSPARENT);
  cv::imwrite(folder / "s.png", scene);
  const Printed found = printed([&] { return recognise(asked(folder, folder / "s.png")); });
  ASSERT_EQ(found.lines[0]["things"].size(), 1U);
  const cv::Point2d corners[] = {{0, 0}, {219, 0}, {219, 159}, {0, 159}};
  for (std::size_t k = 0; k < 4; ++k) {
    const Json& told = found.lines[0]["things"][0]["quad"][k];
    const double u = 1.5 * corners[k].x + 0.2 * corners[k].y + 150;
    const double v = 0.1 * corners[k].x + 1.0 * corners[k].y + 120;
    EXPECT_NEAR(told[0], u, 8) << k;
    EXPECT_NEAR(told[1], v, 8) << k;
  }
}

TEST(Recognise, AnEmptyOrMissingMemoryAndAnUnknownNameAreSaid) {
  const reference::TemporaryFolder folder;
  cv::imwrite(folder / "scene.png", cover(1));
  const auto mistake = [&](const RecogniseOptions& options) -> std::string {
    try {
      (void)printed([&] { return recognise(options); });
    } catch (const UserError& error) {
      return error.what();
    }
    return "";
  };
  RecogniseOptions options = asked(folder, folder / "scene.png");
  EXPECT_THAT(mistake(options), HasSubstr("there is no such memory"));
  EXPECT_FALSE(fs::exists(options.memory));
  teach(options.memory, "red", cover(1));
  options.only = {"green"};
  EXPECT_THAT(mistake(options),
              HasSubstr("no landmark in the memory is called 'green'; there are: red"));
}

TEST(Recognise, LooksIntoEveryPictureOfAFolderWhateverTheirSizes) {
  const reference::TemporaryFolder folder;
  teach(folder / "m.db", "red", cover(1));
  fs::create_directories(folder / "p");
  cv::imwrite(folder / "p/a.png", scene_with(cover(1), 1.0, 0.0, {200, 200}));
  cv::imwrite(folder / "p/b.png", cover(9));
  cv::Mat3b large;
  cv::resize(scene_with(cover(1), 1.2, -40.0, {320, 240}), large, {}, 2.5, 2.5);
  cv::imwrite(folder / "p/c.png", large);
  const Printed found = printed([&] { return recognise(asked(folder, folder / "p")); });
  ASSERT_EQ(found.lines.size(), 4U);
  EXPECT_EQ(found.lines[0]["things"].size(), 1U);
  EXPECT_EQ(found.lines[1]["things"].size(), 0U);
  ASSERT_EQ(found.lines[2]["things"].size(), 1U);
  EXPECT_NEAR(found.lines[2]["things"][0]["scale"], 3.0, 0.15);
  EXPECT_EQ(found.lines[3]["summary"]["seen_in"]["red"], 2);
}

/// Pairs of a rectified camera: f 500 px, 0.1 m, so that 20 px are 2.5 m.
void write_pairs(const reference::TemporaryFolder& folder, int count) {
  fs::create_directories(folder / "set/left");
  fs::create_directories(folder / "set/right");
  for (int k = 0; k < count; ++k) {
    const reference::EyeImages eyes = reference::scattered_pair(static_cast<std::uint64_t>(k) + 3);
    cv::imwrite(folder / ("set/left/" + std::to_string(k) + ".png"), eyes.left);
    cv::imwrite(folder / ("set/right/" + std::to_string(k) + ".png"), eyes.right);
  }
  (void)folder.write("set/camera.yaml",
                     "P1: [500, 0, 319.5, 0, 0, 500, 239.5, 0, 0, 0, 1, 0]\n"
                     "P2: [500, 0, 319.5, -50, 0, 500, 239.5, 0, 0, 0, 1, 0]\n"
                     "image_width: 640\nimage_height: 480\n");
}

TEST(Recognise, TellsHowFarAThingIsWhereThereAreTwoEyes) {
  const reference::TemporaryFolder folder;
  teach(folder / "m.db", "red", cover(1));
  write_pairs(folder, 0);
  for (const bool is_right : {false, true}) {
    cv::Mat3b scene = scene_with(cover(4, {640, 480}), 1.0, 0.0, {320.0 - (is_right ? 5 : 0), 240});
    cv::Mat3b thing = cover(1);
    thing.copyTo(scene(cv::Rect(260 - (is_right ? 20 : 0), 150, thing.cols, thing.rows)));
    cv::imwrite(folder / (is_right ? "set/right/0.png" : "set/left/0.png"), scene);
  }
  const Printed found = printed([&] { return recognise(asked(folder, folder / "set")); });
  ASSERT_EQ(found.lines[0]["things"].size(), 1U) << found.text;
  EXPECT_NEAR(found.lines[0]["things"][0]["range_m"], 2.5, 0.15);
  EXPECT_NEAR(found.lines[0]["things"][0]["bearing_deg"],
              std::atan2(319.5 - 369.5, 500.0) * 180.0 / CV_PI, 1.0);
}

TEST(PerceiveSequence, PrintsALineForEachFrameAndOneForAllAndNumbersItsFiles) {
  const reference::TemporaryFolder folder;
  write_pairs(folder, 4);
  (void)folder.write("set/right/2.png", "broken");
  PerceiveSequenceOptions options;
  options.source = folder / "set";
  options.json = true;
  options.frame.out = folder / "out";
  options.frame.camera_height_m = 1.0;
  const Printed seen = printed([&] { return perceive_sequence(options); });
  EXPECT_EQ(seen.exit_code, 0);
  ASSERT_EQ(seen.lines.size(), 4U);
  EXPECT_EQ(seen.lines[2]["frame"], 3);
  EXPECT_GT(seen.lines[0]["dense"], 0.5);
  EXPECT_EQ(seen.lines[0]["unit"], "m");
  EXPECT_EQ(seen.lines[3]["summary"]["frames"], 3);
  EXPECT_EQ(seen.lines[3]["summary"]["left_out"], 1);
  EXPECT_TRUE(fs::exists(folder / "out/overview_000003.png"));
  EXPECT_FALSE(fs::exists(folder / "out/overview_000002.png"));
  EXPECT_TRUE(fs::exists(folder / "out/disparity_000000.pfm"));
}

TEST(PerceiveSequence, OneEyeAndNoCalibrationAreSeenToo) {
  const reference::TemporaryFolder folder;
  write_pairs(folder, 2);
  PerceiveSequenceOptions options;
  options.source = folder / "set/left";
  const Printed one_eye = printed([&] { return perceive_sequence(options); });
  EXPECT_THAT(one_eye.text, HasSubstr("one eye"));
  EXPECT_THAT(one_eye.text, HasSubstr("2 frames; "));
  fs::remove(folder / "set/camera.yaml");
  options.source = folder / "set";
  options.json = true;
  const Printed unknown = printed([&] { return perceive_sequence(options); });
  EXPECT_EQ(unknown.lines[0]["unit"], "baselines");
  options.frame.camera_height_m = 1.0;
  EXPECT_THROW((void)printed([&] { return perceive_sequence(options); }), UserError);
}

}  // namespace
}  // namespace striate::app
