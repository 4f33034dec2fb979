#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "striate/base/files.hpp"
#include "striate/base/user_error.hpp"
#include "striate/platform/datasets/calibration/calibration_formats.hpp"
#include "striate/platform/datasets/calibration/judge_model.hpp"
#include "striate/platform/datasets/calibration/read_calibration.hpp"
#include "striate/platform/datasets/images/read_image.hpp"
#include "striate/platform/datasets/sequences/picture_list.hpp"
#include "striate/platform/datasets/sequences/sequence.hpp"

namespace striate::datasets {

void Sequence::leave_out(const std::string& why) {
  constexpr std::size_t kTold = 5;  // lines: a person reads no more of one kind (ours)
  if (++left_out_count_ <= kTold) left_out_.push_back(why);
}

namespace {

namespace fs = std::filesystem;

constexpr double kNs_per_s = 1e9;

/// Whether each picture holds both eyes: said, or told by a calibration of half the width.
bool holds_both(const std::optional<StereoModel>& calibration, cv::Size picture) {
  if (!calibration || calibration->left.size_px.empty()) return false;
  const cv::Size told = calibration->left.size_px;
  return picture.width == 2 * told.width && picture.height == told.height;
}

/// Which moments are asked for.
class Asked {
 public:
  explicit Asked(const SequenceOptions& options) : options_(options) {}
  /// @param since_s time since the beginning; nothing: not known
  [[nodiscard]] bool takes(std::size_t number, std::optional<double> since_s) const {
    if (number % static_cast<std::size_t>(options_.every) != 0) return false;
    return !before(options_.from, number, since_s) && !is_behind(number, since_s);
  }
  [[nodiscard]] bool is_behind(std::size_t number, std::optional<double> since_s) const {
    if (!options_.to) return false;
    return options_.to->seconds ? since_s && *since_s > options_.to->value
                                : static_cast<double>(number) > options_.to->value;
  }
  [[nodiscard]] bool needs_times() const {
    return (options_.from && options_.from->seconds) || (options_.to && options_.to->seconds);
  }

 private:
  static bool before(const std::optional<SequencePlace>& place, std::size_t number,
                     std::optional<double> since_s) {
    if (!place) return false;
    return place->seconds ? since_s && *since_s < place->value
                          : static_cast<double>(number) < place->value;
  }
  SequenceOptions options_;
};

class FileSequence final : public Sequence {
 public:
  FileSequence(PictureList list, std::optional<StereoModel> calibration, std::string file,
               const SequenceOptions& options)
      : entries_(std::move(list.entries)), asked_(options), both_(options.side_by_side) {
    kind_ = std::move(list.kind);
    size_ = entries_.size();
    remarks_ = std::move(list.remarks);
    calibration_ = std::move(calibration);
    calibration_file_ = std::move(file);
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
  Asked asked_;
  bool both_ = false;
  bool exchanged_ = false;
  std::size_t at_ = 0;
  cv::Size size_px_;
};

class VideoSequence final : public Sequence {
 public:
  VideoSequence(const std::vector<fs::path>& files, std::optional<StereoModel> calibration,
                std::string calibration_file, const SequenceOptions& options)
      : asked_(options), both_(options.side_by_side) {
    for (const fs::path& file : files) {
      cv::VideoCapture capture;
      if (!capture.open(file.string())) {
        throw UserError(file.string() +
                        ": is no video that OpenCV can open\n    hint: give a folder of its "
                        "pictures: ffmpeg -i VIDEO pictures/%06d.png");
      }
      captures_.push_back(std::move(capture));
    }
    kind_ = files.size() == 2 ? "two videos" : "video";
    const double count = captures_.front().get(cv::CAP_PROP_FRAME_COUNT);
    if (count > 0.0 && count < 1e9) size_ = static_cast<std::size_t>(count);
    rate_hz_ = captures_.front().get(cv::CAP_PROP_FPS);
    if (!(rate_hz_ > 0.0 && rate_hz_ < 1e5)) rate_hz_ = 0.0;
    if (rate_hz_ == 0.0) remarks_.emplace_back("the video tells no rate: its frames have no times");
    calibration_ = std::move(calibration);
    calibration_file_ = std::move(calibration_file);
    exchanged_ = options.exchanged != (calibration_ && calibration_->eyes_exchanged);
  }

