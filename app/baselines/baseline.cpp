#include "app/baselines/baseline.hpp"

#include <fmt/format.h>

#include "app/baselines/sgbm_disparity.hpp"
#include "app/baselines/true_depth_pictures.hpp"
#include "base/user_error.hpp"

namespace striate {

Baseline baseline_named(const std::string& name) {
  if (name.empty()) return Baseline::own;
  if (name == "paper") return Baseline::paper;
  if (name == "sgbm") return Baseline::sgbm;
  if (name == "truth") return Baseline::truth;
  throw UserError(
      fmt::format("'--baseline {}' is not known\n    write paper, sgbm or truth", name));
}

void apply_baseline(Baseline baseline, PerceptionSettings& settings) {
  if (baseline == Baseline::paper) settings.stereo.setting = StereoSetting::paper;
}

std::unique_ptr<DisparitySource> disparities_of(Baseline baseline,
                                                const PerceptionSettings& settings,
                                                const TrueDepthPictures* pictures) {
  if (baseline == Baseline::sgbm) return std::make_unique<SgbmDisparity>(settings.stereo);
  if (baseline == Baseline::truth && pictures != nullptr) {
    return std::make_unique<TrueDisparity>(*pictures);
  }
  return nullptr;
}

}  // namespace striate
