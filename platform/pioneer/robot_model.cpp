#include "platform/pioneer/robot_model.hpp"

#include <array>

namespace striate::pioneer {
namespace {

/// The old controller counts 0.485 mm, the SH board whole millimetres.
const std::array<RobotModel, 2>& models() {
  static const std::array<RobotModel, 2> known{RobotModel{.subclass = "p3dx", .distance_mm = 0.485},
                                               RobotModel{.subclass = "p3dx-sh"}};
  return known;
}

constexpr Pose2 disc_at(double x_mm, double y_mm, double deg) {
  return {x_mm / 1000.0, y_mm / 1000.0, radians(deg)};
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

const Pose2& sonar_disc(std::size_t disc) {
  static constexpr std::array<Pose2, kSonarDiscs> discs{
      disc_at(69, 136, 90),      disc_at(114, 119, 50),    disc_at(148, 78, 30),
      disc_at(166, 27, 10),      disc_at(166, -27, -10),   disc_at(148, -78, -30),
      disc_at(114, -119, -50),   disc_at(69, -136, -90),   disc_at(-157, -136, -90),
      disc_at(-203, -119, -130), disc_at(-237, -78, -150), disc_at(-255, -27, -170),
      disc_at(-255, 27, 170),    disc_at(-237, 78, 150),   disc_at(-203, 119, 130),
      disc_at(-157, 136, 90)};
  return discs.at(disc);
}

}  // namespace striate::pioneer
