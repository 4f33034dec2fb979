#include "striate/app/configuration_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

namespace striate::app {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> yaml_files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code code;
  for (fs::directory_iterator file(folder, code), end; !code && file != end; file.increment(code)) {
    if (file->path().extension() == ".yaml") files.push_back(file->path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// The files of one kind by their names, and those whose name another file has taken.
struct FilesFound {
  std::map<std::string, fs::path> by_name;
  std::vector<fs::path> hidden;
};

FilesFound files_of(const std::string& kind,
                    const std::vector<config::ConfigurationFolder>& folders) {
  FilesFound found;
  for (const config::ConfigurationFolder& folder : folders) {
    for (const fs::path& file : yaml_files_in(folder.path / kind)) {
      const auto [taken, is_first] = found.by_name.emplace(file.stem().string(), file);
      std::error_code code;
      if (!is_first && !fs::equivalent(taken->second, file, code)) found.hidden.push_back(file);
    }
  }
  return found;
}

}  // namespace

std::string configuration_report(const std::vector<config::ConfigurationFolder>& folders) {
  std::string text =
      "A name like 'corridor' and a path that begins with config/ are looked for in this order:\n"
      "  1  the working directory, as given\n";
  int number = 2;
  for (const config::ConfigurationFolder& folder : folders) {
    std::error_code code;
    const bool there = fs::is_directory(folder.path, code);
    text += fmt::format("  {}  {}  ({}{})\n", number++, folder.path.string(), folder.what,
                        there ? "" : "; not there");
  }
  std::vector<fs::path> hidden;
  for (const std::string& kind : config::folders_of(config::FileKind::any)) {
    const FilesFound found = files_of(kind, folders);
    text += fmt::format("\n{}\n", kind);
    if (found.by_name.empty()) text += "  none\n";
    for (const auto& [name, file] : found.by_name) {
      text += fmt::format("  {:<18}  {}\n", name, file.string());
    }
    hidden.insert(hidden.end(), found.hidden.begin(), found.hidden.end());
  }
  if (hidden.empty()) return text;
  text += "\nHidden by a file of the same name above: give these another name, or their path\n";
  for (const fs::path& file : hidden) text += fmt::format("  {}\n", file.string());
  return text;
}

}  // namespace striate::app
