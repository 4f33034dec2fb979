#pragma once

#include <memory>
#include <string>

#include "striate/perception/perception.hpp"
#include "striate/perception/stereo/disparity_source.hpp"
#include "striate/platform/simulator/render/camera_settings.hpp"

namespace striate::agent {

class TrueDepthImages;

/// Whose disparities the robot drives by; own: Striate's.
enum class Baseline { own, paper, sgbm, truth };

/// "" is Striate's own. @throws UserError for a name that is none.
[[nodiscard]] Baseline baseline_named(const std::string& name);

/// What differs in perception's settings: the paper's stereo and obstacles are built in.
void apply_baseline(Baseline baseline, perception::PerceptionSettings& settings);

/// The disparities of `sgbm`, or of `truth` from the images that remember their depth; null for
/// those that perception makes itself.
[[nodiscard]] std::unique_ptr<perception::DisparitySource> disparities_of(
    Baseline baseline, const perception::PerceptionSettings& settings,
    const TrueDepthImages* pictures);

}  // namespace striate::agent
