#include "striate/evaluation/calibration/calibration_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <opencv2/calib3d.hpp>

#include "striate/base/user_error.hpp"
#include "striate/evaluation/calibration/consistent_pairs.hpp"
#include "striate/evaluation/calibration/row_errors.hpp"

namespace striate::evaluation {
namespace {

constexpr const char* kMoment =
    "\n  hint: both images of a pair must be taken at the same moment, of a board that does not "
    "move and lies flat on something stiff";

}  // namespace

std::size_t far_worse(const std::vector<PairError>& pairs) {
  std::vector<double> errors_px;
  for (const PairError& pair : pairs) {
    errors_px.push_back(std::max(pair.reprojection_px, pair.epipolar_px));
  }
  const auto worst = std::ranges::max_element(errors_px);
  if (*worst <= limit_of(errors_px)) return pairs.size();
  return static_cast<std::size_t>(worst - errors_px.begin());
}

std::vector<PairError> left_out_of(const std::vector<BoardPair>& all,
                                   const CalibrationReport& report, const Chessboard& board) {
  std::vector<PairError> result;
  const Rectification rectified = rectification_of(report.calibration);
  for (const BoardPair& pair : all) {
    if (std::ranges::find(report.pairs, pair.name, &PairError::name) != report.pairs.end()) {
      continue;
    }
    const double squared = squared_heights(pair, report.calibration, rectified);
    result.push_back({pair.name, disagreement_px(pair, board, report.calibration),
                      std::sqrt(squared / static_cast<double>(pair.left_px.size()))});
  }
  std::ranges::sort(result, std::greater<>(), &PairError::reprojection_px);
  return result;
}

void check_agreeing(const std::vector<BoardPair>& kept, const std::vector<BoardPair>& all) {
  if (kept.size() >= kFewestBoardPairs && 2 * kept.size() > all.size()) return;
  std::string others;
  for (const BoardPair& pair : all) {
    if (std::ranges::find(kept, pair.name, &BoardPair::name) != kept.end()) continue;
    others += (others.empty() ? "" : ", ") + pair.name;
  }
  throw UserError(
      fmt::format("of {} pairs no more than {} agree on how the two cameras stand to each other; "
                  "at least {} are needed, and more than half. These do not: {}{}",
                  all.size(), kept.size(), kFewestBoardPairs, others, kMoment));
}

void check_exact(const CalibrationReport& report) {
  const double error = pioneer::error_px(report.calibration);
  if (pioneer::exactness_of(error) != pioneer::Exactness::useless) return;
  throw UserError(
      fmt::format("the calibration errs by {:.1f} px, with which no picture is matched rightly; up "
                  "to {:.0f} px "
                  "can be used, below 0.5 px is usual. The worst pairs: {}{}",
                  error, pioneer::kUseless_px, worst_of(report.pairs), kMoment));
}

void check_enough(const std::vector<BoardPair>& pairs) {
  if (pairs.size() >= kFewestBoardPairs) return;
  throw UserError(
      fmt::format("{} pairs show the whole board in both images, {} are needed\n"
                  "  hint: 15 to 30, near and far, tilted, and in all corners of the image",
                  pairs.size(), kFewestBoardPairs));
}

}  // namespace striate::evaluation
