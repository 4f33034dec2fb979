#include <fmt/format.h>

#include <map>
#include <string_view>

#include "striate/base/plain_text.hpp"
#include "striate/platform/datasets/calibration/calibration_formats.hpp"
#include "striate/platform/datasets/calibration/eye_fields.hpp"
#include "striate/platform/datasets/calibration/text_tree.hpp"

namespace striate::datasets {
namespace {

using config::Node;

/// `key: numbers` or `key=[numbers]` a line, each value as a text with its place.
std::map<std::string, Node> lines_of(const std::string& text, char sign) {
  std::map<std::string, Node> values;
  int line = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string words = text.substr(at, end - at);
    at = end + 1;
    ++line;
    const std::size_t split = words.find(sign);
    if (split == std::string::npos || words.starts_with("#")) continue;
    Node node;
    node.kind = Node::Kind::scalar;
    node.place = {line, static_cast<int>(split) + 2};
    for (const char c : words.substr(split + 1)) node.text += c == '[' || c == ']' ? ' ' : c;
    std::string key = words.substr(0, split);
    while (!key.empty() && (key.back() == ' ' || key.back() == '\t')) key.pop_back();
    values.emplace(key, node);
  }
  return values;
}

const Node* value_of(const std::map<std::string, Node>& values, const std::string& key) {
  const auto found = values.find(key);
  return found == values.end() ? nullptr : &found->second;
}

bool has_line(const std::string& text, std::string_view begin) {
  return text.starts_with(begin) || text.find("\n" + std::string(begin)) != std::string::npos;
}

EyeModel rectified_eye(const cv::Matx34d& projection) {
  EyeModel eye;
  eye.matrix = projection.get_minor<3, 3>(0, 0);
  eye.rectified = RectifiedEye{cv::Matx33d::eye(), projection};
  return eye;
}

}  // namespace

/// The key and a number behind it: OpenCV's `P2: !!opencv-matrix` is none of KITTI's.
bool is_kitti(const std::string& text) {
  for (const auto& [key, value] : lines_of(plain_line_ends(text), ':')) {
    if (key != "P0" && key != "P2" && key != "P_rect_00" && key != "P_rect_02") continue;
    const std::size_t first = value.text.find_first_not_of(" \t");
    if (first == std::string::npos) continue;
    const std::size_t end = value.text.find_first_of(" \t", first);
    if (number_of(std::string_view(value.text).substr(first, end - first))) return true;
  }
  return false;
}

StereoModel read_kitti(const std::string& given, int first, config::Diagnostics& diagnostics) {
  const std::string text = plain_line_ends(given);
  diagnostics.set_source(text);
  StereoModel model;
  model.format = "KITTI calib.txt";
  model.pictures_rectified = true;
  const auto values = lines_of(text, ':');
  std::optional<cv::Matx34d> eyes[2];
  for (int k = 0; k < 2; ++k) {
    const std::string short_key = fmt::format("P{}", first + k);
    const std::string long_key = fmt::format("P_rect_0{}", first + k);
    const Node* node = value_of(values, short_key);
    if (node == nullptr) node = value_of(values, long_key);
    if (node == nullptr) {
      diagnostics.add(config::fault::missing_key, {},
                      fmt::format("'{}' (or '{}') is missing", short_key, long_key),
                      "it is the projection matrix of one of the two cameras");
      return model;
    }
    eyes[k] = matrix_of<3, 4>(*node, short_key, diagnostics);
  }
  if (!eyes[0] || !eyes[1]) return model;
  model.left = rectified_eye(*eyes[0]);
  model.right = rectified_eye(*eyes[1]);
  return model;
}

bool is_middlebury(const std::string& text) {
  return has_line(text, "cam0=[") || has_line(text, "cam0 = [");
}

StereoModel read_middlebury(const std::string& given, config::Diagnostics& diagnostics) {
  std::string text = plain_line_ends(given);
  diagnostics.set_source(text);
  StereoModel model;
  model.format = "Middlebury calib.txt";
  model.pictures_rectified = true;
  const auto values = lines_of(text, '=');
  EyeModel eyes[2];
  for (int k = 0; k < 2; ++k) {
    const Node* node = value_of(values, fmt::format("cam{}", k));
    if (node == nullptr) {
      diagnostics.add(config::fault::missing_key, {}, fmt::format("'cam{}' is missing", k));
      return model;
    }
    const auto matrix = matrix_of<3, 3>(*node, fmt::format("cam{}", k), diagnostics);
    if (matrix) eyes[k].matrix = *matrix;
    eyes[k].size_px = size_of(value_of(values, "width"), value_of(values, "height"), diagnostics);
  }
  model.left = eyes[0];
  model.right = eyes[1];
  const Node* baseline = value_of(values, "baseline");
  const auto value = baseline != nullptr ? number_of(baseline->text) : std::nullopt;
  if (!value) {
    diagnostics.add(config::fault::missing_key,
                    baseline != nullptr ? baseline->place : config::SourceLocation{},
                    "'baseline' (in mm) is missing, or no number");
    return model;
  }
  model.baseline_m = 1e-3 * *value;
  return model;
}

}  // namespace striate::datasets
