#pragma once

#include <future>
#include <string>

#include "striate/perception/stereo/pair_check.hpp"
#include "striate/platform/interface/senses.hpp"

namespace striate::app {

/// Looks at the first images of a run for eyes that are exchanged, identical or not rectified. On a
/// thread of its own, with copies: it decides nothing, and no cycle waits for it.
class PairWatch {
 public:
  /// After each cycle. Copies two images a few times in a run.
  void take(const StereoFrame& frame);
  /// What is wrong with the pair, once, as soon as it is known; "" before, afterwards, and where
  /// nothing is.
  [[nodiscard]] std::string news();
  /// The same at the end of a run, which waits for what is being looked at.
  [[nodiscard]] std::string finish();

 private:
  [[nodiscard]] std::string judge();

  std::future<perception::PairCheck> looking_;
  perception::PairCheck seen_;
  TimePoint last_;
  double width_px_ = 0.0;
  int looks_ = 0;
  bool told_ = false;
};

}  // namespace striate::app
