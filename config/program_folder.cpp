#include "striate/config/program_folder.hpp"

#include <system_error>

namespace striate::config {
namespace {

std::filesystem::path& folder_that_was_set() {
  static std::filesystem::path folder;
  return folder;
}

}  // namespace

std::filesystem::path program_folder() {
  if (!folder_that_was_set().empty()) return folder_that_was_set();
  std::error_code code;
  return std::filesystem::read_symlink("/proc/self/exe", code).parent_path();
}

void set_program_folder(const std::filesystem::path& folder) {
  folder_that_was_set() = folder;
}

}  // namespace striate::config
