// Draws boxes of one brand and photographs of them, as a set that `striate eval objects` reads:
//   alike_boxes PICTURES SET [SEED [TAUGHT]]
// All ten boxes share what stands above and below; a picture in the middle is each one's own.
// TAUGHT of them (10) are taught; all stand in the thirty scenes, one in each.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "striate/base/user_error.hpp"
#include "striate/evaluation/sequence_patches.hpp"
#include "striate/platform/datasets/images/read_image.hpp"

namespace striate {
namespace {

namespace fs = std::filesystem;

constexpr int kBoxes = 10, kScenes = 30;
constexpr int kWidth_px = 360, kHeight_px = 500;  // of a box as it is taught
constexpr int kAbove_px = 150, kBelow_px = 80;    // that all share

std::vector<fs::path> shuffled_pictures(const fs::path& folder, cv::RNG& random) {
  std::vector<fs::path> files = evaluation::sorted_entries(folder);
  std::erase_if(files, [](const fs::path& file) { return !datasets::is_image(file); });
  for (std::size_t i = files.size() - 1; i > 0; --i) {
    std::swap(files[i],
              files[static_cast<std::size_t>(random.uniform(0, static_cast<int>(i) + 1))]);
  }
  return files;
}

cv::Mat3b piece_of(const fs::path& file, cv::Size size, cv::RNG& random) {
  const cv::Mat3b picture = datasets::read_any_image(file);
  const double scale =
      random.uniform(1.0, 1.8) * std::max(static_cast<double>(size.width) / picture.cols,
                                          static_cast<double>(size.height) / picture.rows);
  cv::Mat3b large;
  cv::resize(picture, large, {}, scale, scale, cv::INTER_AREA);
  const cv::Point at(random.uniform(0, large.cols - size.width + 1),
                     random.uniform(0, large.rows - size.height + 1));
  return large(cv::Rect(at, size)).clone();
}

std::vector<cv::Mat3b> draw_boxes(const std::vector<fs::path>& files, cv::RNG& random) {
  cv::Mat3b brand(kHeight_px, kWidth_px);
  piece_of(files[0], {kWidth_px, kAbove_px}, random).copyTo(brand.rowRange(0, kAbove_px));
  piece_of(files[1], {kWidth_px, kBelow_px}, random)
      .copyTo(brand.rowRange(kHeight_px - kBelow_px, kHeight_px));
  cv::putText(brand, "CRUNCHY", {20, 110}, cv::FONT_HERSHEY_DUPLEX, 2.2, {255, 255, 255}, 8);
  cv::putText(brand, "whole grain cereal 500 g", {15, kHeight_px - 30}, cv::FONT_HERSHEY_SIMPLEX,
              0.8, {0, 0, 0}, 2);
  std::vector<cv::Mat3b> boxes;
  for (std::size_t k = 0; k < kBoxes; ++k) {
    boxes.push_back(brand.clone());
    const cv::Size own(kWidth_px, kHeight_px - kAbove_px - kBelow_px);
    piece_of(files[2 + k], own, random)
        .copyTo(boxes.back().rowRange(kAbove_px, kHeight_px - kBelow_px));
  }
  return boxes;
}

/// Aslant, 170 to 340 px high, in other light, blurred and with noise.
cv::Mat3b photograph(const cv::Mat3b& box, const fs::path& wall, cv::RNG& random) {
  cv::Mat3b scene = piece_of(wall, {640, 480}, random);
  const double height = random.uniform(170.0, 340.0), width = height * kWidth_px / kHeight_px;
  const double turn = random.uniform(-0.25, 0.25);
  const double u = random.uniform(width / 2 + 20, 620 - width / 2);
  const double v = random.uniform(height / 2 + 20, std::max(height / 2 + 21, 460 - height / 2));
  std::vector<cv::Point2f> from, to;
  for (const cv::Point2d corner : {cv::Point2d(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
    from.emplace_back(corner.x * kWidth_px, corner.y * kHeight_px);
    const double x = (corner.x - 0.5) * width, y = (corner.y - 0.5) * height;
    to.emplace_back(u + std::cos(turn) * x - std::sin(turn) * y + random.gaussian(0.02 * height),
                    v + std::sin(turn) * x + std::cos(turn) * y + random.gaussian(0.02 * height));
  }
  const cv::Mat map = cv::getPerspectiveTransform(from, to);
  cv::Mat soft, drawn, mask;
  cv::GaussianBlur(box, soft, {}, 0.4 * kWidth_px / width);
  cv::warpPerspective(soft, drawn, map, scene.size());
  cv::warpPerspective(cv::Mat1b(box.size(), std::uint8_t{255}), mask, map, scene.size());
  drawn.copyTo(scene, mask);
  cv::GaussianBlur(scene, soft, {}, random.uniform(0.4, 0.9));
  cv::Mat light, noise(scene.size(), CV_32FC3);
  soft.convertTo(light, CV_32F, random.uniform(0.7, 1.15), random.uniform(-15.0, 15.0));
  random.fill(noise, cv::RNG::NORMAL, 0, random.uniform(2.0, 6.0));
  light += noise;
  light.convertTo(scene, CV_8U);
  return scene;
}

std::uint64_t whole_number(const char* word, std::uint64_t most) {
  std::uint64_t number = 0;
  const char* end = word + std::strlen(word);
  const auto [stop, wrong] = std::from_chars(word, end, number);
  if (wrong != std::errc{} || stop != end || number > most) {
    throw UserError(fmt::format("'{}' is no whole number from 0 to {}", word, most));
  }
  return number;
}

void draw_set(const fs::path& pictures, const fs::path& set, std::uint64_t seed, int taught) {
  cv::RNG random(seed);
  const std::vector<fs::path> files = shuffled_pictures(pictures, random);
  if (files.size() < 2 + kBoxes + kScenes) {
    throw UserError(fmt::format("{}: {} pictures are needed, {} are there", pictures.string(),
                                2 + kBoxes + kScenes, files.size()));
  }
  const std::vector<cv::Mat3b> boxes = draw_boxes(files, random);
  for (int k = 0; k < taught; ++k) {
    fs::create_directories(set / fmt::format("objects/box{}", k));
    cv::imwrite(set / fmt::format("objects/box{}/front.png", k),
                boxes[static_cast<std::size_t>(k)]);
  }
  fs::create_directories(set / "scenes");
  std::ofstream truth(set / "truth.json");
  for (int k = 0; k < kScenes; ++k) {
    const int which = random.uniform(0, kBoxes);
    const cv::Mat3b scene = photograph(boxes[static_cast<std::size_t>(which)],
                                       files[static_cast<std::size_t>(2 + kBoxes + k)], random);
    cv::imwrite(set / fmt::format("scenes/{}.png", k), scene);
    truth << (k > 0 ? ", " : "{")
          << (which < taught ? fmt::format("\"{}\": [\"box{}\"]", k, which)
                             : fmt::format("\"{}\": []", k));
  }
  truth << "}\n";
  truth.close();
  if (!truth) throw UserError(set.string() + ": cannot be written");
}

}  // namespace
}  // namespace striate

int main(int count, char** words) {
  if (count < 3 || count > 5) {
    fmt::print(stderr, "usage: alike_boxes PICTURES SET [SEED [TAUGHT]]\n");
    return 2;
  }
  try {
    const auto seed = count > 3 ? striate::whole_number(words[3], UINT64_MAX) : 1U;
    const auto taught =
        count > 4 ? striate::whole_number(words[4], striate::kBoxes) : striate::kBoxes;
    striate::draw_set(words[1], words[2], seed, static_cast<int>(taught));
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 2;
  }
  return 0;
}