  [[nodiscard]] bool next(SequenceLook& look) override {
    while (true) {
      const std::size_t number = number_++;
      std::optional<double> since_s;
      if (rate_hz_ > 0.0) since_s = static_cast<double>(number) / rate_hz_;
      if (asked_.is_behind(number, since_s)) return false;
      std::size_t grabbed = 0;
      for (cv::VideoCapture& capture : captures_) grabbed += capture.grab() ? 1 : 0;
      if (grabbed < captures_.size()) {
        tell_end(number, grabbed);
        return false;
      }
      if (!asked_.takes(number, since_s)) continue;
      if (!decode(look)) {
        leave_out(fmt::format("frame {} cannot be decoded", number));
        continue;
      }
      look.number = number;
      look.name = fmt::format("frame {}", number);
      look.stamp_ns.reset();
      if (since_s) look.stamp_ns = std::llround(kNs_per_s * *since_s);
      return true;
    }
  }

 private:
  void tell_end(std::size_t number, std::size_t grabbed) {
    if (grabbed > 0) remarks_.emplace_back("one video is shorter than the other");
    if (size_ > number) {
      leave_out(fmt::format("the video ends after {} frames; its head promises {}", number, size_));
    }
  }
  bool decode(SequenceLook& look) {
    cv::Mat one;
    if (!captures_[0].retrieve(one) || one.empty()) return false;
    const cv::Mat3b left = colour(one);
    look.left = left;
    look.right = cv::Mat3b();
    if (captures_.size() == 2) {
      cv::Mat other;
      if (!captures_[1].retrieve(other) || other.size() != one.size()) return false;
      look.right = colour(other);
    } else if (both_ || holds_both(calibration_, left.size())) {
      const int half = left.cols / 2;
      look.left = left.colRange(0, half).clone();
      look.right = left.colRange(half, 2 * half).clone();
    }
    if (exchanged_ && !look.right.empty()) std::swap(look.left, look.right);
    return look.left.cols >= 16 && look.left.rows >= 16;  // px, as of pictures
  }
  static cv::Mat3b colour(const cv::Mat& frame) {
    cv::Mat3b result;
    if (frame.channels() == 1) {
      cv::cvtColor(frame, result, cv::COLOR_GRAY2BGR);
    } else {
      result = frame.clone();
    }
    return result;
  }

