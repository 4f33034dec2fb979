#include "striate/perception/saliency/saliency.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "striate/perception/saliency/blob_response.hpp"

namespace striate::perception {
namespace {

cv::Mat1f near_disparity(const DisparityMap& map, cv::Size half, const SaliencySettings& settings) {
  cv::Mat1f near(map.disparity_px.size(), 0.0F);
  for (int v = 0; v < near.rows; ++v) {
    for (int u = 0; u < near.cols; ++u) {
      const float d = map.disparity_px(v, u);
      if (std::isfinite(d) && d > settings.near_px) {
        near(v, u) = static_cast<float>(settings.near_gain) * d;
      }
    }
  }
  cv::resize(near, near, half, 0, 0, cv::INTER_AREA);
  return near;
}

cv::Size half_of(const cv::Mat3b& image) {
  return {(image.cols + 1) / 2, (image.rows + 1) / 2};
}

void add_colour(const cv::Mat3b& image, cv::Mat1f& sum) {
  cv::Mat small;
  cv::resize(image, small, sum.size(), 0, 0, cv::INTER_AREA);
  small.convertTo(small, CV_32FC3, 1.0 / 255.0);
  cv::cvtColor(small, small, cv::COLOR_BGR2Lab);
  std::array<cv::Mat1f, 3> lab;
  cv::split(small, lab.data());
  for (const cv::Mat1f& plane : lab) add_blob_response(plane, Rectify::both, sum);
}

cv::Mat1f sum_of_maps(const cv::Mat3b& image, const DisparityMap& map,
                      const SaliencySettings& settings) {
  const cv::Size half = half_of(image);
  cv::Mat1f sum(half, 0.0F);
  add_colour(image, sum);
  if (!map.disparity_px.empty()) {
    add_blob_response(near_disparity(map, half, settings), Rectify::half, sum);
  }
  cv::resize(sum, sum, image.size(), 0, 0, cv::INTER_LINEAR);
  return sum;
}

double median_disparity(const DisparityMap& map, const cv::Mat1i& labels, int label, cv::Rect box) {
  std::vector<float> values;
  if (map.disparity_px.empty()) return 0.0;
  for (int v = box.y; v < box.y + box.height; ++v) {
    for (int u = box.x; u < box.x + box.width; ++u) {
      const float d = map.disparity_px(v, u);
      if (labels(v, u) == label && std::isfinite(d) && d > 0.0F) values.push_back(d);
    }
  }
  // A tenth of the region must be known, else the distance would be that of a stray pixel.
  if (values.empty() || values.size() * 10 < static_cast<std::size_t>(box.area())) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

SalientRegion describe_region(const SaliencyMap& map, cv::Rect box, const cv::Mat1b& mask,
                              const ViewGeometry& geometry, double disparity_px) {
  SalientRegion region;
  region.u_px = box.x + 0.5 * (box.width - 1);
  region.v_px = box.y + 0.5 * (box.height - 1);
  region.width_px = box.width;
  region.height_px = box.height;
  cv::minMaxLoc(map.salience(box), nullptr, &region.salience, nullptr, nullptr, mask);
  if (geometry.focal_px() > 0.0) region.bearing_rad = geometry.ray_bearing_rad(region.u_px);
  if (disparity_px > 0.0 && geometry.focal_baseline() > 0.0) {
    const SpacePoint p = geometry.point(region.u_px, region.v_px, disparity_px);
    region.distance_m = std::hypot(p.x_m, p.y_m);
    region.bearing_rad = std::atan2(p.y_m, p.x_m);
  }
  return region;
}

void normalise_and_cut(const ViewGeometry& geometry, const DisparityMap& map,
                       const SaliencySettings& settings, SaliencyMap& result) {
  double highest = 0.0;
  cv::minMaxLoc(result.salience, nullptr, &highest);
  const double scale = std::max(highest, settings.least_contrast);
  if (scale > 0.0) result.salience *= 1.0 / scale;

  cv::Mat1i labels;
  cv::Mat stats;
  cv::Mat centroids;
  const int count = cv::connectedComponentsWithStats(result.salience >= settings.threshold, labels,
                                                     stats, centroids);
  for (int label = 1; label < count; ++label) {
    const int* s = stats.ptr<int>(label);
    if (s[cv::CC_STAT_AREA] < settings.smallest_px) continue;
    const cv::Rect box(s[cv::CC_STAT_LEFT], s[cv::CC_STAT_TOP], s[cv::CC_STAT_WIDTH],
                       s[cv::CC_STAT_HEIGHT]);
    const cv::Mat1b mask = labels(box) == label;
    result.regions.push_back(
        describe_region(result, box, mask, geometry, median_disparity(map, labels, label, box)));
  }
  std::stable_sort(
      result.regions.begin(), result.regions.end(),
      [](const SalientRegion& a, const SalientRegion& b) { return a.salience > b.salience; });
  const auto most = static_cast<std::size_t>(settings.most_regions);
  if (result.regions.size() > most) result.regions.resize(most);
}

}  // namespace

/// Sigma of the preference for the middle, of width and height: 0.14 is left where a side's middle
/// is (ours). Judged as "centre prior" in tests/evaluation, Saliency.
constexpr double kCentreSigma = 0.25;

void prefer_centre(double share, cv::Mat1f& salience) {
  for (int v = 0; v < salience.rows; ++v) {
    const double y = (v + 0.5) / salience.rows - 0.5;
    for (int u = 0; u < salience.cols; ++u) {
      const double x = (u + 0.5) / salience.cols - 0.5;
      const double prior = std::exp(-0.5 * (x * x + y * y) / (kCentreSigma * kCentreSigma));
      salience(v, u) *= static_cast<float>(1.0 - share + share * prior);
    }
  }
}

SaliencyMap find_salience(const cv::Mat3b& image, const DisparityMap& map,
                          const ViewGeometry& geometry, const SaliencySettings& settings) {
  SaliencyMap result;
  if (image.empty()) return result;
  result.salience = sum_of_maps(image, map, settings);
  normalise_and_cut(geometry, map, settings, result);
  return result;
}

SaliencyFinder::SaliencyFinder(const SaliencySettings& settings)
    : settings_(settings), cells_(V1Settings{}) {}

/// Adds `channel_`, weighted, in units of its mean. Below `least_mean` it is noise and counts less.
void SaliencyFinder::add_channel(double weight, double least_mean) {
  const double mean = cv::mean(channel_)[0];
  sum_ += weight / std::max(mean, least_mean) * channel_;
}

void SaliencyFinder::add_v1_channels(const cv::Mat1b& grey) {
  // Grey levels, summed over 8 orientations and 2 scales: keeps a blank wall's noise dim (ours)
  constexpr double kLeastTexture = 3.0;
  // Grey levels, summed over 8 orientations and 3 radii: keeps a blank wall's noise dim (ours)
  constexpr double kLeastShape = 12.0;
  cells_.respond(grey, 0, false, responses_);
  v1_channels_.average(responses_);
  if (settings_.texture > 0.0) {
    v1_channels_.texture(channel_);
    add_channel(settings_.texture, kLeastTexture);
  }
  if (settings_.shape > 0.0) {
    v1_channels_.shape(channel_);
    add_channel(settings_.shape, kLeastShape);
  }
}

void SaliencyFinder::add_motion(const cv::Mat1b& grey) {
  cv::Mat1b small;
  cv::resize(grey, small, half_.size(), 0, 0, cv::INTER_AREA);
  small.convertTo(small_grey_, CV_32F);
  half_.setTo(0.0F);
  change_.add(small_grey_, half_);
  cv::resize(half_, channel_, sum_.size(), 0, 0, cv::INTER_AREA);
  add_channel(settings_.motion, settings_.least_contrast);
}

void SaliencyFinder::sum_of_channels(const cv::Mat3b& image, const DisparityMap& map) {
  half_.create(half_of(image));
  sum_.create(quarter_of(image.size()));
  sum_.setTo(0.0F);
  const auto add_half = [&](double weight) {
    cv::resize(half_, channel_, sum_.size(), 0, 0, cv::INTER_AREA);
    add_channel(weight, settings_.least_contrast);
  };
  if (settings_.colour > 0.0) {
    half_.setTo(0.0F);
    add_colour(image, half_);
    add_half(settings_.colour);
  }
  cv::Mat1b grey;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  if (settings_.texture > 0.0 || settings_.shape > 0.0) add_v1_channels(grey);
  if (settings_.near > 0.0 && !map.disparity_px.empty()) {
    half_.setTo(0.0F);
    add_blob_response(near_disparity(map, half_.size(), settings_), Rectify::half, half_);
    add_half(settings_.near);
  }
  if (settings_.motion > 0.0) add_motion(grey);
}

SaliencyMap SaliencyFinder::find(const cv::Mat3b& image, const DisparityMap& map,
                                 const ViewGeometry& geometry) {
  if (image.empty() || settings_.mode == SaliencyMode::paper) {
    return find_salience(image, map, geometry, settings_);
  }
  sum_of_channels(image, map);
  sum_ = sum_.mul(sum_);
  const double sigma_px = std::max(0.3, 0.25 * settings_.smooth_px * image.cols / 160.0);
  if (smooth_.sigma_px() != sigma_px) smooth_ = Gaussian(sigma_px);
  smooth_.blur(sum_, sum_);
  SaliencyMap result;
  cv::resize(sum_, result.salience, image.size(), 0, 0, cv::INTER_LINEAR);
  if (settings_.centre > 0.0) prefer_centre(settings_.centre, result.salience);
  SaliencySettings cut = settings_;
  cut.least_contrast = 1.0;                                   // in units of the channels' means
  cut.threshold = settings_.threshold * settings_.threshold;  // of the square
  normalise_and_cut(geometry, map, cut, result);
  return result;
}

}  // namespace striate::perception
