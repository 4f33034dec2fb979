#include "behaviours/wait.hpp"

namespace striate {

Wish Wait::tick(const ShortTermMemory& memory) {
  if (to_seconds(memory.now() - started_) >= settings_.for_s) {
    return final_wish(memory, Progress::succeeded, "waited");
  }
  return standing_wish(memory, "waits");
}

}  // namespace striate
