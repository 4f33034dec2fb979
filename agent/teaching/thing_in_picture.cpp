#include "striate/agent/teaching/thing_in_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "striate/agent/teaching/image_view.hpp"

namespace striate::agent {
namespace {

// Chosen by hand on made-up pictures and some of jsk_arc2017: whatever is doubtful is kept whole.

/// px, the longer side: a third of a second, and edges within 3 px of 640 (by hand)
constexpr int kCutSide_px = 240;
/// The edge that is ground is 1 / 25 of the shorter side (by hand)
constexpr int kRingShare = 25;
/// Half axes of the middle that is figure, of the sides (by hand)
constexpr double kFigure = 0.32;
/// Times; GrabCut settles within five or six (by hand)
constexpr int kCutRounds = 6;
/// Of the picture: what is smaller is a label, not the thing (by hand)
constexpr double kLeastShare = 0.08;
/// Of the picture: beyond it there is little table left to lose (by hand)
constexpr double kMostShare = 0.7;
/// Share of the convex hull's area: books, boxes and bottles have more (by hand)
constexpr double kCompact = 0.9;
/// Bhattacharyya distance, 0..1: things on tables have 0.84 to 0.97, wrong pieces of photos most
/// often 0.4 to 0.81 (by hand)
constexpr double kOtherColours = 0.83;
/// Share of all corners: with fewer the rest does no harm (by hand)
constexpr double kRestCorners = 0.2;
/// Share of all corners on one side: with more it has a pattern (by hand)
constexpr double kSideCorners = 0.03;
/// In all of the picture: with fewer it is plain, and GrabCut takes seconds for plain ones (by
/// hand)
constexpr std::size_t kFewestToCut = 30;
/// Of four: a title under a picture is on one or two, and a thing may hide one (by hand)
constexpr int kPatternedSides = 3;

/// GrabCut's clusters begin at random places, of OpenCV's own numbers: always the same ones here.
class FixedRandom {
 public:
  FixedRandom() : before_(cv::theRNG().state) { cv::theRNG().state = 7; }
  ~FixedRandom() { cv::theRNG().state = before_; }
  FixedRandom(const FixedRandom&) = delete;
  FixedRandom& operator=(const FixedRandom&) = delete;

