#include "striate/platform/simulator/random_world/draw_difficulties.hpp"

#include <algorithm>

#include "striate/config/diagnostics.hpp"
#include "striate/platform/simulator/random_world/draft.hpp"

namespace striate::simulator {
namespace {

// Topics of the dice: what is drawn anew with each proposal comes behind kProposal.
constexpr std::uint64_t kDifficultiesTopic = 1;  ///< which a building has
constexpr std::uint64_t kEyesTopic = 3;          ///< what is wrong with the cameras

}  // namespace

std::vector<Difficulty> draw_difficulties(BuildingKind kind, std::uint64_t seed) {
  Dice dice(seed, kind, kDifficultiesTopic);
  std::vector<Difficulty> drawn;
  for (int i = 0; i < kDifficulties; ++i) {
    const int share = style_of(kind).share_percent[static_cast<std::size_t>(i)];
    if (dice.chance(share)) drawn.push_back(static_cast<Difficulty>(i));
  }
  return drawn;
}

EyeFaults draw_eyes(BuildingKind kind, std::uint64_t seed) {
  constexpr int kShare_percent = 25;
  Dice dice(seed, kind, kEyesTopic);
  // Whole units, at least a quarter of the most; the sign is always thrown, so that one fault's
  // throws do not move another's.
  const auto draw = [&](int most, int lowest_sign) {
    const bool is = dice.chance(kShare_percent);
    const int size = dice.throw_between({std::max(1, most / 4), most});
    const int sign = dice.sign();
    if (!is) return 0;
    return lowest_sign < 0 ? sign * size : size;
  };
  EyeFaults eyes;
  eyes.tilt_rad = radians(draw(100, -1) / 100.0);  // up to 1 deg
  eyes.yaw_rad = radians(draw(16, -1) / 100.0);    // 0.16 deg: a pixel of 320
  eyes.focal = draw(20, -1) / 1000.0;              // 2 %
  eyes.baseline = draw(10, -1) / 1000.0;           // 1 mm of 0.12 m
  eyes.rows_px = draw(8, -1) / 10.0;               // nearly a pixel
  eyes.distortion = draw(12, -1) / 1000.0;         // 2 px at the corner
  eyes.rolling_shutter_s = draw(30, 1) / 1000.0;
  eyes.white_balance = draw(20, -1) / 100.0;
  eyes.lamp_flicker = draw(30, 1) / 100.0;  // magnetic ballasts
  eyes.dirt = draw(8, 1) / 100.0;
  eyes.fixed_pattern = draw(15, 1) / 1000.0;
  return eyes;
}

}  // namespace striate::simulator
