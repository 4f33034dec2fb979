#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "striate/memory/long_term/schema.hpp"

namespace striate::memory {

enum class Access {
  read,    ///< changes nothing; at any time, also while a mission writes
  edit,    ///< a short change by a person; also while a mission writes
  session  ///< the one writer; makes the file where there is none
};

struct MemoryOptions {
  Access access = Access::read;
  std::string software = "striate";  ///< who opens it: told to others, kept with migrations
  std::int64_t now_unix_s = 0;
  std::int64_t most_pages = 0;  ///< the file grows no further, kPage_bytes each; 0: no bound
  int wait_ms = 5000;           ///< for another writer's commit
  int version = schema::kVersion;
  std::span<const schema::Step> steps = schema::steps();
};

}  // namespace striate::memory
