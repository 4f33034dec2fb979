#include "striate/perception/keypoints/keypoints.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "striate/base/user_error.hpp"

namespace striate::perception {
namespace {

/// Of the finest scale, in pixels of the level that is worked on.
double first_wavelength(const KeypointSettings& s) {
  const double wavelength_px = s.wavelength_px / (s.halve ? 2.0 : 1.0);
  const double largest_px = s.scales > 1 ? 12.0 / std::numbers::sqrt2 : 12.0;
  if (!(wavelength_px >= 3.0 && wavelength_px <= largest_px)) {
    throw UserError(
        "keypoints: the wavelength on the image that is worked on must be 3 .. 12 px "
        "(.. 8.4 px with several scales)");
  }
  if (s.most < 1) throw UserError("keypoints: 'most' must be at least 1");
  if (s.scales < 1 || s.scales > 13) throw UserError("keypoints: 'scales' must be 1 .. 13");
  return wavelength_px;
}

/// Level of the pyramid of a scale: two scales a level.
int level_of(const KeypointSettings& s, int scale) {
  return scale / 2 + (s.halve ? 1 : 0);
}

void halve(const cv::Mat1b& grey, cv::Mat1b& out) {
  // An odd last row or column is left out: pixels must stay where they are.
  const cv::Size half(std::max(1, grey.cols / 2), std::max(1, grey.rows / 2));
  const cv::Rect even(0, 0, std::min(grey.cols, 2 * half.width),
                      std::min(grey.rows, 2 * half.height));
  cv::resize(grey(even), out, half, 0, 0, cv::INTER_AREA);
}

bool stronger(const Candidate& a, const Candidate& b) {
  if (a.response != b.response) return a.response > b.response;
  if (a.scale != b.scale) return a.scale < b.scale;
  return a.v_px != b.v_px ? a.v_px < b.v_px : a.u_px < b.u_px;
}

}  // namespace

KeypointFinder::KeypointFinder(const KeypointSettings& settings) : settings_(settings) {
  const double first_px = first_wavelength(settings);
  for (int k = 0; k < settings.scales; ++k) {
    scales_.emplace_back(k, first_px * (k % 2 == 0 ? 1.0 : std::numbers::sqrt2), settings);
  }
  pyramid_.resize(static_cast<std::size_t>(level_of(settings, settings.scales - 1)) + 1);
}

/// Pixels of the given image in a pixel of the level of a scale.
double KeypointFinder::level_px(int scale) const {
  return std::ldexp(1.0, level_of(settings_, scale));
}

void KeypointFinder::build_pyramid(const cv::Mat1b& grey) {
  pyramid_[0] = grey;
  for (std::size_t k = 1; k < pyramid_.size(); ++k) halve(pyramid_[k - 1], pyramid_[k]);
}

/// Of all candidates the strongest that are apart.
void KeypointFinder::choose(cv::Size image) {
  const auto most = static_cast<std::size_t>(settings_.most);
  if (scales_.size() == 1 || settings_.apart <= 0.0) {
    const std::size_t kept = std::min(most, candidates_.size());
    std::partial_sort(candidates_.begin(), candidates_.begin() + static_cast<std::ptrdiff_t>(kept),
                      candidates_.end(), stronger);
    candidates_.resize(kept);
    return;
  }
  std::sort(candidates_.begin(), candidates_.end(), stronger);
  const double radius_px = settings_.apart * settings_.wavelength_px;
  keep_apart_.begin(image.width, image.height, radius_px, settings_.scales);
  std::size_t kept = 0;
  for (const Candidate& candidate : candidates_) {
    const double size_px = level_px(candidate.scale);
    const FoundPlace place{(candidate.u_px + 0.5) * size_px, (candidate.v_px + 0.5) * size_px,
                           radius_px * std::pow(2.0, 0.5 * candidate.scale)};
    if (kept < most && keep_apart_.keep(place, candidate.scale)) candidates_[kept++] = candidate;
  }
  candidates_.resize(kept);
}

void KeypointFinder::find(const cv::Mat1b& grey, std::vector<Keypoint>& out) {
  locate(grey, out);
  for (std::size_t k = 0; k < out.size(); ++k) {
    const Candidate& candidate = candidates_[k];
    out[k].descriptor = scales_[static_cast<std::size_t>(candidate.scale)].describe(candidate);
  }
}

void KeypointFinder::locate(const cv::Mat1b& grey, std::vector<Keypoint>& out) {
  if (grey.empty()) throw std::invalid_argument("KeypointFinder: the image is empty");
  build_pyramid(grey);
  candidates_.clear();
  for (int k = 0; k < settings_.scales; ++k) {
    scales_[static_cast<std::size_t>(k)].find(
        pyramid_[static_cast<std::size_t>(level_of(settings_, k))], candidates_);
  }
  choose(grey.size());
  pyramid_[0].release();
  out.clear();
  for (const Candidate& candidate : candidates_) {
    // A pixel of a halved image is the mean of 2x2: its centre lies between them.
    const double size_px = level_px(candidate.scale);
    Keypoint& point = out.emplace_back();
    point.u_px = (candidate.u_px + 0.5) * size_px - 0.5;
    point.v_px = (candidate.v_px + 0.5) * size_px - 0.5;
    point.wavelength_px = settings_.wavelength_px * std::pow(2.0, 0.5 * candidate.scale);
    point.response = candidate.response;
  }
}

std::vector<Keypoint> KeypointFinder::find(const cv::Mat1b& grey) {
  std::vector<Keypoint> found;
  find(grey, found);
  return found;
}

std::vector<Keypoint> find_keypoints(const cv::Mat1b& grey, const KeypointSettings& settings) {
  return KeypointFinder(settings).find(grey);
}

}  // namespace striate::perception
