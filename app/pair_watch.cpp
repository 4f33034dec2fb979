#include "striate/app/pair_watch.hpp"

#include <chrono>
#include <opencv2/imgproc.hpp>

namespace striate::app {
namespace {

/// Images of a run: one alone may show a bare wall
constexpr int kPairLooks = 5;
/// Apart, so that they show something else (by hand)
constexpr Duration kBetweenLooks = std::chrono::seconds(1);

perception::PairCheck look_at_pair(const cv::Mat3b& left, const cv::Mat3b& right) {
  cv::Mat1b grey_left;
  cv::Mat1b grey_right;
  cv::cvtColor(left, grey_left, cv::COLOR_BGR2GRAY);
  cv::cvtColor(right, grey_right, cv::COLOR_BGR2GRAY);
  return perception::check_pair(grey_left, grey_right);
}

bool is_ready(const std::future<perception::PairCheck>& looking) {
  return looking.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

}  // namespace

void PairWatch::take(const StereoFrame& frame) {
  const bool is_new = looks_ == 0 || frame.stamp - last_ >= kBetweenLooks;
  if (looks_ >= kPairLooks || looking_.valid() || !is_new) return;
  if (frame.left.empty() || frame.right.size() != frame.left.size()) return;
  last_ = frame.stamp;
  width_px_ = frame.left.cols;
  ++looks_;
  looking_ = std::async(std::launch::async, look_at_pair, frame.left.clone(), frame.right.clone());
}

std::string PairWatch::news() {
  if (!looking_.valid() || !is_ready(looking_)) return {};
  seen_.add(looking_.get());
  return judge();
}

std::string PairWatch::finish() {
  if (looking_.valid()) seen_.add(looking_.get());
  return judge();
}

std::string PairWatch::judge() {
  if (told_) return {};
  const std::string text = perception::fault_text(seen_, width_px_);
  if (text.empty()) return {};
  told_ = true;
  return "warning: " + text + "; " + perception::fault_hint(perception::fault_of(seen_));
}

}  // namespace striate::app
