#include "striate/agent/baselines/baseline.hpp"

#include <fmt/format.h>

#include "striate/agent/baselines/sgbm_disparity.hpp"
#include "striate/agent/baselines/true_depth_images.hpp"
#include "striate/base/user_error.hpp"

namespace striate::agent {

Baseline baseline_named(const std::string& name) {
  if (name.empty()) return Baseline::own;
  if (name == "paper") return Baseline::paper;
  if (name == "sgbm") return Baseline::sgbm;
  if (name == "truth") return Baseline::truth;
  throw UserError(
      fmt::format("'--baseline {}' is not known\n    write paper, sgbm or truth", name));
}

void apply_baseline(Baseline baseline, perception::PerceptionSettings& settings) {
  if (baseline == Baseline::paper) settings.stereo.mode = perception::StereoMode::paper;
}

std::unique_ptr<perception::DisparitySource> disparities_of(
    Baseline baseline, const perception::PerceptionSettings& settings,
    const TrueDepthImages* pictures) {
  if (baseline == Baseline::sgbm) return std::make_unique<SgbmDisparity>(settings.stereo);
  if (baseline == Baseline::truth && pictures != nullptr) {
    return std::make_unique<TrueDisparity>(*pictures);
  }
  return nullptr;
}

}  // namespace striate::agent
