#include <fmt/format.h>

#include <map>
#include <set>

#include "striate/base/plain_text.hpp"
#include "striate/config/quantity.hpp"
#include "striate/tasks/show/outline.hpp"

namespace striate::tasks {
namespace {

using Ports = std::set<std::string>;

/// Writes the tree in the XML of BehaviorTree.CPP 4. Its own nodes stand where they mean the same;
/// the others (Until, OnlyIf, Unless, RecoveryNode, Task, PauseIf, FailIf) and the actions are
/// described in TreeNodesModel, so that an editor knows their ports.
class XmlWriter {
 public:
  std::string file(const Outline& task) {
    tree(task, task.name);
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<root BTCPP_format=\"4\" main_tree_to_execute=\"{}\">\n{}{}</root>\n",
        xml_text(task.name), trees_, models());
  }

 private:
  /// A whole task: guards first, then its steps, then what is done after every ending.
  void tree(const Outline& task, const std::string& id) {
    std::string outer;
    outer.swap(body_);
    const int outer_depth = std::exchange(depth_, 2);
    std::vector<Outline::Argument> goal;
    if (task.kind == Outline::Kind::task && !task.until.empty()) goal = {{"goal", "line"}};
    open("Control", "Task", goal, nullptr);
    for (const Outline& part : task.children) {
      if (part.kind != Outline::Kind::always) {
        node(part);
        continue;
      }
      for (const Outline& guard : part.children) this->guard(guard);
    }
    close("Task");
    trees_ += fmt::format("  <BehaviorTree ID=\"{}\">\n{}  </BehaviorTree>\n", xml_text(id), body_);
    body_.swap(outer);
    depth_ = outer_depth;
  }

  void guard(const Outline& guard) {
    leaf("Condition", guard.name == "pause_if" ? "PauseIf" : "FailIf", condition(guard.until));
  }

  /// A node inside of what the keys beside it put round it, the outermost first.
  void node(const Outline& step) {
    std::vector<std::string> around;
    const auto wrap = [&](const char* type, const char* id,
                          const std::vector<Outline::Argument>& a) {
      open(type, id, a, nullptr);
      around.emplace_back(id);
    };
    if (!step.only_if.empty()) wrap("Decorator", "OnlyIf", condition(step.only_if));
    if (!step.unless.empty()) wrap("Decorator", "Unless", condition(step.unless));
    if (step.optional) wrap("", "ForceSuccess", {});
    const Outline* recovery = recovery_of(step);
    if (recovery != nullptr) {
      wrap("Control", "RecoveryNode", {{"number_of_retries", std::to_string(recovery->times)}});
    }
    const std::size_t with_recovery = around.size();
    if (!step.within.empty()) wrap("", "Timeout", {{"msec", milliseconds(step.within)}});
    if (!step.until.empty()) wrap("Decorator", "Until", condition(step.until));
    inner(step);
    while (!around.empty()) {
      if (around.size() == with_recovery && recovery != nullptr) inner(*recovery);
      close(around.back());
      around.pop_back();
    }
  }

  void inner(const Outline& step) {
    switch (step.kind) {
      case Outline::Kind::action:
        return leaf("Action", step.name, step.arguments);
      case Outline::Kind::use: {
        const std::string id = fmt::format("{} {}", step.name, ++subtrees_);
        leaf("", "SubTree", {{"ID", id}});
        return tree(step, id);
      }
      case Outline::Kind::repeat:
        open("", "Repeat", {{"num_cycles", step.times == 0 ? "-1" : std::to_string(step.times)}},
             nullptr);
        open("", "Sequence", {}, nullptr);
        children(step);
        close("Sequence");
        return close("Repeat");
      case Outline::Kind::fallback:
        return group("Fallback", step, {});
      case Outline::Kind::parallel:
        return group("Parallel", step, {{"success_count", "-1"}, {"failure_count", "1"}});
      default:
        return group("Sequence", step, {{"name", step.name}});
    }
  }

  void group(const char* id, const Outline& step,
             const std::vector<Outline::Argument>& attributes) {
    open("", id, attributes, nullptr);
    children(step);
    close(id);
  }

  void children(const Outline& step) {
    for (const Outline& child : step.children) {
      if (child.kind != Outline::Kind::recovery) node(child);
    }
  }

  static const Outline* recovery_of(const Outline& step) {
    for (const Outline& child : step.children) {
      if (child.kind == Outline::Kind::recovery) return &child;
    }
    return nullptr;
  }

  static std::vector<Outline::Argument> condition(const std::string& text) {
    const std::size_t colon = text.find(": ");
    return {{"condition", text.substr(0, colon)},
            {"value", colon == std::string::npos ? "" : text.substr(colon + 2)}};
  }

  static std::string milliseconds(const std::string& duration) {
    config::Diagnostics unheard("");
    config::Node node;
    node.kind = config::Node::Kind::scalar;
    node.text = duration;
    const auto value_s = config::read_quantity(node, config::Unit::duration, {0, 1e9}, unheard);
    return value_s ? fmt::format("{:.0f}", *value_s * 1000.0) : duration;
  }

  void open(const std::string& type, const std::string& id,
            const std::vector<Outline::Argument>& attributes, const char* end) {
    if (!type.empty()) {
      Ports& ports = models_[{type, id}];
      for (const auto& [key, value] : attributes) ports.insert(key);
    }
    body_ += std::string(2 * static_cast<std::size_t>(depth_), ' ') + "<" + id;
    for (const auto& [key, value] : attributes) {
      body_ += fmt::format(" {}=\"{}\"", key, xml_text(value));
    }
    body_ += end == nullptr ? ">\n" : end;
    if (end == nullptr) ++depth_;
  }
  void leaf(const std::string& type, const std::string& id,
            const std::vector<Outline::Argument>& attributes) {
    open(type, id, attributes, "/>\n");
  }
  void close(const std::string& id) {
    --depth_;
    body_ += fmt::format("{}</{}>\n", std::string(2 * static_cast<std::size_t>(depth_), ' '), id);
  }

  [[nodiscard]] std::string models() const {
    std::string text = "  <TreeNodesModel>\n";
    for (const auto& [node, ports] : models_) {
      text += fmt::format("    <{} ID=\"{}\">\n", node.first, node.second);
      for (const std::string& port : ports) {
        text += fmt::format("      <input_port name=\"{}\"/>\n", port);
      }
      text += fmt::format("    </{}>\n", node.first);
    }
    return text + "  </TreeNodesModel>\n";
  }

  std::string trees_;
  std::string body_;
  int depth_ = 2;
  int subtrees_ = 0;
  std::map<std::pair<std::string, std::string>, Ports> models_;
};

}  // namespace

std::string xml_tree(const Outline& task) {
  return XmlWriter().file(task);
}

}  // namespace striate::tasks
