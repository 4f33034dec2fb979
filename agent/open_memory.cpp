#include "striate/agent/open_memory.hpp"

#include <cstdio>
#include <ctime>

#include "striate/base/say.hpp"
#include "striate/base/version.hpp"

namespace striate::agent {

memory::MemoryOptions memory_options(memory::Access access, const std::string& who) {
  memory::MemoryOptions options;
  options.access = access;
  options.software = who;
  options.now_unix_s = static_cast<std::int64_t>(std::time(nullptr));
  return options;
}

std::string software_name() {
  return std::string("striate ") + kVersion;
}

void print_notices(const std::vector<std::string>& notices) {
  for (const std::string& notice : notices) say(stderr, notice + "\n");
}

}  // namespace striate::agent
