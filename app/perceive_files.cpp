#include "striate/app/perceive_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "striate/agent/pictures/scene_pictures.hpp"
#include "striate/base/files.hpp"
#include "striate/base/geometry.hpp"
#include "striate/base/user_error.hpp"

namespace striate::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

/// JSON has no infinity: what is not known or not there is null.
ordered_json number(double value) {
  if (!std::isfinite(value)) return nullptr;
  return std::round(value * 1e5) / 1e5;
}

ordered_json column_json(const perception::Column& c) {
  const bool free = c.free_to_m > c.free_from_m;
  return {{"bearing_deg", number(degrees(c.bearing_rad))},
          {"free_from", free ? number(c.free_from_m) : ordered_json(nullptr)},
          {"free_to", free ? number(c.free_to_m) : ordered_json(nullptr)},
          {"free_confidence", number(c.free_confidence)},
          {"obstacle", number(c.obstacle_m)},
          {"obstacle_confidence", number(c.obstacle_confidence)},
          {"hidden_from", number(c.hidden_from_m)},
          {"hidden_to", number(c.hidden_to_m)}};
}

ordered_json obstacle_json(const perception::Obstacle& o, bool floor_known) {
  return {{"bearing_deg", number(degrees(o.bearing_rad))},
          {"distance", number(o.distance_m)},
          {"width", number(o.width_m)},
          {"height", floor_known ? number(o.height_m) : ordered_json(nullptr)},
          {"confidence", number(o.confidence)},
          {"from_u_px", o.from_u_px},
          {"to_u_px", o.to_u_px}};
}

std::string hex(const perception::Descriptor& descriptor) {
  std::string text;
  for (const std::uint64_t word : descriptor.words) text += fmt::format("{:016x}", word);
  return text;
}

}  // namespace

void write_pfm(const fs::path& file, const cv::Mat1f& values) {
  static_assert(std::endian::native == std::endian::little);
  std::ofstream out(file, std::ios::binary);
  out << "Pf\n" << values.cols << ' ' << values.rows << "\n-1.0\n";
  for (int v = values.rows - 1; v >= 0; --v) {
    out.write(reinterpret_cast<const char*>(values[v]),
              static_cast<std::streamsize>(sizeof(float)) * values.cols);
  }
  if (!out.flush()) throw std::runtime_error(fmt::format("{}: cannot be written", file.string()));
}

void write_picture(const fs::path& file, const cv::Mat3b& image) {
  if (!cv::imwrite(file.string(), image)) {
    throw std::runtime_error(fmt::format("{}: cannot be written", file.string()));
  }
}

void check_image_writable(const std::string& file) {
  if (file.empty()) return;
  check_writable(file);
  if (cv::haveImageWriter(file)) return;
  throw UserError(fmt::format("{}: is no name of an image\n    it must end in .png", file));
}

std::string obstacles_json(const perception::Percept& percept, const PerceiveOptions& options,
                           const ObstacleReport& report) {
  ordered_json json;
  json["mode"] = options.mode;
  json["method"] = report.method;
  json["unit"] = report.unit;
  if (report.unit != "m") {
    json["note"] =
        "focal length and baseline are unknown: lengths are in baselines, for a camera that sees "
        "43 degrees";
  }
  if (!report.threshold_from.empty()) {
    json["threshold_px"] = number(report.threshold_px - report.doffs_px);
    json["threshold_from"] = report.threshold_from;
  }
  json["floor_known"] = report.floor_known;
  if (report.doffs_px != 0.0) json["doffs_px"] = number(report.doffs_px);
  json["working_width_px"] = options.width_px;
  json["left"] = options.left.string();
  json["right"] =
      options.right.empty() ? ordered_json(nullptr) : ordered_json(options.right.string());
  if (!report.warnings.empty()) json["warnings"] = report.warnings;
  json["obstacles"] = ordered_json::array();
  for (const perception::Obstacle& o : percept.obstacles) {
    json["obstacles"].push_back(obstacle_json(o, report.floor_known));
  }
  const perception::CorridorView& corridor = percept.corridor;
  if (corridor.valid) {
    json["corridor"] = {{"heading_deg", number(degrees(corridor.heading_rad))},
                        {"left", number(corridor.left_m)},
                        {"right", number(corridor.right_m)},
                        {"confidence", number(corridor.confidence)}};
  } else {
    json["corridor"] = nullptr;
  }
  json["columns"] = ordered_json::array();
  for (const perception::Column& c : percept.columns) json["columns"].push_back(column_json(c));
  return json.dump(1) + "\n";
}

std::string keypoints_json(const perception::Percept& percept, cv::Size image) {
  ordered_json json;
  json["width_px"] = image.width;
  json["height_px"] = image.height;
  json["descriptor"] = "256 bits as hexadecimal words of 64, first word first";
  json["keypoints"] = ordered_json::array();
  for (const perception::Keypoint& k : percept.keypoints) {
    json["keypoints"].push_back({{"u_px", number(k.u_px)},
                                 {"v_px", number(k.v_px)},
                                 {"wavelength_px", number(k.wavelength_px)},
                                 {"response", number(k.response)},
                                 {"descriptor", hex(k.descriptor)}});
  }
  return json.dump(1) + "\n";
}

cv::Mat3b saliency_picture(const StereoFrame& frame, const perception::Percept& percept) {
  // px: smaller images are enlarged, so that labels can be read
  constexpr int kNarrowest_px = 640;
  const double scale = std::max(1.0, static_cast<double>(kNarrowest_px) / frame.left.cols);
  return agent::pictures::draw_saliency(frame, percept,
                                        {static_cast<int>(std::lround(frame.left.cols * scale)),
                                         static_cast<int>(std::lround(frame.left.rows * scale))});
}

}  // namespace striate::app
