#include <dlfcn.h>
#include <limits.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <string>

/// Preloaded into a program, this makes one folder a small disk: its files may hold
/// SMALL_DISK_BYTES together, and a write that would make them grow beyond fails as on a full disk.
/// No right is needed for it, unlike for mounting a real one. Only pwrite64 is watched: with that
/// SQLite writes.
namespace {

std::string path_of(int file) {
  std::array<char, PATH_MAX> path{};
  const std::string link = "/proc/self/fd/" + std::to_string(file);
  const ssize_t size = readlink(link.c_str(), path.data(), path.size());
  return size < 0 ? "" : std::string(path.data(), static_cast<std::size_t>(size));
}

bool fits(int file, off64_t end) {
  const char* folder = std::getenv("SMALL_DISK");
  const char* bytes = std::getenv("SMALL_DISK_BYTES");
  if (folder == nullptr || bytes == nullptr) return true;
  if (path_of(file).rfind(std::string(folder) + "/", 0) != 0) return true;
  struct stat64 status {};
  if (fstat64(file, &status) != 0 || end <= status.st_size) return true;
  std::uintmax_t used = 0;
  std::error_code gone;  // a file may go while it is looked at
  for (const auto& entry : std::filesystem::directory_iterator(folder, gone)) {
    const std::uintmax_t size = entry.file_size(gone);
    if (!gone) used += size;
  }
  return used + static_cast<std::uintmax_t>(end - status.st_size) <= std::stoull(bytes);
}

}  // namespace

extern "C" ssize_t pwrite64(int file, const void* data, std::size_t size, off64_t at) {
  using Write = ssize_t (*)(int, const void*, std::size_t, off64_t);
  static const auto real = reinterpret_cast<Write>(dlsym(RTLD_NEXT, "pwrite64"));
  if (!fits(file, at + static_cast<off64_t>(size))) {
    errno = ENOSPC;
    return -1;
  }
  return real(file, data, size, at);
}
