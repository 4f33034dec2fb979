#pragma once

#include <memory>
#include <optional>

#include "striate/app/perceive_frame.hpp"
#include "striate/perception/percept.hpp"

namespace striate::python {

/// What one look found: the vision's percept, and where it is one of `striate perceive`, the pair
/// and all that its files are written from.
struct Seen {
  /// Of a look of `striate perceive`.
  struct Judged {
    app::PerceiveOptions options;
    StereoFrame frame;  ///< a copy of the pair as it was looked at: rectified, eyes aligned
    RobotDescription robot;
    app::ObstacleReport report;
  };
  perception::Percept percept;
  cv::Mat1f disparity_px;  ///< of the images as they were given
  std::optional<Judged> judged;
};

using SharedSeen = std::shared_ptr<const Seen>;

/// A look of a running mission. @param percept is copied; its matrices are shared
[[nodiscard]] SharedSeen seen_of(const perception::Percept& percept);

}  // namespace striate::python
