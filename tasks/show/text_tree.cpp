#include "striate/tasks/show/outline.hpp"

namespace striate::tasks {
namespace {

void draw(const Outline& node, const std::string& before, std::string& text) {
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    const Outline& child = node.children[i];
    const bool last = i + 1 == node.children.size();
    const std::string limits = limits_of(child);
    text += before + (last ? "└─ " : "├─ ") + title_of(child);
    text += limits.empty() ? "\n" : "  (" + limits + ")\n";
    draw(child, before + (last ? "   " : "│  "), text);
  }
}

}  // namespace

std::string text_tree(const Outline& task) {
  const std::string limits = limits_of(task);
  std::string text = title_of(task) + (limits.empty() ? "\n" : "  (" + limits + ")\n");
  draw(task, "", text);
  return text;
}

}  // namespace striate::tasks
