#include "striate/platform/pioneer/robot_model.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace striate::pioneer {
namespace {

/// The old controller counts 0.485 mm, the SH board whole millimetres.
const std::array<RobotModel, 2>& models() {
  static const std::array<RobotModel, 2> known{RobotModel{.subclass = "p3dx", .distance_mm = 0.485},
                                               RobotModel{.subclass = "p3dx-sh"}};
  return known;
}

/// ARIA's names tell a laser behind the kind: p3dx-sh-lms500, p3dx-sh-lms1xx. It changes nothing of
/// the base.
std::string without_laser(const std::string& subclass) {
  constexpr std::string_view kLaser = "-lms";
  constexpr std::size_t kMostBehind = 4;  // characters of the laser's number (ours)
  const std::size_t at = subclass.find(kLaser);
  if (at == std::string::npos) return subclass;
  const std::string_view number = std::string_view(subclass).substr(at + kLaser.size());
  const bool plain = number.size() <= kMostBehind && std::ranges::all_of(number, [](char c) {
                       return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z');
                     });
  return plain ? subclass.substr(0, at) : subclass;
}

}  // namespace

const RobotModel* find_model(const std::string& subclass) {
  const std::string kind = without_laser(subclass);
  for (const RobotModel& model : models()) {
    if (model.subclass == kind) return &model;
  }
  return nullptr;
}

std::string known_models() {
  std::string names;
  for (const RobotModel& model : models()) names += (names.empty() ? "" : ", ") + model.subclass;
  return names;
}

}  // namespace striate::pioneer
