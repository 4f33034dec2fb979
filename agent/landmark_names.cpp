#include "striate/agent/landmark_names.hpp"

#include <filesystem>

#include "striate/agent/open_memory.hpp"

namespace striate::agent {

std::vector<std::string> landmark_names_in(const std::string& memory) {
  std::vector<std::string> names;
  if (!std::filesystem::exists(memory)) return names;
  with_memory(memory, memory::Access::read, "looking up its landmarks",
              [&](memory::MemoryTables& tables, memory::MemoryFile&) {
                for (const memory::Landmark& one : tables.landmarks.all(false))
                  names.push_back(one.name);
              });
  return names;
}

}  // namespace striate::agent
