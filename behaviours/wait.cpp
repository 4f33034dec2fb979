#include "striate/behaviours/wait.hpp"

namespace striate::behaviours {

Wish Wait::tick(const memory::ShortTermMemory& memory) {
  if (to_seconds(memory.now() - started_) >= settings_.for_s) {
    return final_wish(memory, Progress::succeeded, "waited");
  }
  return standing_wish(memory, "waits");
}

}  // namespace striate::behaviours
