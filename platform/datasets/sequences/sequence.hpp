#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "striate/platform/datasets/calibration/camera_model.hpp"

namespace striate::datasets {

/// Where in a sequence: by the number of a pair, from 0, or by seconds since its beginning.
struct SequencePlace {
  double value = 0.0;
  bool seconds = false;
};

/// How somebody's pictures are to be read.
struct SequenceOptions {
  std::vector<std::filesystem::path> calibration;  ///< one file, or the left one's and the right's
  bool side_by_side = false;                       ///< each picture holds both eyes
  bool exchanged = false;                          ///< what is called left is the right eye
  int every = 1;                                   ///< of the pairs; 1: all
  std::optional<SequencePlace> from;               ///< the first pair
  std::optional<SequencePlace> to;                 ///< the last one, inclusive
};

/// What one moment of a sequence shows, as it is in the files.
struct SequenceLook {
  std::size_t number = 0;                ///< of the pair in the sequence, from 0
  std::string name;                      ///< of the left picture, or "frame 17"
  std::optional<std::int64_t> stamp_ns;  ///< as the set tells it
  cv::Mat3b left;
  cv::Mat3b right;  ///< empty: one eye
};

/// Pictures in the order in which they were taken, one moment at a time: whatever the length,
/// memory holds one pair.
class Sequence {
 public:
  virtual ~Sequence() = default;
  Sequence() = default;
  Sequence(const Sequence&) = delete;
  Sequence& operator=(const Sequence&) = delete;

  /// The next moment. A picture that cannot be read is passed over and said in left_out().
  /// @return false at the end
  [[nodiscard]] virtual bool next(SequenceLook& look) = 0;

  /// "EuRoC", "KITTI odometry", "pairs left/, right/", ...
  [[nodiscard]] const std::string& kind() const { return kind_; }
  [[nodiscard]] std::size_t size() const { return size_; }  ///< of all moments; 0: not known
  [[nodiscard]] const std::optional<StereoModel>& calibration() const { return calibration_; }
  /// Where the calibration came from; empty: there is none.
  [[nodiscard]] const std::string& calibration_file() const { return calibration_file_; }
  /// What was assumed or is odd: gaps, eyes out of step, ...
  [[nodiscard]] const std::vector<std::string>& remarks() const { return remarks_; }
  /// Why pictures were left out, at most the first few in words.
  [[nodiscard]] const std::vector<std::string>& left_out() const { return left_out_; }
  [[nodiscard]] std::size_t left_out_count() const { return left_out_count_; }

 protected:
  void leave_out(const std::string& why);

  std::string kind_;
  std::size_t size_ = 0;
  std::optional<StereoModel> calibration_;
  std::string calibration_file_;
  std::vector<std::string> remarks_;

 private:
  std::vector<std::string> left_out_;
  std::size_t left_out_count_ = 0;
};

/// Opens what it is given: EuRoC (the folder or its mav0), KITTI odometry and raw, a folder with a
/// folder for each eye, a folder of pairs whose names tell the eye, a folder of single pictures (or
/// of both eyes side by side), a video, two videos left and right in a folder, one picture. A
/// calibration in the folder is found by its content where none is given.
/// @throws UserError where nothing of the kind is there, saying what is
[[nodiscard]] std::unique_ptr<Sequence> open_sequence(const std::filesystem::path& path,
                                                      const SequenceOptions& options);

}  // namespace striate::datasets