  std::vector<cv::VideoCapture> captures_;
  Asked asked_;
  bool both_ = false;
  bool exchanged_ = false;
  double rate_hz_ = 0.0;
  std::size_t number_ = 0;
};

struct FoundCalibration {
  std::optional<StereoModel> model;
  std::string file;
};

FoundCalibration read_found(const std::vector<fs::path>& files, const SequenceOptions& options) {
  FoundCalibration found;
  found.model = read_calibration(files, options.exchanged);
  for (const fs::path& file : files) {
    found.file += (found.file.empty() ? "" : ", ") + file.string();
  }
  return found;
}

/// What lies beside the pictures and can only be a calibration: one file of both eyes, or one for
/// each, by their names.
FoundCalibration search_folder(const fs::path& folder, const SequenceOptions& options,
                               std::vector<std::string>& remarks) {
  std::vector<fs::path> candidates;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string suffix = entry.path().extension().string();
    constexpr const char* kTexts[] = {".yaml", ".yml", ".xml", ".json", ".txt"};
    if (std::ranges::find(kTexts, suffix) == std::end(kTexts)) continue;
    if (looks_like_calibration(entry.path())) candidates.push_back(entry.path());
  }
  std::ranges::sort(candidates);
  std::vector<fs::path> of_both;
  for (const fs::path& file : candidates) {
    for (const RightName& other : right_names(file.stem().string())) {
      const fs::path partner = file.parent_path() / (other.name + file.extension().string());
      if (std::ranges::find(candidates, partner) == candidates.end()) continue;
      if (of_both.empty()) of_both = {file, partner};
    }
  }
  if (of_both.empty() && candidates.size() == 1) of_both = candidates;
  if (of_both.empty()) {
    if (candidates.size() > 1) {
      remarks.push_back(
          fmt::format("{} holds {} files that may be calibrations: none was taken; "
                      "say which: --calibration FILE",
                      folder.string(), candidates.size()));
    }
    return {};
  }
  try {
    return read_found(of_both, options);
  } catch (const UserError& mistake) {
    remarks.push_back(fmt::format("a calibration was found but not used: {}", mistake.what()));
    return {};
  }
}

FoundCalibration calibration_of(const fs::path& folder, PictureList& list,
                                const SequenceOptions& options) {
  if (!options.calibration.empty()) return read_found(options.calibration, options);
  if (list.kind.starts_with("KITTI") && !list.calibration.empty()) {
    const std::string file = list.calibration.front().string();
    config::Diagnostics diagnostics(file);
    StereoModel model = read_kitti(read_file(file), list.kitti_first, diagnostics);
    diagnostics.throw_if_any();
    if (options.exchanged) exchange_eyes(model);
    judge_model(model, file);
    return {model, file};
  }
  if (!list.calibration.empty()) return read_found(list.calibration, options);
  return search_folder(folder, options, list.remarks);
}

[[noreturn]] void refuse_folder(const fs::path& folder) {
  std::string there;
  std::size_t count = 0;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (++count > 6) continue;
    there += (there.empty() ? "" : ", ") + entry.path().filename().string() +
             (entry.is_directory(error) ? "/" : "");
  }
  throw UserError(fmt::format(
      "{}: holds no pictures that can be put in order{}\n    hint: a folder left/ and right/ (or "
      "cam0/, cam1/), pairs such as 001_left.png and 001_right.png, EuRoC's mav0, KITTI's image_0 "
      "and image_1, a folder of pictures, or a video",
      folder.string(),
      there.empty() ? "; it is empty"
                    : fmt::format("; in it are {}{}", there, count > 6 ? ", ..." : "")));
}

std::optional<PictureList> list_of(const fs::path& folder, bool side_by_side) {
  if (side_by_side) return find_single(folder);
  for (const auto find : {find_euroc, find_kitti, find_folder_pairs, find_name_pairs}) {
    if (auto list = find(folder)) return list;
  }
  return {};
}

/// left.mp4 and right.mp4; or the only video that is there.
std::vector<fs::path> videos_in(const fs::path& folder) {
  std::vector<fs::path> videos;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (is_video(entry.path())) videos.push_back(entry.path());
  }
  std::ranges::sort(videos);
  for (const fs::path& left : videos) {
    for (const RightName& other : right_names(left.stem().string())) {
      const fs::path right = folder / (other.name + left.extension().string());
      if (std::ranges::find(videos, right) != videos.end()) return {left, right};
    }
  }
  return videos.size() == 1 ? videos : std::vector<fs::path>{};
}

std::unique_ptr<Sequence> open_folder(const fs::path& folder, const SequenceOptions& options) {
  std::optional<PictureList> list = list_of(folder, options.side_by_side);
  if (!list) {
    if (const std::vector<fs::path> videos = videos_in(folder); !videos.empty()) {
      PictureList none;
      FoundCalibration found = calibration_of(folder, none, options);
      return std::make_unique<VideoSequence>(videos, found.model, found.file, options);
    }
    list = find_single(folder);
  }
  if (!list || list->entries.empty()) refuse_folder(folder);
  FoundCalibration found = calibration_of(folder, *list, options);
  return std::make_unique<FileSequence>(std::move(*list), found.model, found.file, options);
}

}  // namespace

std::unique_ptr<Sequence> open_sequence(const fs::path& path, const SequenceOptions& options) {
  if (options.every < 1) throw UserError("--every must be 1 or more");
  std::error_code error;
  if (!fs::exists(path, error)) {
    throw UserError(fmt::format("{}: there is no such file or folder", path.string()));
  }
  if (fs::is_directory(path, error)) return open_folder(path, options);
  PictureList list;
  FoundCalibration found;
  if (!options.calibration.empty()) found = read_found(options.calibration, options);
  if (is_video(path)) {
    return std::make_unique<VideoSequence>(std::vector<fs::path>{path}, found.model, found.file,
                                           options);
  }
  list.kind = "one picture";
  list.entries.push_back({path.stem().string(), path, {}, {}});
  return std::make_unique<FileSequence>(std::move(list), found.model, found.file, options);
}

}  // namespace striate::datasets
