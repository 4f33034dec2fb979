#include "striate/python/files.hpp"

#include <dlfcn.h>

#include "striate/config/configuration_path.hpp"

namespace striate::python {

namespace fs = std::filesystem;

std::string task_file(const fs::path& given) {
  return config::find_configuration(given.string(), config::FileKind::task);
}

std::string world_file(const fs::path& given) {
  return config::find_configuration(given.string(), config::FileKind::world);
}

std::string robot_file(const fs::path& given) {
  return config::find_configuration(given.string(), config::FileKind::robot);
}

agent::RobotSettings settings_of(const fs::path& robot) {
  const std::string file = robot_file(robot);
  if (!file.empty()) open_to_plugins();
  return agent::load_robot_settings(file);
}

void open_to_plugins() {
  Dl_info here{};
  if (::dladdr(reinterpret_cast<const void*>(&open_to_plugins), &here) == 0) return;
  // It is loaded already: this only makes its symbols known to all that comes after it.
  (void)::dlopen(here.dli_fname, RTLD_NOW | RTLD_NOLOAD | RTLD_GLOBAL);
}

}  // namespace striate::python
