#pragma once

#include <string>

#include "striate/config/configuration_path.hpp"

namespace striate::app {

// Each replaces a name from the command line by the path of the file that it means; "" stays "".
// They throw UserError with every place that was looked at where there is no such file.

inline void find_task(std::string& file) {
  file = config::find_configuration(file, config::FileKind::task);
}

inline void find_world(std::string& file) {
  file = config::find_configuration(file, config::FileKind::world);
}

inline void find_robot(std::string& file) {
  file = config::find_configuration(file, config::FileKind::robot);
}

}  // namespace striate::app
