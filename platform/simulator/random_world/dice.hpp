#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "striate/platform/simulator/random.hpp"
#include "striate/platform/simulator/random_world/building_kind.hpp"

namespace striate::simulator {

/// Both ends included.
struct Between {
  int low = 0;
  int high = 0;
};

/// The throws that one building is drawn from: whole numbers alone (centimetres, percent, degrees),
/// so that every machine draws the same.
class Dice {
 public:
  /// @param topic throws of one topic do not move those of another: a new kind of thing leaves the
  ///              others where they were
  Dice(std::uint64_t seed, BuildingKind kind, std::uint64_t topic)
      : random_(seed, Purpose::building),
        next_((static_cast<std::uint64_t>(kind) << 56U) | (topic << 32U)) {}

  [[nodiscard]] int throw_between(Between range) {
    const auto count = static_cast<std::uint64_t>(range.high - range.low) + 1;
    return range.low + static_cast<int>(random_.bits(next_++) % count);
  }
  /// A multiple of `step` from `range.low` on.
  [[nodiscard]] int throw_in_steps(Between range, int step) {
    return range.low + step * throw_between({0, (range.high - range.low) / step});
  }
  [[nodiscard]] bool chance(int percent) { return throw_between({0, 99}) < percent; }
  /// -1 or 1.
  [[nodiscard]] int sign() { return chance(50) ? 1 : -1; }
  template <class List>
  [[nodiscard]] const auto& one_of(const List& list) {
    return list[static_cast<std::size_t>(
        throw_between({0, static_cast<int>(std::size(list)) - 1}))];
  }
  template <class Entry>
  void shuffle(std::vector<Entry>& list) {
    for (int i = static_cast<int>(list.size()) - 1; i > 0; --i) {
      std::swap(list[static_cast<std::size_t>(i)],
                list[static_cast<std::size_t>(throw_between({0, i}))]);
    }
  }

 private:
  Random random_;
  std::uint64_t next_;
};

}  // namespace striate::simulator