 private:
  std::uint64_t before_;
};

cv::Mat1b figure_of(const cv::Mat3b& image) {
  cv::Mat1b mask(image.size(), static_cast<uchar>(cv::GC_PR_BGD));
  const int ring = std::max(2, std::min(image.cols, image.rows) / kRingShare);
  cv::ellipse(mask, cv::Point(image.cols / 2, image.rows / 2),
              cv::Size(cvRound(kFigure * image.cols), cvRound(kFigure * image.rows)), 0, 0, 360,
              cv::Scalar(cv::GC_PR_FGD), cv::FILLED);
  cv::rectangle(mask, cv::Rect(0, 0, image.cols, image.rows), cv::Scalar(cv::GC_BGD), ring);
  cv::Mat3b smooth;
  cv::medianBlur(image, smooth, 3);
  cv::Mat ground;
  cv::Mat figure;
  const FixedRandom fixed;
  cv::grabCut(smooth, mask, cv::Rect(), ground, figure, kCutRounds, cv::GC_INIT_WITH_MASK);
  cv::Mat1b result = (mask == cv::GC_FGD) | (mask == cv::GC_PR_FGD);
  cv::morphologyEx(result, result, cv::MORPH_OPEN, cv::Mat(), cv::Point(-1, -1), 2);
  return result;
}

/// The largest piece's convex hull; empty where it is no compact piece.
cv::Mat1b compact_piece(const cv::Mat1b& figure) {
  std::vector<std::vector<cv::Point>> pieces;
  cv::findContours(figure.clone(), pieces, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_SIMPLE);
  if (pieces.empty()) return {};
  const auto area = [](const std::vector<cv::Point>& piece) { return cv::contourArea(piece); };
  const auto largest = std::ranges::max_element(pieces, {}, area);
  std::vector<cv::Point> hull;
  cv::convexHull(*largest, hull);
  if (area(*largest) < kCompact * std::max(1.0, area(hull))) return {};
  cv::Mat1b piece(figure.size(), uchar{0});
  cv::fillConvexPoly(piece, hull, cv::Scalar(255));
  return piece;
}

cv::Mat colours_of(const cv::Mat3b& lab, const cv::Mat1b& where) {
  constexpr int kBins =
      8;  // of a channel, 32 of its 256 steps each: noise moves few colours (by hand)
  const int channels[] = {0, 1, 2};
  const int bins[] = {kBins, kBins, kBins};
  const float range[] = {0.0F, 256.0F};
  const float* ranges[] = {range, range, range};
  cv::Mat histogram;
  cv::calcHist(&lab, 1, channels, where, histogram, 3, bins, ranges);
  cv::normalize(histogram, histogram, 1.0, 0.0, cv::NORM_L1);
  return histogram;
}

bool is_of_other_colours(const cv::Mat3b& image, const cv::Mat1b& piece) {
  cv::Mat3b lab;
  cv::cvtColor(image, lab, cv::COLOR_BGR2Lab);
  return cv::compareHist(colours_of(lab, piece), colours_of(lab, ~piece),
                         cv::HISTCMP_BHATTACHARYYA) > kOtherColours;
}

std::vector<perception::Keypoint> picture_corners(const cv::Mat3b& image) {
  cv::Mat1b grey;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  return keypoints_to_learn(grey);
}

/// Corners all round, as a table has them and the plain rest of a cover has not.
bool has_patterned_rest(const cv::Mat3b& image, const std::vector<perception::Keypoint>& points,
                        const cv::Mat1b& piece) {
  std::array<int, 4> sides{};
  for (const perception::Keypoint& point : points) {
    const int u = std::clamp(cvRound(point.u_px), 0, image.cols - 1);
    const int v = std::clamp(cvRound(point.v_px), 0, image.rows - 1);
    if (piece(v, u) != 0) continue;
    const double x = point.u_px / image.cols - 0.5;
    const double y = point.v_px / image.rows - 0.5;
    const bool aside = std::abs(x) > std::abs(y);
    ++sides.at((aside ? 0U : 2U) + ((aside ? x : y) > 0.0 ? 1U : 0U));
  }
  const auto all = static_cast<double>(points.size());
  const int rest = sides[0] + sides[1] + sides[2] + sides[3];
  const auto patterned =
      std::ranges::count_if(sides, [all](int side) { return side > kSideCorners * all; });
  return rest > kRestCorners * all && patterned >= kPatternedSides;
}

}  // namespace

std::optional<ThingInPicture> find_thing(const cv::Mat3b& image) {
  const double scale =
      std::min(1.0, static_cast<double>(kCutSide_px) / std::max(image.cols, image.rows));
  const cv::Size size(cvRound(scale * image.cols), cvRound(scale * image.rows));
  constexpr int kShortest_px = 64;  // a strip has no middle and no edge
  if (std::min(size.width, size.height) < kShortest_px) return std::nullopt;
  cv::Mat3b small;
  cv::resize(image, small, size, 0.0, 0.0, cv::INTER_AREA);
  const std::vector<perception::Keypoint> corners = picture_corners(small);
  if (corners.size() < kFewestToCut) return std::nullopt;
  const cv::Mat1b piece = compact_piece(figure_of(small));
  if (piece.empty()) return std::nullopt;
  const double share =
      static_cast<double>(cv::countNonZero(piece)) / static_cast<double>(piece.total());
  if (share < kLeastShare || share > kMostShare) return std::nullopt;
  if (!is_of_other_colours(small, piece) || !has_patterned_rest(small, corners, piece))
    return std::nullopt;
  cv::Mat1b whole;
  cv::resize(piece, whole, image.size(), 0.0, 0.0, cv::INTER_NEAREST);
  const cv::Rect box = cv::boundingRect(whole);
  return ThingInPicture{box, whole(box).clone(), share};
}

}  // namespace striate::agent
