#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "striate/behaviours/registry.hpp"

namespace striate::app {

/// What a task script can be made of, from the registries of behaviours and conditions themselves.
/// @param only the name of one action or condition; "": all
/// @throws UserError with the nearest name where nothing has that one
[[nodiscard]] nlohmann::ordered_json actions_as_json(const std::string& only = {});
/// The same for people.
[[nodiscard]] std::string actions_as_text(const std::string& only = {});

/// One step that uses the behaviour, as it stands in a script: "back_up: {distance: 0.3 m}".
[[nodiscard]] std::string example_of(const behaviours::BehaviourEntry& behaviour);

}  // namespace striate::app
