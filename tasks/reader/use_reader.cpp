#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "striate/config/configuration_path.hpp"
#include "striate/config/map_reader.hpp"
#include "striate/config/yaml.hpp"
#include "striate/tasks/fault.hpp"
#include "striate/tasks/reader/script_reader.hpp"

namespace striate::tasks {
namespace {

using config::Diagnostics;
using config::Node;
namespace fs = std::filesystem;

constexpr std::size_t kDeepest = 8;  ///< by hand: files that use each other; more is a circle

/// Reads the file that a step uses, with the step's parameters.
class UseReader {
 public:
  UseReader(const Node& step, ReadContext& context, Diagnostics& diagnostics)
      : step_(step), use_(*step.find("use")), context_(context), diagnostics_(diagnostics) {}

  Branch read() {
    Branch branch;
    branch.outline.kind = Outline::Kind::use;
    branch.outline.name = use_.value.text;
    read_with(branch.outline);
    if (!find_file()) return branch;
    Diagnostics of_file(file_, diagnostics_.letter());
    context_.files.push_back(used_);
    if (std::find(context_.read.begin(), context_.read.end(), used_) == context_.read.end()) {
      context_.read.push_back(used_);
    }
    Script script = ScriptReader(context_, given_, of_file).read(load_yaml(of_file));
    context_.files.pop_back();
    tell(script, of_file);
    branch.flow = script.flow;
    branch.outline.children = std::move(script.task.outline.children);
    branch.node = std::move(script.task.root);
    return branch;
  }

 private:
  void read_with(Outline& outline) {
    const Node::Entry* with = step_.find("with");
    if (with == nullptr) return;
    if (with->value.kind != Node::Kind::map) {
      diagnostics_.add(fault::wrong_kind, with->value.place,
                       fmt::format("'with' must be a map, but is {}", with->value.describe()),
                       "write with: {speed: 0.4 m/s}");
      return;
    }
    for (const Node::Entry& entry : with->value.entries) {
      if (entry.value.kind != Node::Kind::scalar) {
        diagnostics_.add(fault::bad_variable, entry.value.place,
                         fmt::format("the parameter '{}' must be one value", entry.key));
      }
      Variable& variable = given_[entry.key];
      variable.value = entry.value;
      variable.value.open = entry.value.open || entry.value.kind != Node::Kind::scalar;
      variable.origin = fmt::format("given in {}:{}", diagnostics_.file(), entry.value.place.line);
      outline.arguments.emplace_back(entry.key, entry.value.text);
    }
  }

  /// The file is looked for beside the one that uses it, then as a task of a configuration.
  bool find_file() {
    const Node& name = use_.value;
    if (name.kind != Node::Kind::scalar || name.text.empty() || name.open) {
      diagnostics_.add(fault::wrong_kind, name.place, "'use' must be the name of a task file",
                       "write '- use: return.yaml'");
      return false;
    }
    const fs::path beside = fs::path(diagnostics_.file()).parent_path() / name.text;
    std::error_code code;
    const fs::path path =
        fs::is_regular_file(beside, code)
            ? beside
            : fs::path(config::find_in_configuration(name.text, config::FileKind::task));
    if (path.empty()) {
      diagnostics_.add(fault::unknown_file, name.place,
                       fmt::format("there is no task file '{}'", name.text), near_name(beside));
      return false;
    }
    file_ = path.lexically_normal().string();
    used_.path = fs::canonical(path, code).string();
    const fs::path users_folder = fs::path(context_.files.back().place).parent_path();
    used_.place = (users_folder / name.text).lexically_normal().string();
    return !uses_itself() && !too_deep();
  }

  bool uses_itself() {
    const auto& files = context_.files;
    const auto found = std::ranges::find(files, used_.path, &TaskFile::path);
    if (found == files.end()) return false;
    std::string chain;
    for (auto file = found; file != files.end(); ++file) {
      chain += fs::path(file->path).filename().string() + " uses ";
    }
    chain += fs::path(used_.path).filename().string();
    diagnostics_.add(fault::uses_itself, use_.value.place,
                     fmt::format("a task must not use itself: {}", chain),
                     "write 'repeat' for what is to be done again");
    return true;
  }

  bool too_deep() {
    if (context_.files.size() < kDeepest) return false;
    diagnostics_.add(fault::too_large, use_.value.place,
                     fmt::format("more than {} files that use each other", kDeepest));
    return true;
  }

  static std::string near_name(const fs::path& path) {
    std::vector<std::string> names;
    std::error_code code;
    const fs::path folder = path.has_parent_path() ? path.parent_path() : ".";
    for (fs::directory_iterator file(folder, code), end; !code && file != end;
         file.increment(code)) {
      if (file->path().extension() == ".yaml") names.push_back(file->path().filename().string());
    }
    std::sort(names.begin(), names.end());
    const std::string hint = config::suggest(path.filename().string(), names);
    return hint.empty() ? "the path counts from the file that uses it" : hint;
  }

  /// Diagnostics of values that `with` gave belong to the file that gave them.
  void tell(const Script& script, Diagnostics& of_file) {
    const Node::Entry* with = step_.find("with");
    for (const auto& [name, variable] : given_) {
      const Node::Entry* entry = with->value.find(name);
      if (std::find(script.parameters.begin(), script.parameters.end(), name) ==
          script.parameters.end()) {
        if (!of_file.none() && script.parameters.empty()) continue;
        std::string hint = config::suggest(name, script.parameters);
        if (hint.empty()) hint = fmt::format("known: {}", fmt::join(script.parameters, ", "));
        diagnostics_.add(fault::unknown_parameter, entry->key_place,
                         fmt::format("{} has no parameter '{}'", use_.value.text, name), hint);
      }
      for (const Substitution& done : script.substitutions) {
        if (done.name == name) move_diagnostics(of_file, done, entry->value.place);
      }
    }
    for (const std::string& name : script.missing) {
      diagnostics_.add(fault::missing_parameter, use_.value.place,
                       fmt::format("{} needs the parameter '{}'", use_.value.text, name),
                       fmt::format("add with: {{{}: ...}}", name));
    }
    diagnostics_.include(of_file);
  }

  void move_diagnostics(Diagnostics& of_file, const Substitution& done, config::SourceLocation to) {
    for (config::Diagnostic& diagnostic : of_file.take_at(done.place)) {
      std::string hint = fmt::format("used as ${} in {}:{}:{}", done.name, file_, done.place.line,
                                     done.place.column);
      if (!diagnostic.hint.empty()) hint.insert(0, diagnostic.hint + "\n    ");
      diagnostics_.add(diagnostic.fault, to, std::move(diagnostic.message), std::move(hint));
    }
  }

  const Node& step_;
  const Node::Entry& use_;
  ReadContext& context_;
  Diagnostics& diagnostics_;
  Variables given_;
  std::string file_;
  TaskFile used_;
};

}  // namespace

Branch read_use(const Node& step, ReadContext& context, Diagnostics& diagnostics) {
  return UseReader(step, context, diagnostics).read();
}

}  // namespace striate::tasks
