#pragma once

#include <filesystem>
#include <string>

namespace striate {

/// All of a file. @throws UserError where it cannot be read
[[nodiscard]] std::string read_file(const std::string& path);

/// Writes beside the target and renames, so that no half-written result is ever seen; into a device
/// or a pipe directly.
/// @throws std::runtime_error saying which file and why.
void write_file(const std::filesystem::path& path, const std::string& content);

/// Makes the folder of a file that is to be written later, so that a long run does not fail at its
/// last step. Every command asks so for each of its outputs before it begins. An empty path asks
/// for nothing. @throws UserError where nothing can be written there.
void check_writable(const std::string& path);

/// Makes the folder and those above it, for files to be written later; an empty path asks for
/// nothing. @param option that asks for it, "--out", for the message. @throws UserError where it
/// cannot be one, or where nothing can be written into it
void make_folder(const std::filesystem::path& folder, const std::string& option = {});

/// A new folder among the machine's temporary ones that is gone in the end.
class ScratchFolder {
 public:
  /// @throws std::runtime_error where there is no room for one
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] std::string operator/(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

}  // namespace striate
