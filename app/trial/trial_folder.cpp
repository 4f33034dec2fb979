#include "striate/app/trial/trial_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

#include "striate/base/files.hpp"
#include "striate/base/user_error.hpp"

namespace striate::app {

TrialFolder::TrialFolder(const std::string& out) {
  make_folder(out + "/runs", "--out");
  descriptor_ = open(out.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  // A file system without locks is no reason to refuse a trial.
  if (descriptor_ < 0 || flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  close(descriptor_);
  throw UserError(fmt::format(
      "{}: another trial is writing into it\n    wait until it has ended, or give another --out "
      "folder",
      out));
}

TrialFolder::~TrialFolder() {
  if (descriptor_ >= 0) close(descriptor_);
}

}  // namespace striate::app
