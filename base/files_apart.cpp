#include "striate/base/files_apart.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "striate/base/user_error.hpp"

namespace striate {
namespace {

namespace fs = std::filesystem;

/// By whatever names: a link, "./x" or "x". Also of files that are still to be made.
bool are_one_file(const std::string& one, const std::string& other) {
  if (one.empty() || other.empty()) return false;
  std::error_code none;
  if (fs::exists(one, none) && !fs::is_regular_file(one, none)) return false;
  if (fs::equivalent(one, other, none)) return true;
  const fs::path place = fs::weakly_canonical(fs::absolute(one, none), none);
  return !place.empty() && place == fs::weakly_canonical(fs::absolute(other, none), none);
}

void check_pair(const NamedFile& one, const NamedFile& other) {
  if (!are_one_file(one.path, other.path)) return;
  throw UserError(fmt::format("{} and {} are the same file, {}\n    give each a file of its own",
                              other.by, one.by, one.path));
}

}  // namespace

void check_apart(const std::vector<NamedFile>& written, const std::vector<NamedFile>& read) {
  for (auto one = written.begin(); one != written.end(); ++one) {
    for (const NamedFile& other : read) check_pair(*one, other);
    for (auto other = written.begin(); other != one; ++other) check_pair(*one, *other);
  }
}

}  // namespace striate
