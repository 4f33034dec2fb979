#include "striate/behaviours/stop.hpp"

#include <cmath>

namespace striate::behaviours {

Wish Stop::tick(const memory::ShortTermMemory& memory) {
  const bool stands = std::abs(memory.forward_m_s()) < 0.01 && std::abs(memory.turn_rad_s()) < 0.02;
  return stands ? final_wish(memory, Progress::succeeded, "stands")
                : standing_wish(memory, "stops");
}

}  // namespace striate::behaviours
