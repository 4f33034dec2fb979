#pragma once

#include <string>
#include <vector>

namespace striate {

/// A file that somebody names: {"--record", "run.rec"}.
struct NamedFile {
  std::string by;
  std::string path;  ///< empty: none
};

/// Nothing that is written may take the place of what else was named: a task that its own recording
/// overwrites is lost, and of two results one. Two that are read alone may be one file, and all may
/// be one device.
/// @throws UserError that names both
void check_apart(const std::vector<NamedFile>& written, const std::vector<NamedFile>& read);

}  // namespace striate
