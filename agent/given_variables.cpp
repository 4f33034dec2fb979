#include "striate/agent/given_variables.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "striate/base/user_error.hpp"
#include "striate/config/quantity.hpp"

namespace striate::agent {

tasks::GivenVariables read_variables(const std::vector<std::string>& given) {
  tasks::GivenVariables variables;
  for (const std::string& text : given) {
    const std::size_t equals = text.find('=');
    if (equals == 0 || equals == std::string::npos) {
      throw UserError("--var '" + text + "': is no variable\n  hint: --var \"way=20 m\"");
    }
    variables[text.substr(0, equals)] = text.substr(equals + 1);
  }
  return variables;
}

void check_variables(const tasks::GivenVariables& given, const tasks::Task& task) {
  const std::vector<std::string>& known = task.variables;
  for (const auto& [name, value] : given) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    std::string hint = config::suggest(name, known);
    if (hint.empty()) {
      hint = known.empty() ? "it has none" : fmt::format("it has {}", fmt::join(known, ", "));
    }
    throw UserError(fmt::format("--var '{}={}': {} has no variable '{}'\n  hint: {}", name, value,
                                task.file, name, hint));
  }
}

}  // namespace striate::agent
