#include "app/memory/landmark_names.hpp"

#include <filesystem>

#include "app/memory/open_memory.hpp"

namespace striate {

std::vector<std::string> landmark_names_in(const std::string& memory) {
  std::vector<std::string> names;
  if (!std::filesystem::exists(memory)) return names;
  with_memory(memory, Access::read, "looking up its landmarks",
              [&](MemoryTables& tables, MemoryFile&) {
                for (const Landmark& one : tables.landmarks.all(false)) names.push_back(one.name);
              });
  return names;
}

}  // namespace striate
