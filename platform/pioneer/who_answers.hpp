#pragma once

#include <string>

#include "striate/base/time.hpp"
#include "striate/platform/pioneer/transport.hpp"

namespace striate::pioneer {

/// What kind of device can be at the other end of a line.
enum class Answerer { nobody, base, turret, hokuyo, lms200, camera };

/// "a base", "a turret of AX-12A servos"; for people
[[nodiscard]] std::string name_of(Answerer kind);

/// Ids of the turret's servos, which are asked one by one.
struct ServoIds {
  std::uint8_t pan = 1;
  std::uint8_t tilt = 2;
};

/// Asks the device at an open line for one reply that only its kind gives: first the expected kind,
/// then the others. Before that it listens, so that a base with an open session gets no word, which
/// would wake its old motion. Nothing moves by any of the questions.
/// @param patience for each kind's reply
[[nodiscard]] Answerer who_answers(Transport& line, Answerer expected, const ServoIds& servos = {},
                                   Duration patience = std::chrono::milliseconds(400));

}  // namespace striate::pioneer
