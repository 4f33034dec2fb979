// Keypoints of two images are described and matched, and counted where we know what is right.
#include <cmath>
#include <cstdio>
#include <exception>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "striate/perception/matching/descriptor_store.hpp"
#include "striate/perception/matching/hamming_search.hpp"
#include "striate/perception/recognition/oriented_keypoints.hpp"

namespace {

constexpr double kTurn_deg = 30.0, kScale = 0.8;  // of the second image against the first
constexpr double kRatio = 0.7;     // the nearest must be that much nearer than the second
constexpr double kRight_px = 5.0;  // a match counts as right when it is so near the truth

/// Something to look at: overlapping rectangles, circles and letters, the same ones every time.
cv::Mat1b paint() {
  cv::Mat1b image(480, 640, std::uint8_t{128});
  cv::RNG random(7);
  for (int i = 0; i < 150; ++i) {
    const cv::Point at(random.uniform(0, 640), random.uniform(0, 480));
    const cv::Size size(random.uniform(10, 90), random.uniform(10, 90));
    const cv::Scalar grey(random.uniform(0, 256));
    if (i % 3 == 0) cv::rectangle(image, {at, size}, grey, cv::FILLED, cv::LINE_AA);
    if (i % 3 == 1) cv::circle(image, at, size.width / 2, grey, cv::FILLED, cv::LINE_AA);
    const char letter[] = {static_cast<char>('A' + i % 26), '\0'};
    if (i % 3 == 2) cv::putText(image, letter, at, cv::FONT_HERSHEY_DUPLEX, 3.0, grey, 8);
  }
  return image;
}

}  // namespace

int main(int count, char** words) try {
  namespace perception = striate::perception;
  const std::string folder = count > 1 ? words[1] : ".";
  const cv::Mat1b first = paint();
  const cv::Matx23d truth = cv::getRotationMatrix2D({320.0F, 240.0F}, kTurn_deg, kScale);
  cv::Mat1b second;
  cv::warpAffine(first, second, truth, first.size(), cv::INTER_AREA, cv::BORDER_CONSTANT, 128);

  perception::OrientedKeypoints describe{perception::OrientedSettings{}};
  const std::vector<perception::Keypoint> known = describe(first);
  const std::vector<perception::Keypoint> seen = describe(second);
  perception::DescriptorStore store;
  for (const perception::Keypoint& point : known) store.append(point.descriptor);
  std::vector<perception::Descriptor> queries;
  for (const perception::Keypoint& point : seen) queries.push_back(point.descriptor);

  cv::Mat picture;
  cv::hconcat(first, second, picture);
  cv::cvtColor(picture, picture, cv::COLOR_GRAY2BGR);
  int matches = 0, right = 0;
  perception::HammingSearch search;
  const auto nearest = search.nearest_two(queries, store);
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    const perception::NearestTwo& near = nearest[i];
    if (near.first_bits > kRatio * near.second_bits) continue;
    const perception::Keypoint& from = known[near.first];
    const cv::Point2d expected(truth * cv::Vec3d(from.u_px, from.v_px, 1.0));
    const bool good = std::hypot(expected.x - seen[i].u_px, expected.y - seen[i].v_px) < kRight_px;
    ++matches;
    right += good ? 1 : 0;
    const cv::Point2d to(640 + seen[i].u_px, seen[i].v_px);
    const cv::Scalar colour = good ? cv::Scalar(80, 200, 80) : cv::Scalar(60, 60, 230);
    cv::line(picture, cv::Point2d(from.u_px, from.v_px), to, colour);
  }
  std::printf("%zu and %zu keypoints: ", known.size(), seen.size());
  std::printf("%d matches, %d of them right\n", matches, right);
  if (!cv::imwrite(folder + "/matches.png", picture)) return 1;
  return matches >= 50 && right >= matches * 9 / 10 ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
