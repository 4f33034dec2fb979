#pragma once

#include <memory>
#include <string>

#include "striate/config/diagnostics.hpp"
#include "striate/config/node.hpp"
#include "striate/tasks/condition.hpp"

namespace striate::tasks {

/// Reads `{name: value}`, or conditions that are joined: `{all: [{...}, {...}]}`, `{any: [...]}`,
/// `{not: {...}}`, in each other too; nullptr with mistakes added where that fails.
std::unique_ptr<Condition> read_condition(const config::Node& node,
                                          config::Diagnostics& diagnostics);

/// "name: value" as written, for people, or "all: [travelled: 58 m, landmark_seen: book]"; empty
/// where the node is no condition.
[[nodiscard]] std::string condition_text(const config::Node& node);

/// The condition, once it holds, goes on holding for as long as the robot stands: returns where its
/// reason is written, or nullptr. For a node that read_condition() took.
[[nodiscard]] const config::Node::Entry* lasts_while_standing(const config::Node& condition);

}  // namespace striate::tasks
