#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <sstream>

#include "striate/base/user_error.hpp"
#include "striate/evaluation/evaluation.hpp"
#include "striate/evaluation/object_methods.hpp"
#include "striate/evaluation/object_set.hpp"
#include "tests/reference/test_images.hpp"

namespace striate::evaluation {
namespace {

namespace fs = std::filesystem;

fs::path empty_folder(const std::string& name) {
  const fs::path folder = fs::path(testing::TempDir()) / ("eval_objects_" + name);
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

cv::Mat1b coarse_texture(cv::Size size, int seed) {
  cv::Mat1b coarse;
  cv::resize(reference::texture(size / 3, seed), coarse, size, 0, 0, cv::INTER_CUBIC);
  return coarse;
}

/// An object on black.
cv::Mat1b taught(int seed) {
  cv::Mat1b image(cv::Size(240, 200), std::uint8_t{0});
  coarse_texture({180, 150}, seed).copyTo(image(cv::Rect(30, 25, 180, 150)));
  return image;
}

cv::Mat1b scene_with(int seed) {
  cv::Mat1b scene = coarse_texture({480, 360}, 99);
  coarse_texture({180, 150}, seed).copyTo(scene(cv::Rect(150, 100, 180, 150)));
  return scene;
}

void write_truth(const fs::path& folder, const std::string& text) {
  std::ofstream(folder / "truth.json") << text;
}

/// Objects "cup" and "box"; the one scene shows the box.
fs::path plain_layout(const std::string& name) {
  const fs::path folder = empty_folder(name);
  for (const auto& [object, seed] : {std::pair{"cup", 1}, {"box", 2}}) {
    fs::create_directories(folder / "objects" / object);
    cv::imwrite((folder / "objects" / object / "front.png").string(), taught(seed));
  }
  fs::create_directories(folder / "scenes");
  cv::imwrite((folder / "scenes" / "table.png").string(), scene_with(2));
  write_truth(folder, R"({"table": ["box"]})");
  return folder;
}

TEST(ObjectSet, ReadsObjectsScenesAndTruth) {
  const ObjectSet set = read_object_set(plain_layout("plain").string());
  ASSERT_EQ(set.objects.size(), 2U);
  EXPECT_EQ(set.objects[0].name, "box");
  ASSERT_EQ(set.scenes.size(), 1U);
  EXPECT_EQ(set.scenes[0].present, std::set<std::string>{"box"});
}

TEST(ObjectSet, ReadsPairsOfAnImageAndAScene) {
  const fs::path folder = empty_folder("pairs");
  cv::imwrite((folder / "box.png").string(), taught(2));
  cv::imwrite((folder / "box_in_scene.png").string(), scene_with(2));
  const ObjectSet set = read_object_set(folder.string());
  ASSERT_EQ(set.objects.size(), 1U);
  EXPECT_EQ(set.scenes.at(0).present.count("box"), 1U);
}

TEST(ObjectSet, ReadsJskArcAndLeavesOutWhatShowsAnotherSide) {
  const fs::path folder = empty_folder("jsk");
  fs::create_directories(folder / "objects" / "soap");
  fs::create_directories(folder / "objects" / "bin");
  fs::create_directories(folder / "scenes");
  cv::imwrite((folder / "objects" / "soap" / "top.jpg").string(), taught(1));
  std::ofstream(folder / "objects" / "soap" / "info.json") << "{}";
  cv::imwrite((folder / "scenes" / "1.jpg").string(), scene_with(1));
  std::ofstream(folder / "visual_annotation.json") << R"({"1": ["soap"], "back": {"1": ["soap"]}})";
  const ObjectSet set = read_object_set(folder.string());
  ASSERT_EQ(set.objects.size(), 1U) << "what has no info.json is a container";
  EXPECT_TRUE(set.scenes.at(0).present.empty());
  EXPECT_EQ(set.scenes.at(0).not_judged.count("soap"), 1U);
}

TEST(ObjectSet, TellsTheLayoutsWhereThereIsNothingAndWhatIsWrongWithTheTruth) {
  EXPECT_THROW((void)read_object_set(empty_folder("nothing").string()), UserError);
  const fs::path folder = plain_layout("wrong");
  write_truth(folder, R"({"table": "box"})");
  EXPECT_THROW((void)read_object_set(folder.string()), UserError);
  write_truth(folder, "{");
  EXPECT_THROW((void)read_object_set(folder.string()), UserError);
}

TEST(ObjectSet, TakesThePartThatDiffersFromItsBackground) {
  const cv::Rect part = region_of_object(taught(1));
  EXPECT_NEAR(part.x, 30, 3);
  EXPECT_NEAR(part.width, 180, 6);
  const cv::Mat1b everything = coarse_texture({90, 60}, 4);
  EXPECT_EQ(region_of_object(everything), cv::Rect(0, 0, 90, 60));
}

TEST(EvalObjects, StriateFindsTheObjectThatIsThereAndNotTheOther) {
  const fs::path folder = plain_layout("found");
  const ObjectSet set = read_object_set(folder.string());
  const auto methods = object_methods();
  methods[0]->teach(set.objects);
  const ObjectScores scores = methods[0]->look(set.scenes[0].grey);
  EXPECT_GT(scores.at(0), 20.0);
  EXPECT_LT(scores.at(1), 8.0);
}

TEST(EvalObjects, WritesATableAndAPlot) {
  const fs::path out = empty_folder("out");
  EXPECT_EQ(evaluate_objects({plain_layout("written").string(), out.string()}), 0);
  std::stringstream csv;
  csv << std::ifstream(out / "objects.csv").rdbuf();
  EXPECT_NE(csv.str().find("Striate"), std::string::npos);
  EXPECT_TRUE(fs::is_regular_file(out / "objects.svg"));
  EXPECT_TRUE(fs::is_regular_file(out / "objects_scores.csv"));
}

}  // namespace
}  // namespace striate::evaluation
