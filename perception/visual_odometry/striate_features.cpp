#include "striate/perception/visual_odometry/striate_features.hpp"

#include <cstring>
#include <memory>

namespace striate::perception {

StriateFeatures::StriateFeatures(const StriateFeatureSettings& settings)
    : settings_(settings),
      finder_(settings.keypoints),
      describer_(StriateSettings{.orientation = StriateOrientation::upright}) {}

void StriateFeatures::operator()(const cv::Mat1b& grey, int most, FeatureSet& out) {
  finder_.locate(grey, found_);
  std::vector<Feature> all;
  all.reserve(found_.size());
  for (const Keypoint& point : found_) {
    all.push_back({point.u_px, point.v_px, point.wavelength_px / settings_.keypoints.wavelength_px,
                   point.response});
  }
  out.features.clear();
  frames_.clear();
  for (const std::size_t k : spread_evenly(all, grey.size(), most)) {
    out.features.push_back(all[k]);
    const double diameter_px = settings_.size_per_wavelength * found_[k].wavelength_px;
    frames_.push_back({all[k].u_px, all[k].v_px, diameter_px, 0.0});
  }
  describer_.prepare(grey);
  describer_.describe(frames_, descriptors_);
  out.metric = DescriptorMetric::hamming;
  out.bytes = static_cast<int>(sizeof(Descriptor::words));
  out.most_distance = settings_.most_distance_bits;
  out.descriptors.resize(descriptors_.size() * sizeof(Descriptor::words));
  for (std::size_t k = 0; k < descriptors_.size(); ++k) {
    std::memcpy(out.descriptors.data() + k * sizeof(Descriptor::words),
                descriptors_[k].words.data(), sizeof(Descriptor::words));
  }
}

FeatureSource striate_features(const StriateFeatureSettings& settings) {
  return [finder = std::make_shared<StriateFeatures>(settings)](const cv::Mat1b& grey, int most,
                                                                FeatureSet& features) {
    (*finder)(grey, most, features);
  };
}

}  // namespace striate::perception
