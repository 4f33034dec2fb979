#include "striate/base/files.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "striate/base/user_error.hpp"

namespace striate {
namespace {

namespace fs = std::filesystem;

/// Makes the folder where it is missing. @returns why it cannot be; empty: it is there
std::string why_not_a_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return error.message();
  return fs::is_directory(folder, error) ? "" : "a file of that name is in the way";
}

/// Permissions do not tell it all (a read-only disk, /proc): a file is made and removed.
std::string why_no_new_file(const fs::path& folder) {
  std::string probe = (folder / ".striate_XXXXXX").string();
  const int file = mkstemp(probe.data());
  if (file < 0) return std::strerror(errno);
  close(file);
  unlink(probe.c_str());
  return {};
}

/// A device or a pipe is written as it is: nothing may take its place.
void write_to_device(const fs::path& path, const std::string& content) {
  std::ofstream stream(path, std::ios::binary);
  stream << content;
  stream.close();
  if (stream) return;
  throw std::runtime_error(
      fmt::format("{}: cannot be written: {}", path.string(), std::strerror(errno)));
}

}  // namespace

std::string read_file(const std::string& path) {
  std::error_code none;
  // A pipe may never say anything, and a device never end.
  if (fs::exists(path, none) && !fs::is_regular_file(path, none)) {
    throw UserError(
        fmt::format("{}: is no file\n    give the file itself, not a folder, a pipe or "
                    "a device",
                    path));
  }
  std::ifstream stream(path, std::ios::binary);
  std::stringstream text;
  text << stream.rdbuf();
  if (!stream) throw UserError(fmt::format("{}: cannot be read\n    is the path right?", path));
  return text.str();
}

void write_file(const fs::path& path, const std::string& content) {
  std::error_code code;
  if (path.has_parent_path()) fs::create_directories(path.parent_path(), code);
  if (fs::exists(path, code) && fs::is_other(path, code)) return write_to_device(path, content);
  const fs::path beside = path.string() + ".part";
  std::ofstream stream(beside, std::ios::binary | std::ios::trunc);
  stream << content;
  stream.close();
  if (!stream) {
    const std::string why = std::strerror(errno);
    fs::remove(beside, code);
    throw std::runtime_error(fmt::format("{}: cannot be written: {}", path.string(), why));
  }
  fs::rename(beside, path, code);
  if (code) {
    const std::string why = code.message();
    fs::remove(beside, code);
    throw std::runtime_error(fmt::format("{}: cannot be written: {}", path.string(), why));
  }
}

void check_writable(const std::string& path) {
  if (path.empty()) return;
  const fs::path target(path);
  const fs::path folder = target.has_parent_path() ? target.parent_path() : ".";
  std::string why = why_not_a_folder(folder);
  std::error_code none;
  if (why.empty() && fs::is_directory(target, none)) why = "it is a folder";
  const bool there = why.empty() && fs::exists(target, none);
  if (there && access(path.c_str(), W_OK) != 0) why = std::strerror(errno);
  const bool device = there && !fs::is_regular_file(target, none);
  if (why.empty() && !device) why = why_no_new_file(folder);
  if (why.empty()) return;
  throw UserError(fmt::format(
      "{}: nothing can be written there: {}\n    give a path in a folder of yours", path, why));
}

void make_folder(const fs::path& folder, const std::string& option) {
  if (folder.empty()) return;
  std::string why = why_not_a_folder(folder);
  if (why.empty()) why = why_no_new_file(folder);
  if (why.empty()) return;
  throw UserError(
      fmt::format("{}{}: is no folder to write into: {}\n    give a folder of yours, or a new one",
                  option.empty() ? option : option + " ", folder.string(), why));
}

ScratchFolder::ScratchFolder() {
  std::string pattern = (fs::temp_directory_path() / "striate_XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no room for a folder");
  path_ = pattern;
}

ScratchFolder::~ScratchFolder() {
  std::error_code none;
  fs::remove_all(path_, none);
}

}  // namespace striate
