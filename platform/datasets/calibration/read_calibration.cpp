#include "striate/platform/datasets/calibration/read_calibration.hpp"

#include <fmt/format.h>

#include <cmath>
#include <opencv2/core.hpp>

#include "striate/base/files.hpp"
#include "striate/base/plain_text.hpp"
#include "striate/base/user_error.hpp"
#include "striate/platform/datasets/calibration/calibration_formats.hpp"
#include "striate/platform/datasets/calibration/eye_fields.hpp"
#include "striate/platform/datasets/calibration/judge_model.hpp"
#include "striate/platform/datasets/calibration/text_tree.hpp"

namespace striate::datasets {
namespace {

namespace fs = std::filesystem;
using config::Node;

constexpr const char* kKnownFormats =
    "read are: 'striate calibrate', OpenCV FileStorage (YAML, XML, JSON with K1 D1 K2 D2 R T, or "
    "P1 "
    "P2, or Q), ROS camera_info (one file an eye), Kalibr camchain, EuRoC sensor.yaml (one file an "
    "eye), KITTI and Middlebury calib.txt, BoofCV";

/// What one file tells.
struct OneFile {
  std::string name;
  std::optional<OneEye> eye;          ///< of one camera ...
  std::optional<StereoModel> stereo;  ///< ... or of two
};

OneFile read_one(const std::string& text, const std::string& name) {
  OneFile file{name, {}, {}};
  config::Diagnostics diagnostics(plain_text(name));
  if (is_kitti(text)) {
    const bool grey =
        text.find("P0:") != std::string::npos || text.find("P_rect_00:") != std::string::npos;
    file.stereo = read_kitti(text, grey ? 0 : 2, diagnostics);
    diagnostics.throw_if_any();
    return file;
  }
  if (is_middlebury(plain_line_ends(text))) {
    file.stereo = read_middlebury(text, diagnostics);
    diagnostics.throw_if_any();
    return file;
  }
  const Node root = read_tree(text, diagnostics);
  diagnostics.throw_if_any();
  if (is_kalibr(root)) {
    file.stereo = read_kalibr(root, diagnostics);
  } else if (is_euroc_sensor(root)) {
    file.eye = read_euroc_sensor(root, diagnostics);
  } else if (is_boofcv(root)) {
    file.stereo = read_boofcv(root, diagnostics);
  } else if (is_camera_info(root)) {
    file.eye = read_camera_info(root, diagnostics);
  } else if (is_named_matrices(root)) {
    file.stereo = read_named_matrices(root, diagnostics);
  } else {
    diagnostics.add({},
                    fmt::format("is no calibration that can be read{}",
                                root.entries.empty() ? std::string()
                                                     : fmt::format("; it has {}", keys_of(root))),
                    kKnownFormats);
  }
  diagnostics.throw_if_any();
  return file;
}

/// Of pictures that need no rectifying: no lens, nothing turned, the same pinhole as before.
bool is_of_rectified(const EyeModel& eye) {
  if (!eye.rectified || eye.lens != Lens::straight) return false;
  return cv::norm(eye.rectified->turn - cv::Matx33d::eye()) < 1e-9 &&
         cv::norm(eye.rectified->projection.get_minor<3, 3>(0, 0) - eye.matrix) <
             1e-6 * std::abs(eye.matrix(0, 0));
}

StereoModel of_one(const OneEye& one) {
  StereoModel model;
  model.format = one.format;
  model.left = one.eye;
  if (one.eye.rectified && one.eye.rectified->projection(0, 3) != 0.0) {
    model.remarks.emplace_back(
        "it is the right eye's (its P has a baseline): give the left one's first");
  } else {
    model.remarks.emplace_back("it tells one eye alone: give both files, the left one's first");
  }
  return model;
}

StereoModel of_two(const OneFile& first, const OneFile& second) {
  if (!first.eye || !second.eye) {
    throw UserError(fmt::format("{} tells both eyes: give it alone, without {}",
                                first.stereo ? first.name : second.name,
                                first.stereo ? second.name : first.name));
  }
  StereoModel model;
  model.format = first.eye->format;
  model.left = first.eye->eye;
  model.right = second.eye->eye;
  if (first.eye->body_from_eye && second.eye->body_from_eye) {
    model.apart = apart_of(inverse_motion(*second.eye->body_from_eye) * *first.eye->body_from_eye);
  } else if (model.left.rectified && model.right->rectified) {
    model.pictures_rectified = is_of_rectified(model.left) && is_of_rectified(*model.right);
  } else {
    throw UserError(fmt::format(
        "{}, {}: these do not tell how the two cameras stand to each other: {}\n    hint: "
        "calibrate both together (ROS cameracalibrator --size ... right:=... left:=..., Kalibr, "
        "'striate calibrate')",
        first.name, second.name,
        first.eye->body_from_eye || second.eye->body_from_eye ? "one has no T_BS"
                                                              : "no T_BS, no P of both eyes"));
  }
  return model;
}

}  // namespace

StereoModel read_calibration_text(const std::vector<std::string>& texts,
                                  const std::vector<std::string>& names, bool exchanged) {
  if (texts.empty() || texts.size() > 2) {
    throw UserError(
        "a calibration is one file of both eyes, or two: the left one's and the right one's");
  }
  const OneFile first = read_one(texts[0], names[0]);
  StereoModel model;
  if (texts.size() == 2) {
    model = of_two(first, read_one(texts[1], names[1]));
  } else {
    model = first.eye ? of_one(*first.eye) : *first.stereo;
  }
  if (exchanged) exchange_eyes(model);
  judge_model(model, names.size() == 2 ? names[0] + ", " + names[1] : names[0]);
  return model;
}

StereoModel read_calibration(const std::vector<fs::path>& files, bool exchanged) {
  std::vector<std::string> texts;
  std::vector<std::string> names;
  for (const fs::path& file : files) {
    std::error_code error;
    if (!fs::exists(file, error)) {
      throw UserError(fmt::format("{}: there is no such file; give a calibration", file.string()));
    }
    if (!fs::is_regular_file(file, error)) {
      throw UserError(fmt::format("{}: is no file; give a calibration", file.string()));
    }
    constexpr std::uintmax_t kMostCalibration_bytes = 1'000'000;  // bytes, as of YAML (config/)
    if (fs::file_size(file, error) > kMostCalibration_bytes) {
      throw UserError(fmt::format("{}: is larger than 1 MB; no calibration is", file.string()));
    }
    texts.push_back(read_file(file));
    names.push_back(file.string());
  }
  return read_calibration_text(texts, names, exchanged);
}

bool looks_like_calibration(const fs::path& file) {
  std::error_code error;
  constexpr std::uintmax_t kUsual_bytes = 200'000;  // bytes; those of ten cameras have 10 kB (ours)
  if (!fs::is_regular_file(file, error) || fs::file_size(file, error) > kUsual_bytes) return false;
  try {
    const std::string text = read_file(file);
    if (is_kitti(text) || is_middlebury(plain_line_ends(text))) return true;
    config::Diagnostics diagnostics(file.string());
    const Node root = read_tree(text, diagnostics);
    if (!diagnostics.none() || root.kind != Node::Kind::map) return false;
    return is_kalibr(root) || is_euroc_sensor(root) || is_boofcv(root) || is_camera_info(root) ||
           is_named_matrices(root);
  } catch (const UserError&) {
    return false;
  }
}

}  // namespace striate::datasets
