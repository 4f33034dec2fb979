#include "striate/agent/plugins/load_plugin.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <utility>

#include "striate/agent/plugins/plugin_contents.hpp"
#include "striate/base/user_error.hpp"
#include "striate/tasks/condition_registry.hpp"

namespace striate::agent {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& file, const std::string& what,
                         const std::string& hint) {
  throw UserError(fmt::format("{}: {}\n  hint: {}", file, what, hint));
}

std::string found(const std::string& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) {
    refuse(file, "there is no such plugin", "name the shared object, a file *.so");
  }
  return fs::canonical(file).string();
}

/// What the loader of the system says, without the path that we say ourselves.
std::string loader_error(const std::string& path) {
  const char* error = ::dlerror();
  std::string text = error == nullptr ? "it does not say why" : error;
  if (text.starts_with(path + ": ")) text.erase(0, path.size() + 2);
  return text;
}

/// A handle is never given back: behaviours and conditions live in the object's code.
const PluginInfo* info_of(const std::string& file, const std::string& path) {
  void* object = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (object == nullptr) {
    refuse(file, fmt::format("cannot be loaded as a plugin: {}", loader_error(path)),
           "build it as a shared object, linked with all that it uses; see docs/plugins.md");
  }
  using Ask = const PluginInfo* (*)();
  const auto ask = reinterpret_cast<Ask>(::dlsym(object, "striate_plugin"));
  const PluginInfo* info = ask == nullptr ? nullptr : ask();
  if (info == nullptr) {
    refuse(file, "is a shared object, but no plugin of Striate: it has no 'striate_plugin'",
           "add STRIATE_PLUGIN(name, function) to it; see docs/plugins.md");
  }
  return info;
}

/// In this order: what the later fields mean depends on the earlier ones.
void check_build(const std::string& file, const PluginInfo& info) {
  const std::string again = fmt::format("build it again with the headers of Striate {}", kVersion);
  if (info.interface != kPluginInterface) {
    refuse(file,
           fmt::format("is built for the plugin interface {}, but this Striate has interface {}",
                       info.interface, kPluginInterface),
           again);
  }
  if (std::strcmp(info.striate_version, kVersion) != 0) {
    refuse(file,
           fmt::format("is built for Striate {}, but this is {}", info.striate_version, kVersion),
           again);
  }
  if (std::strcmp(info.compiler_abi, kCompilerAbi) != 0) {
    refuse(file,
           fmt::format("is built by a compiler with {}, but Striate by one with {}",
                       info.compiler_abi, kCompilerAbi),
           "build it with the compiler that Striate was built with");
  }
  if (info.layout != kPluginLayout) {
    refuse(file, "is built with headers of another state of Striate than this one", again);
  }
}

std::vector<PluginInUse>& in_use() {
  static std::vector<PluginInUse> plugins;
  return plugins;
}

template <class Entry>
void enroll_all(std::vector<Entry>& entries) {
  for (Entry& entry : entries) (void)enroll(std::move(entry));
}

}  // namespace

Plugin load_plugin(const std::string& file) {
  Plugin plugin;
  plugin.file = found(file);
  const PluginInfo& info = *info_of(file, plugin.file);
  check_build(file, info);
  plugin.name = info.name;
  for (const PluginInUse& other : plugins_in_use()) {
    if (other.name != plugin.name) continue;
    refuse(file,
           fmt::format("has the name '{}', as {} has, which is in use", other.name, other.file),
           "name only one of them");
  }
  PluginContents contents(plugin);
  try {
    info.enroll(contents);
  } catch (const UserError&) {
    throw;
  } catch (const std::exception& error) {
    refuse(file, fmt::format("cannot be used: {}", error.what()), "mend the plugin");
  }
  return plugin;
}

void use_plugin(const std::string& file) {
  std::error_code error;
  const std::string path = fs::canonical(file, error).string();
  const auto same = [&](const PluginInUse& plugin) { return plugin.file == path; };
  if (!error && std::any_of(in_use().begin(), in_use().end(), same)) return;
  Plugin plugin = load_plugin(file);
  enroll_all(plugin.behaviours);
  enroll_all(plugin.conditions);
  enroll_all(plugin.stages);
  enroll_all(plugin.bodies);
  in_use().push_back({plugin.name, plugin.file});
}

const std::vector<PluginInUse>& plugins_in_use() {
  return in_use();
}

}  // namespace striate::agent
