#include <fmt/format.h>

#include "striate/tasks/show/outline.hpp"

namespace striate::tasks {
namespace {

std::string arguments_of(const Outline& node) {
  std::string text;
  for (const auto& [key, value] : node.arguments) {
    text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", key, value);
  }
  return text.empty() ? text : " {" + text + "}";
}

const char* plural(int count) {
  return count == 1 ? "" : "s";
}

}  // namespace

std::string title_of(const Outline& node) {
  switch (node.kind) {
    case Outline::Kind::task:
      return "task " + node.name;
    case Outline::Kind::guard:
      return fmt::format("{} {}", node.name, node.until);
    case Outline::Kind::repeat:
      return node.times == 0 ? "repeat"
                             : fmt::format("repeat {} time{}", node.times, plural(node.times));
    case Outline::Kind::recovery: {
      const char* tries = node.times == 1 ? "try" : "tries";
      return fmt::format("if_it_fails, {} more {}", node.times, tries);
    }
    case Outline::Kind::use:
      return "use " + node.name + arguments_of(node);
    case Outline::Kind::action:
      return node.name + arguments_of(node);
    default:
      break;
  }
  return node.name;
}

std::string limits_of(const Outline& node) {
  std::string text;
  const auto add = [&text](const char* word, const std::string& value) {
    if (!value.empty()) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", word, value);
  };
  add("only if", node.only_if);
  add("unless", node.unless);
  if (node.kind != Outline::Kind::guard) add("until", node.until);
  add("within", node.within);
  if (node.optional) text += text.empty() ? "optional" : ", optional";
  return text;
}

}  // namespace striate::tasks
