#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <string_view>

#include "striate/base/plain_text.hpp"
#include "striate/platform/datasets/calibration/calibration_formats.hpp"
#include "striate/platform/datasets/calibration/eye_fields.hpp"
#include "striate/platform/datasets/calibration/text_tree.hpp"

namespace striate::datasets {
namespace {

using config::Node;

enum class Part {
  matrix,
  lens,
  turn,
  projection,
  way,
  to_depth,
  width,
  height,
  size,
  baseline,
  lens_model,
  fx,
  fy,
  cx,
  cy,
  none
};

struct PartName {
  const char* letters;
  Part part;
};

/// What programs and people call the parts, in small letters without anything between.
constexpr PartName kPartNames[] = {{"k", Part::matrix},
                                   {"m", Part::matrix},
                                   {"mtx", Part::matrix},
                                   {"cameramatrix", Part::matrix},
                                   {"intrinsicmatrix", Part::matrix},
                                   {"intrinsics", Part::matrix},
                                   {"intrinsic", Part::matrix},
                                   {"matrix", Part::matrix},
                                   {"kmatrix", Part::matrix},
                                   {"d", Part::lens},
                                   {"dist", Part::lens},
                                   {"distcoeffs", Part::lens},
                                   {"distcoeff", Part::lens},
                                   {"distortion", Part::lens},
                                   {"distortioncoefficients", Part::lens},
                                   {"distortioncoeffs", Part::lens},
                                   {"distcoefs", Part::lens},
                                   {"coefficients", Part::lens},
                                   {"r", Part::turn},
                                   {"rotation", Part::turn},
                                   {"rot", Part::turn},
                                   {"rotationmatrix", Part::turn},
                                   {"rect", Part::turn},
                                   {"rectification", Part::turn},
                                   {"rectificationmatrix", Part::turn},
                                   {"rectificationtransform", Part::turn},
                                   {"p", Part::projection},
                                   {"proj", Part::projection},
                                   {"projection", Part::projection},
                                   {"projectionmatrix", Part::projection},
                                   {"t", Part::way},
                                   {"translation", Part::way},
                                   {"translationm", Part::way},
                                   {"trans", Part::way},
                                   {"translationvector", Part::way},
                                   {"tvec", Part::way},
                                   {"q", Part::to_depth},
                                   {"disparitytodepth", Part::to_depth},
                                   {"width", Part::width},
                                   {"imagewidth", Part::width},
                                   {"imgwidth", Part::width},
                                   {"w", Part::width},
                                   {"height", Part::height},
                                   {"imageheight", Part::height},
                                   {"imgheight", Part::height},
                                   {"h", Part::height},
                                   {"imagesize", Part::size},
                                   {"imgsize", Part::size},
                                   {"size", Part::size},
                                   {"resolution", Part::size},
                                   {"baseline", Part::baseline},
                                   {"baselinem", Part::baseline},
                                   {"distortionmodel", Part::lens_model},
                                   {"lensmodel", Part::lens_model},
                                   {"cameramodel", Part::lens_model},
                                   {"cameratype", Part::lens_model},
                                   {"model", Part::lens_model},
                                   {"fx", Part::fx},
                                   {"fy", Part::fy},
                                   {"cx", Part::cx},
                                   {"cy", Part::cy}};

enum class Eye { both, first, second };

struct Named {
  Part part = Part::none;
  Eye eye = Eye::both;
  bool from_zero = false;  ///< the eye was said by a 0: then 1 is the second one
};

Part part_named(std::string_view letters) {
  for (const PartName& name : kPartNames) {
    if (letters == name.letters) return name.part;
  }
  return Part::none;
}

std::string small_letters(const std::string& key) {
  std::string letters;
  for (const char c : key) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  return letters;
}

struct EyeWord {
  const char* word;
  Eye eye;
  bool zero = false;
};

/// The longer ones first, so that `camera1` is not a `1` behind the unknown word `camera`.
constexpr EyeWord kEyeWords[] = {{"camera0", Eye::first, true},
                                 {"camera1", Eye::second},
                                 {"camera2", Eye::second},
                                 {"cam0", Eye::first, true},
                                 {"cam1", Eye::second},
                                 {"cam2", Eye::second},
                                 {"left", Eye::first},
                                 {"right", Eye::second},
                                 {"0", Eye::first, true},
                                 {"1", Eye::second},
                                 {"2", Eye::second},
                                 {"l", Eye::first},
                                 {"r", Eye::second}};

bool is_digit_word(const EyeWord& word) {
  return std::isdigit(
             static_cast<unsigned char>(word.word[std::string_view(word.word).size() - 1])) != 0;
}

/// `K1`, `left_camera_matrix`, `LEFT.K`, `cameraMatrixL`: what, and of which eye. A digit is kept
/// as 0, 1 or 2 by `digit`, since only all keys together say what 1 means.
struct Key {
  Named named;
  int digit = -1;
};

Key understood(const std::string& key) {
  const std::string letters = small_letters(key);
  if (const Part whole = part_named(letters); whole != Part::none) return {{whole}, -1};
  for (const EyeWord& word : kEyeWords) {
    const std::string_view w = word.word;
    std::string_view rest = letters;
    if (rest.size() <= w.size()) continue;
    if (rest.ends_with(w)) {
      rest.remove_suffix(w.size());
    } else if (rest.starts_with(w) && w.size() > 1) {
      rest.remove_prefix(w.size());
    } else {
      continue;
    }
    const Part part = part_named(rest);
    if (part == Part::none) continue;
    return {{part, word.eye, word.zero}, is_digit_word(word) ? w.back() - '0' : -1};
  }
  return {};
}

/// Which eye a map of its own is about: `left: {...}`, `cam0: {...}`.
Key map_key(const std::string& key) {
  const std::string letters = small_letters(key);
  for (const EyeWord& word : kEyeWords) {
    const std::string_view w = word.word;
    const bool same = letters == w || letters == std::string(w) + "camera" ||
                      letters == "camera" + std::string(w) || letters == "cam" + std::string(w);
    if (same) return {{Part::none, word.eye, word.zero}, is_digit_word(word) ? w.back() - '0' : -1};
  }
  return {{Part::none, Eye::both}, -1};
}

struct Value {
  const Node* node = nullptr;
  std::string key;
};

/// All that was understood, by part and eye.
class Parts {
 public:
  explicit Parts(const Node& root) {
    bool zero = false;
    for_each(root, [&](const Key& key, const Node::Entry&) { zero = zero || key.digit == 0; });
    for_each(root, [&](const Key& key, const Node::Entry& entry) {
      Eye eye = key.named.eye;
      if (key.digit >= 0) eye = key.digit == (zero ? 0 : 1) ? Eye::first : Eye::second;
      values_.try_emplace({key.named.part, eye}, Value{&entry.value, entry.key});
    });
  }
  [[nodiscard]] const Node* find(Part part, Eye eye) const {
    const auto found = values_.find({part, eye});
    return found == values_.end() ? nullptr : found->second.node;
  }
  /// Of this eye, or else of both.
  [[nodiscard]] const Node* own_or_common(Part part, Eye eye) const {
    const Node* own = find(part, eye);
    return own != nullptr ? own : find(part, Eye::both);
  }
  [[nodiscard]] std::string key(Part part, Eye eye) const {
    const auto found = values_.find({part, eye});
    return found == values_.end() ? "" : plain_text(found->second.key);
  }

