#include "base/files.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "base/user_error.hpp"

namespace striate {
namespace {

namespace fs = std::filesystem;

}  // namespace

std::string read_file(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::stringstream text;
  text << stream.rdbuf();
  if (!stream) throw UserError(fmt::format("{}: cannot be read\n    is the path right?", path));
  return text.str();
}

void write_file(const fs::path& path, const std::string& content) {
  std::error_code code;
  if (path.has_parent_path()) fs::create_directories(path.parent_path(), code);
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
    throw std::runtime_error(
        fmt::format("{}: cannot be written: {}", path.string(), code.message()));
  }
}

void check_writable(const std::string& path) {
  const fs::path target(path);
  const fs::path folder = target.has_parent_path() ? target.parent_path() : ".";
  std::error_code code;
  fs::create_directories(folder, code);
  if (!code && !fs::is_directory(target) && access(folder.c_str(), W_OK) == 0) return;
  throw UserError(
      fmt::format("{}: nothing can be written there{}\n    give a path in a folder of yours", path,
                  code ? ": " + code.message() : std::string()));
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder)) {
    throw UserError(fmt::format("--out {}: cannot be made a folder{}", folder.string(),
                                error ? ": " + error.message() : ""));
  }
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
