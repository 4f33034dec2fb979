#include "tests/failing_calls/failing_calls.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <limits.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstring>

namespace striate::failing_calls {
namespace {

// Plain memory: the functions below are called before anything is constructed, too.
std::array<char, PATH_MAX> folder_text{};
long fails_at = 0;
int fails_with = 0;
bool fails_on = false;
long calls = 0;

bool is_below(const char* path) {
  const std::size_t size = std::strlen(folder_text.data());
  return size > 0 && std::strncmp(path, folder_text.data(), size) == 0;
}

bool fails() {
  ++calls;
  if (fails_at == 0 || (fails_on ? calls < fails_at : calls != fails_at)) return false;
  errno = fails_with;
  return true;
}

bool path_fails(const char* path) {
  return is_below(path) && fails();
}

bool file_fails(int file) {
  if (folder_text[0] == '\0') return false;
  std::array<char, PATH_MAX> path{};
  std::array<char, 64> link{};
  std::snprintf(link.data(), link.size(), "/proc/self/fd/%d", file);
  if (readlink(link.data(), path.data(), path.size() - 1) < 0) return false;
  return is_below(path.data()) && fails();
}

template <class Function>
Function real(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

}  // namespace

void arm(const std::string& folder, long number, int error, bool keeps) {
  std::snprintf(folder_text.data(), folder_text.size(), "%s", folder.c_str());
  fails_at = number;
  fails_with = error;
  fails_on = keeps;
  calls = 0;
}

long count() {
  return calls;
}

}  // namespace striate::failing_calls

using striate::failing_calls::file_fails;
using striate::failing_calls::path_fails;
using striate::failing_calls::real;

extern "C" {

ssize_t write(int file, const void* data, std::size_t size) {
  if (file_fails(file)) return -1;
  return real<ssize_t (*)(int, const void*, std::size_t)>("write")(file, data, size);
}

ssize_t writev(int file, const iovec* parts, int count) {
  if (file_fails(file)) return -1;
  return real<ssize_t (*)(int, const iovec*, int)>("writev")(file, parts, count);
}

ssize_t pwrite64(int file, const void* data, std::size_t size, off64_t at) {
  if (file_fails(file)) return -1;
  return real<ssize_t (*)(int, const void*, std::size_t, off64_t)>("pwrite64")(file, data, size,
                                                                               at);
}

int ftruncate64(int file, off64_t size) {
  if (file_fails(file)) return -1;
  return real<int (*)(int, off64_t)>("ftruncate64")(file, size);
}

int fsync(int file) {
  if (file_fails(file)) return -1;
  return real<int (*)(int)>("fsync")(file);
}

int fdatasync(int file) {
  if (file_fails(file)) return -1;
  return real<int (*)(int)>("fdatasync")(file);
}

int rename(const char* from, const char* to) noexcept {
  if (path_fails(to)) return -1;
  return real<int (*)(const char*, const char*)>("rename")(from, to);
}

int unlink(const char* path) noexcept {
  if (path_fails(path)) return -1;
  return real<int (*)(const char*)>("unlink")(path);
}

int mkdir(const char* path, mode_t mode) noexcept {
  if (path_fails(path)) return -1;
  return real<int (*)(const char*, mode_t)>("mkdir")(path, mode);
}

int open64(const char* path, int flags, ...) {
  mode_t mode = 0;
  if ((flags & O_CREAT) != 0) {
    std::va_list rest;
    va_start(rest, flags);
    mode = va_arg(rest, mode_t);
    va_end(rest);
    if (path_fails(path)) return -1;
  }
  return real<int (*)(const char*, int, ...)>("open64")(path, flags, mode);
}

}  // extern "C"
