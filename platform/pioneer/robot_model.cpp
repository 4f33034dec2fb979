#include "striate/platform/pioneer/robot_model.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace striate::pioneer {
namespace {

constexpr Pose2 disc_at(double x_mm, double y_mm, double deg) {
  return {x_mm / 1000.0, y_mm / 1000.0, radians(deg)};
}

// Factors, limits and discs are those of the parameter files that ARIA ships for each kind; a wheel
// is half an axle from the middle, which is 1 / DiffConvFactor. For the Pioneer 3-DX see
// base/pioneer_devices.hpp.

constexpr std::array<Pose2, 8> kAmigoDiscs{disc_at(76, 100, 90),     disc_at(125, 75, 41),
                                           disc_at(150, 30, 15),     disc_at(150, -30, -15),
                                           disc_at(125, -75, -41),   disc_at(76, -100, -90),
                                           disc_at(-140, -58, -145), disc_at(-140, 58, 145)};

constexpr std::array<Pose2, 8> kAmigoShDiscs{disc_at(70, 100, 90),     disc_at(125, 75, 41),
                                             disc_at(144, 30, 15),     disc_at(144, -30, -15),
                                             disc_at(120, -75, -41),   disc_at(70, -100, -90),
                                             disc_at(-146, -58, -145), disc_at(-146, 58, 145)};

constexpr std::array<Pose2, 16> kP3atDiscs{
    disc_at(147, 136, 90),     disc_at(193, 119, 50),    disc_at(227, 79, 30),
    disc_at(245, 27, 10),      disc_at(245, -27, -10),   disc_at(227, -79, -30),
    disc_at(193, -119, -50),   disc_at(147, -136, -90),  disc_at(-144, -136, -90),
    disc_at(-189, -119, -130), disc_at(-223, -79, -150), disc_at(-241, -27, -170),
    disc_at(-241, 27, 170),    disc_at(-223, 79, 150),   disc_at(-189, 119, 130),
    disc_at(-144, 136, 90)};

constexpr std::array<Pose2, 16> kPatrolBotDiscs{
    disc_at(83, 229, 90),      disc_at(169, 202, 55),     disc_at(232, 134, 30),
    disc_at(263, 46, 10),      disc_at(263, -46, -10),    disc_at(232, -134, -30),
    disc_at(169, -202, -55),   disc_at(83, -229, -90),    disc_at(-83, -229, -90),
    disc_at(-169, -202, -125), disc_at(-232, -134, -150), disc_at(-263, -46, -170),
    disc_at(-263, 46, 170),    disc_at(-232, 134, 150),   disc_at(-169, 202, 125),
    disc_at(-83, 229, 90)};

/// A Pioneer 3-DX's two arrays, and two more high up on the column.
const std::array<Pose2, kMostSonarDiscs>& peoplebot_discs() {
  static const std::array<Pose2, kMostSonarDiscs> discs = [] {
    std::array<Pose2, kMostSonarDiscs> all{};
    std::ranges::copy(sonar_discs(), all.begin());
    constexpr std::array<Pose2, 16> kUpper{
        disc_at(-20, 136, 90),     disc_at(24, 119, 50),     disc_at(58, 78, 30),
        disc_at(77, 27, 10),       disc_at(77, -27, -10),    disc_at(58, -78, -30),
        disc_at(24, -119, -50),    disc_at(-20, -136, -90),  disc_at(-191, -136, -90),
        disc_at(-237, -119, -130), disc_at(-271, -78, -150), disc_at(-290, -27, -170),
        disc_at(-290, 27, 170),    disc_at(-271, 78, 150),   disc_at(-237, 119, 130),
        disc_at(-191, 136, 90)};
    std::ranges::copy(kUpper, all.begin() + kSonarDiscs);
    return all;
  }();
  return discs;
}

/// The old controllers count parts of a millimetre, the SH boards whole ones.
std::vector<RobotModel> make_models() {
  const RobotModel p3dx{.subclass = "p3dx", .distance_mm = 0.485};
  const RobotModel p3at{.subclass = "p3at",
                        .distance_mm = 0.465,
                        .half_axle_mm = 1.0 / 0.0034,
                        .most_forward_mm_s = 1200.0,
                        .most_turn_deg_s = 300.0,
                        .discs = kP3atDiscs};
  const RobotModel amigo{.subclass = "amigo",
                         .distance_mm = 0.5083,
                         .velocity_mm_s = 0.6154,
                         .half_axle_mm = 1.0 / 0.011,
                         .most_forward_mm_s = 1000.0,
                         .most_turn_deg_s = 300.0,
                         .discs = kAmigoDiscs};
  const auto with_sh_board = [](RobotModel model) {
    model.subclass += "-sh";
    model.distance_mm = model.velocity_mm_s = 1.0;
    return model;
  };
  std::vector<RobotModel> models{p3dx,  with_sh_board(p3dx), p3at, with_sh_board(p3at),
                                 amigo, with_sh_board(amigo)};
  models.back().discs = kAmigoShDiscs;
  models.push_back(
      {.subclass = "peoplebot-sh", .half_axle_mm = 1.0 / 0.006, .discs = peoplebot_discs()});
  models.push_back({.subclass = "patrolbot-sh", .discs = kPatrolBotDiscs});
  return models;
}

const std::vector<RobotModel>& models() {
  static const std::vector<RobotModel> known = make_models();
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

std::vector<std::string> model_names() {
  std::vector<std::string> names;
  for (const RobotModel& model : models()) names.push_back(model.subclass);
  return names;
}

}  // namespace striate::pioneer
