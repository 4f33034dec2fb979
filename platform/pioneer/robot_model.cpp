#include "striate/platform/pioneer/robot_model.hpp"

#include <array>

namespace striate::pioneer {
namespace {

/// The old controller counts 0.485 mm, the SH board whole millimetres.
const std::array<RobotModel, 2>& models() {
  static const std::array<RobotModel, 2> known{RobotModel{.subclass = "p3dx", .distance_mm = 0.485},
                                               RobotModel{.subclass = "p3dx-sh"}};
  return known;
}

/// ARIA's names tell a laser behind the kind: p3dx-sh-lms500. It changes nothing of the base.
std::string without_laser(const std::string& subclass) {
  return subclass.substr(0, subclass.find("-lms"));
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
