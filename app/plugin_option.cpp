#include "striate/app/plugin_option.hpp"

#include "striate/agent/plugins/load_plugin.hpp"

namespace striate::app {

std::shared_ptr<const std::vector<std::string>> add_plugin_option(CLI::App& command) {
  auto files = std::make_shared<std::vector<std::string>>();
  command
      .add_option_function<std::vector<std::string>>(
          "--plugin",
          [files](const std::vector<std::string>& given) {
            *files = given;
            for (const std::string& file : given) agent::use_plugin(file);
          },
          "a shared object with behaviours, conditions, stages or bodies; more than one may be "
          "given")
      ->allow_extra_args(false)
      ->take_all();
  return files;
}

}  // namespace striate::app
