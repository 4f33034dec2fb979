#include <fmt/format.h>

#include "striate/base/user_error.hpp"
#include "striate/platform/datasets/images/read_image.hpp"
#include "striate/platform/datasets/sequences/asked_moments.hpp"
#include "striate/platform/datasets/sequences/opened_sequences.hpp"

namespace striate::datasets {
namespace {

constexpr double kNs_per_s = 1e9;

class PictureSequence final : public Sequence {
 public:
  PictureSequence(PictureList list, FoundCalibration found, const SequenceOptions& options)
      : entries_(std::move(list.entries)), asked_(options), both_(options.side_by_side) {
    kind_ = std::move(list.kind);
    size_ = entries_.size();
    remarks_ = std::move(list.remarks);
    calibration_ = std::move(found.model);
    calibration_file_ = std::move(found.file);
    exchanged_ = options.exchanged != (calibration_ && calibration_->eyes_exchanged);
    if (asked_.needs_times() && (entries_.empty() || !entries_.front().stamp_ns)) {
      throw UserError(
          "--from and --to in seconds need pictures with times; these have none: give "
          "the numbers of pairs, from 0");
    }
  }

  [[nodiscard]] bool next(SequenceLook& look) override {
    for (; at_ < entries_.size(); ++at_) {
      const PictureEntry& entry = entries_[at_];
      std::optional<double> since_s;
      if (entry.stamp_ns && entries_.front().stamp_ns) {
        since_s = static_cast<double>(*entry.stamp_ns - *entries_.front().stamp_ns) / kNs_per_s;
      }
      if (!asked_.takes(at_, since_s)) continue;
      try {
        read(entry, look);
      } catch (const UserError& error) {
        if (entries_.size() == 1) throw;  // nothing else is there to be seen
        leave_out(error.what());
        continue;
      }
      look.number = at_++;
      return true;
    }
    return false;
  }

 private:
  void read(const PictureEntry& entry, SequenceLook& look) {
    look.name = entry.left.filename().string();
    look.stamp_ns = entry.stamp_ns;
    if (!entry.right.empty()) {
      const EyePair pair = exchanged_ ? read_eye_pair(entry.right, entry.left)
                                      : read_eye_pair(entry.left, entry.right);
      look.left = pair.left;
      look.right = pair.right;
    } else {
      look.left = read_any_image(entry.left);
      look.right = cv::Mat3b();
      if (both_ || holds_both(calibration_, look.left.size())) {
        const EyePair pair = read_both_eyes(entry.left);
        look.left = exchanged_ ? pair.right : pair.left;
        look.right = exchanged_ ? pair.left : pair.right;
      }
    }
    // Pictures of one eye without a calibration need nothing in common.
    if (look.right.empty() && !calibration_) return;
    if (size_px_.empty()) size_px_ = look.left.size();
    if (look.left.size() == size_px_) return;
    throw UserError(fmt::format("{}: is {} x {} px, the first one was {} x {}", entry.left.string(),
                                look.left.cols, look.left.rows, size_px_.width, size_px_.height));
  }

  std::vector<PictureEntry> entries_;
  AskedMoments asked_;
  bool both_ = false;
  bool exchanged_ = false;
  std::size_t at_ = 0;
  cv::Size size_px_;
};

}  // namespace

std::unique_ptr<Sequence> open_pictures(PictureList list, FoundCalibration found,
                                        const SequenceOptions& options) {
  return std::make_unique<PictureSequence>(std::move(list), std::move(found), options);
}

}  // namespace striate::datasets
