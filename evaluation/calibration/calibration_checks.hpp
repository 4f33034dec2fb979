#pragma once

#include <vector>

#include "striate/evaluation/calibration/calibration_report.hpp"
#include "striate/evaluation/calibration/chessboard.hpp"

/// What a calibration must show before it is believed.
namespace striate::evaluation {

/// Index of the pair that is far worse than the others; as many as there are pairs: none is.
[[nodiscard]] std::size_t far_worse(const std::vector<PairError>& pairs);

[[nodiscard]] std::vector<PairError> left_out_of(const std::vector<BoardPair>& all,
                                                 const CalibrationReport& report,
                                                 const Chessboard& board);

void check_agreeing(const std::vector<BoardPair>& kept, const std::vector<BoardPair>& all);

void check_exact(const CalibrationReport& report);

void check_enough(const std::vector<BoardPair>& pairs);

}  // namespace striate::evaluation
