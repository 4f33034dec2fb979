#include "striate/python/perceiver.hpp"

#include <algorithm>
#include <memory>
#include <opencv2/core.hpp>
#include <regex>
#include <utility>

#include "striate/app/perceive_frame.hpp"
#include "striate/base/user_error.hpp"
#include "striate/platform/datasets/calibration/read_calibration.hpp"
#include "striate/python/arrays.hpp"

namespace striate::python {
namespace {

/// The sentences of the command name its options, "--width-px", which are called width_px here.
std::string with_names_of_python(const std::string& sentence) {
  static const std::regex option("(^|[ ,(])--([a-z]+(-[a-z]+)*)");
  std::string said;
  std::sregex_iterator found(sentence.begin(), sentence.end(), option);
  std::ptrdiff_t end = 0;
  for (; found != std::sregex_iterator(); ++found) {
    std::string name = (*found)[2];
    std::ranges::replace(name, '-', '_');
    said.append(sentence, static_cast<std::size_t>(end),
                static_cast<std::size_t>(found->position() - end));
    said += (*found)[1].str() + name;
    end = found->position() + found->length();
  }
  return said + sentence.substr(static_cast<std::size_t>(end));
}

template <class Call>
auto told_as_in_python(Call call) {
  try {
    return call();
  } catch (const UserError& error) {
    throw UserError(with_names_of_python(error.what()));
  }
}

}  // namespace

Perceiver::Perceiver(app::PerceiveOptions options) : options_(std::move(options)) {
  told_as_in_python([this] { app::check_perceive(options_); });
  if (options_.calibration.empty()) return;
  model_ = datasets::read_calibration(options_.calibration, options_.exchanged);
}

SharedSeen Perceiver::see(const py::object& left, const py::object& right,
                          const std::string& channels) {
  const Channels order = channels_named(channels);
  StereoFrame frame;
  frame.left = bgr_image(left, "left", order);
  if (!right.is_none()) frame.right = bgr_image(right, "right", order);
  const py::gil_scoped_release unlocked;
  const std::lock_guard one_at_a_time(mutex_);
  return told_as_in_python([&] { return judge(std::move(frame)); });
}

std::vector<std::string> Perceiver::remarks() const {
  return model_ ? model_->remarks : std::vector<std::string>();
}

SharedSeen Perceiver::judge(StereoFrame frame) {
  app::PerceiveOptions options = options_;  // what the calibration tells is added
  // As app/perceive.cpp: first the person, then the file.
  const bool by_person = options.exchanged;
  const bool by_file = model_ && model_->eyes_exchanged;
  if (by_person != by_file && !frame.right.empty()) std::swap(frame.left, frame.right);
  if (model_) camera_for(frame.left.size()).look(frame, options);
  app::place_camera(options, "left", frame);
  app::JudgedFrame judged = app::judge_frame(options, frame);
  app::warn_of_the_pair(frame, judged.report, false);
  auto seen = std::make_shared<Seen>();
  seen->percept = std::move(judged.percept);
  seen->disparity_px = seen->percept.disparity.disparity_px;
  if (judged.report.doffs_px != 0.0) {  // as the files have it
    // Into pixels of its own: the percept's stay as the vision gave them.
    cv::Mat1f as_given;
    cv::subtract(seen->percept.disparity.disparity_px, judged.report.doffs_px, as_given);
    seen->disparity_px = as_given;
  }
  frame.left = frame.left.clone();  // a caller's array may change
  frame.right = frame.right.clone();
  seen->judged = {std::move(options), std::move(frame), judged.robot, std::move(judged.report)};
  return seen;
}

const app::OwnCamera& Perceiver::camera_for(cv::Size pictures) {
  if (!camera_ || camera_size_ != pictures) {
    camera_.emplace(*model_, pictures, options_.rectified);
    camera_size_ = pictures;
  }
  return *camera_;
}

}  // namespace striate::python