 private:
  template <class Use>
  static void for_each(const Node& root, const Use& use) {
    for (const Node::Entry& entry : root.entries) {
      const Key key = understood(entry.key);
      if (key.named.part != Part::none) {
        use(key, entry);
        continue;
      }
      if (entry.value.kind != Node::Kind::map || entry.value.find("data") != nullptr) continue;
      const Key of_map = map_key(entry.key);
      for (const Node::Entry& inner : entry.value.entries) {
        Key inside = understood(inner.key);
        if (inside.named.part == Part::none) continue;
        if (of_map.named.eye != Eye::both) {
          inside.named.eye = of_map.named.eye;
          inside.named.from_zero = of_map.named.from_zero;
          inside.digit = of_map.digit;
        }
        use(inside, inner);
      }
    }
  }
  std::map<std::pair<Part, Eye>, Value> values_;
};

const Node& unwrapped(const Node& root) {
  const Node::Entry* storage = root.find("opencv_storage");
  return storage != nullptr && storage->value.kind == Node::Kind::map ? storage->value : root;
}

std::optional<cv::Matx33d> matrix_in(const Parts& parts, Eye eye,
                                     config::Diagnostics& diagnostics) {
  const Node* node = parts.find(Part::matrix, eye);
  if (node != nullptr && node->find("fx") != nullptr) {  // {fx: ..., cx: ...} in any order
    return matrix_in(Parts(*node), Eye::both, diagnostics);
  }
  if (node != nullptr) {
    const std::size_t before = diagnostics.count();
    if (numbers_of(*node, parts.key(Part::matrix, eye), diagnostics).size() == 4 &&
        diagnostics.count() == before) {
      return matrix_of_four(*node, diagnostics);
    }
    if (diagnostics.count() != before) return {};
    return matrix_of<3, 3>(*node, parts.key(Part::matrix, eye), diagnostics);
  }
  double four[4] = {};
  constexpr Part kFour[4] = {Part::fx, Part::fy, Part::cx, Part::cy};
  for (int k = 0; k < 4; ++k) {
    const Node* one = parts.own_or_common(kFour[k], eye);
    const auto value = one != nullptr ? number_of(one->text) : std::nullopt;
    if (!value) return {};
    four[k] = *value;
  }
  return camera_matrix(four[0], four[1], four[2], four[3]);
}

cv::Size size_in(const Parts& parts, Eye eye, config::Diagnostics& diagnostics) {
  const cv::Size told = size_of(parts.own_or_common(Part::width, eye),
                                parts.own_or_common(Part::height, eye), diagnostics);
  if (!told.empty()) return told;
  const Node* both = parts.own_or_common(Part::size, eye);
  if (both == nullptr) return {};
  const std::vector<double> numbers = numbers_of(*both, "the size of the pictures", diagnostics);
  if (numbers.size() != 2 || numbers[0] < 1.0 || numbers[1] < 1.0 || numbers[0] > 65536.0 ||
      numbers[1] > 65536.0) {
    return {};
  }
  return {static_cast<int>(numbers[0]), static_cast<int>(numbers[1])};
}

/// @return whether the eye has a matrix of its own
bool read_eye(const Parts& parts, Eye which, EyeModel& eye, StereoModel& model,
              config::Diagnostics& diagnostics) {
  eye.size_px = size_in(parts, which, diagnostics);
  const auto matrix = matrix_in(parts, which, diagnostics);
  if (matrix) eye.matrix = *matrix;
  const Node* lens_model = parts.own_or_common(Part::lens_model, which);
  const Node* lens = parts.find(Part::lens, which);
  set_distortion(lens, lens_model, eye, diagnostics);
  if (lens_model == nullptr && eye.distortion.size() == 4) {
    model.remarks.emplace_back(
        "the lens has 4 coefficients, taken for k1 k2 p1 p2; of a fisheye say in the file "
        "distortion_model: equidistant");
  }
  if (const Node* projection = parts.find(Part::projection, which)) {
    const auto p = matrix_of<3, 4>(*projection, parts.key(Part::projection, which), diagnostics);
    RectifiedEye rectified;
    if (p) rectified.projection = *p;
    if (const Node* turn = parts.find(Part::turn, which)) {
      const auto r = matrix_of<3, 3>(*turn, parts.key(Part::turn, which), diagnostics);
      if (r) rectified.turn = *r;
    }
    if (p) eye.rectified = rectified;
  }
  return matrix.has_value();
}

/// Rodrigues' vector is what some write instead of the matrix.
std::optional<cv::Matx33d> rotation_in(const Node& node, config::Diagnostics& diagnostics) {
  const std::size_t before = diagnostics.count();
  const std::vector<double> numbers = numbers_of(node, "the rotation R", diagnostics);
  if (diagnostics.count() != before) return {};
  if (numbers.size() != 3) return matrix_of<3, 3>(node, "the rotation R", diagnostics);
  const cv::Vec3d turn(numbers.data());
  const double angle_rad = cv::norm(turn);
  if (angle_rad < 1e-12) return cv::Matx33d::eye();
  const cv::Vec3d axis = turn / angle_rad;
  const cv::Matx33d cross(0, -axis[2], axis[1], axis[2], 0, -axis[0], -axis[1], axis[0], 0);
  return cv::Matx33d::eye() + cross * std::sin(angle_rad) +
         cross * cross * (1.0 - std::cos(angle_rad));
}

void read_apart(const Parts& parts, StereoModel& model, config::Diagnostics& diagnostics) {
  const Node* way = parts.find(Part::way, Eye::both);
  if (way == nullptr) way = parts.find(Part::way, Eye::second);
  if (way == nullptr) return;
  const auto t = matrix_of<3, 1>(*way, "the translation T", diagnostics);
  if (!t) return;
  EyesApart apart;
  apart.translation_m = {t->val[0], t->val[1], t->val[2]};
  if (const Node* turn = parts.find(Part::turn, Eye::both)) {
    const auto r = rotation_in(*turn, diagnostics);
    if (!r) return;
    apart.rotation = *r;
  } else {
    model.remarks.emplace_back("it has T without R: the eyes are taken for parallel");
  }
  model.apart = apart;
}

/// Rectified pictures of which stereoRectify's Q alone was kept.
void read_to_depth(const Node& node, StereoModel& model, config::Diagnostics& diagnostics) {
  const auto q = matrix_of<4, 4>(node, "Q", diagnostics);
  if (!q) return;
  const double focal_px = (*q)(2, 3);
  const double baseline = (*q)(3, 2) != 0.0 ? 1.0 / (*q)(3, 2) : 0.0;
  model.pictures_rectified = true;
  model.left.matrix = camera_matrix(focal_px, focal_px, -(*q)(0, 3), -(*q)(1, 3));
  model.right = model.left;
  // Q's last number is (cx - cx') / Tx, with Tx = -B.
  model.doffs_px = (*q)(3, 3) * baseline;
  model.right->matrix(0, 2) += model.doffs_px;
  model.baseline_m = std::abs(baseline);
}

}  // namespace

bool is_named_matrices(const Node& root) {
  const Parts parts(unwrapped(root));
  for (const Eye eye : {Eye::first, Eye::second}) {
    if (parts.find(Part::matrix, eye) != nullptr || parts.find(Part::projection, eye) != nullptr) {
      return true;
    }
  }
  return parts.find(Part::to_depth, Eye::both) != nullptr ||
         (parts.find(Part::fx, Eye::both) != nullptr &&
          parts.find(Part::cx, Eye::both) != nullptr) ||
         (parts.find(Part::matrix, Eye::both) != nullptr);
}

StereoModel read_named_matrices(const Node& given, config::Diagnostics& diagnostics) {
  const Node& root = unwrapped(given);
  const Parts parts(root);
  StereoModel model;
  model.format =
      root.find("left_camera_matrix") != nullptr ? "Striate calibrate" : "OpenCV (named matrices)";
  EyeModel right;
  const bool first = read_eye(parts, Eye::first, model.left, model, diagnostics);
  const bool second = read_eye(parts, Eye::second, right, model, diagnostics);
  if (!first && !second && model.left.rectified && right.rectified) {
    model.pictures_rectified = true;
    for (EyeModel* eye : {&model.left, &right}) {
      eye->matrix = eye->rectified->projection.get_minor<3, 3>(0, 0);
    }
    model.right = right;
  } else if (first && (second || right.rectified)) {
    model.right = right;
    read_apart(parts, model, diagnostics);
  } else if (const Node* q = parts.find(Part::to_depth, Eye::both); q != nullptr && !first) {
    read_to_depth(*q, model, diagnostics);
  } else if (!first) {  // one camera, or two alike
    const bool one = read_eye(parts, Eye::both, model.left, model, diagnostics);
    if (one && parts.find(Part::baseline, Eye::both) != nullptr) {
      model.right = model.left;
      model.pictures_rectified = true;
    }
  }
  if (const Node* baseline = parts.find(Part::baseline, Eye::both)) {
    if (const auto value = number_of(baseline->text)) {
      if (model.pictures_rectified && model.baseline_m == 0.0) model.baseline_m = *value;
    }
  }
  return model;
}

}  // namespace striate::datasets
