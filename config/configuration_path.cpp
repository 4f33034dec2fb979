#include "striate/config/configuration_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "striate/base/user_error.hpp"
#include "striate/config/program_folder.hpp"
#include "striate/config/quantity.hpp"

namespace striate::config {
namespace {

namespace fs = std::filesystem;

bool is_set(const char* value) {
  return value != nullptr && *value != '\0';
}

/// The parts of `given` below a configuration's folder: "tasks/corridor.yaml". None: it is a path.
std::vector<fs::path> parts_of(const fs::path& given, FileKind kind) {
  if (given.empty() || given.is_absolute()) return {};
  if (*given.begin() == "config") return {given.lexically_relative("config")};
  if (given.has_parent_path()) return {};
  std::vector<fs::path> parts;
  for (const std::string& folder : folders_of(kind)) parts.push_back(folder / given);
  return parts;
}

void add(const fs::path& path, std::vector<fs::path>& list) {
  list.push_back(path);
  if (path.extension() != ".yaml") list.emplace_back(path.string() + ".yaml");
}

void add_meanings_in(const std::vector<ConfigurationFolder>& folders,
                     const std::vector<fs::path>& parts, std::vector<fs::path>& list) {
  for (const ConfigurationFolder& folder : folders) {
    for (const fs::path& part : parts) add(folder.path / part, list);
  }
}

/// "": there is none.
std::string first_file(const std::vector<fs::path>& paths) {
  std::error_code code;
  for (const fs::path& path : paths) {
    if (fs::is_regular_file(path, code)) return path.string();
  }
  return {};
}

/// Names of the files that could have been meant, without ".yaml".
std::vector<std::string> known_names(FileKind kind,
                                     const std::vector<ConfigurationFolder>& folders) {
  std::vector<std::string> names;
  for (const ConfigurationFolder& folder : folders) {
    for (const std::string& of_kind : folders_of(kind)) {
      std::error_code code;
      for (fs::directory_iterator file(folder.path / of_kind, code), end; !code && file != end;
           file.increment(code)) {
        if (file->path().extension() == ".yaml") names.push_back(file->path().stem().string());
      }
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

[[noreturn]] void tell_not_found(const std::string& given, FileKind kind,
                                 const std::vector<ConfigurationFolder>& folders) {
  std::string text = fmt::format("{}: error: there is no such file; looked at:", given);
  for (const fs::path& path : meanings_of(given, kind, folders)) {
    text += fmt::format("\n      {}", path.string());
  }
  const std::string hint = suggest(fs::path(given).stem().string(), known_names(kind, folders));
  if (!hint.empty()) text += "\n    " + hint;
  text += "\n    'striate config --paths' lists the files that are there";
  throw UserError(text);
}

}  // namespace

std::vector<std::string> folders_of(FileKind kind) {
  switch (kind) {
    case FileKind::task:
      return {"tasks"};
    case FileKind::world:
      return {"worlds"};
    case FileKind::robot:
      return {"robots"};
    case FileKind::any:
      break;
  }
  return {"tasks", "worlds", "robots"};
}

std::vector<ConfigurationFolder> configuration_folders_of(const fs::path& program_folder,
                                                          const char* xdg_config_home,
                                                          const char* home) {
  std::vector<ConfigurationFolder> folders;
  if (!program_folder.empty()) {
    folders.push_back({program_folder / "config", "beside the program"});
    folders.push_back({(program_folder / "../share/striate/config").lexically_normal(),
                       "installed with the program"});
  }
  if (is_set(xdg_config_home) && fs::path(xdg_config_home).is_absolute()) {
    folders.push_back({fs::path(xdg_config_home) / "striate", "your own"});
  } else if (is_set(home)) {
    folders.push_back({fs::path(home) / ".config" / "striate", "your own"});
  }
  return folders;
}

const std::vector<ConfigurationFolder>& configuration_folders() {
  static const std::vector<ConfigurationFolder> folders = configuration_folders_of(
      program_folder(), std::getenv("XDG_CONFIG_HOME"), std::getenv("HOME"));
  return folders;
}

std::vector<fs::path> meanings_of(const std::string& given, FileKind kind,
                                  const std::vector<ConfigurationFolder>& folders) {
  const std::vector<fs::path> parts = parts_of(given, kind);
  if (parts.empty()) return {given};
  std::vector<fs::path> list;
  add(given, list);
  add_meanings_in(folders, parts, list);
  return list;
}

std::string find_in_configuration(const std::string& given, FileKind kind,
                                  const std::vector<ConfigurationFolder>& folders) {
  std::vector<fs::path> list;
  add_meanings_in(folders, parts_of(given, kind), list);
  return first_file(list);
}

std::string find_configuration(const std::string& given, FileKind kind,
                               const std::vector<ConfigurationFolder>& folders) {
  const std::vector<fs::path> meanings = meanings_of(given, kind, folders);
  if (meanings.size() == 1) return given;
  if (const std::string file = first_file(meanings); !file.empty()) return file;
  std::error_code code;
  if (fs::exists(given, code)) return given;
  tell_not_found(given, kind, folders);
}

}  // namespace striate::config
