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

}  // namespace

const RobotModel* find_model(const std::string& subclass) {
  for (const RobotModel& model : models()) {
    if (model.subclass == subclass) return &model;
  }
  return nullptr;
}

std::string known_models() {
  std::string names;
  for (const RobotModel& model : models()) names += (names.empty() ? "" : ", ") + model.subclass;
  return names;
}

}  // namespace striate::pioneer
