#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace striate {

/// "1 pose", "2 poses". @param thing whose plural is made with an s
[[nodiscard]] inline std::string counted(std::size_t count, std::string_view thing) {
  return std::to_string(count) + " " + std::string(thing) + (count == 1 ? "" : "s");
}

}  // namespace striate
