#include "striate/app/command_line/command_walk.hpp"

#include <algorithm>
#include <map>

namespace striate::app {
namespace {

/// The option of that name here, or above where the command passes on what it does not know.
const CLI::Option* find_option(const CLI::App& app, const std::string& name) {
  for (const CLI::Option* option : app.get_options()) {
    if (option->nonpositional() && option->check_name(name)) return option;
  }
  const bool passes_on = app.get_fallthrough() && app.get_parent() != nullptr;
  return passes_on ? find_option(*app.get_parent(), name) : nullptr;
}

bool looks_like_option(const std::string& word) {
  return word.size() > 1 && word[0] == '-';
}

/// How many words an option takes at least and at most.
struct Takes {
  int least = 0;
  int most = 0;
};

Takes taken_by(const CLI::Option& option) {
  const int most = option.get_items_expected_max();
  const bool repeated = most >= CLI::detail::expected_max_vector_size / 16;
  if (repeated && !option.get_allow_extra_args()) return {1, 1};
  return {std::min(option.get_type_size_min(), option.get_items_expected_min()), most};
}

class Walker {
 public:
  Walker(const CLI::App& app, const std::vector<std::string>& words)
      : words_(words), result_{&app, {}} {}

  CommandWalk walk() {
    bool only_arguments = false;
    while (at_ < words_.size()) {
      const std::string& word = words_[at_];
      if (!only_arguments && word == "--") {
        only_arguments = true;
        ++at_;
      } else if (!only_arguments && looks_like_option(word)) {
        take_option();
      } else {
        take_word(only_arguments);
      }
    }
    return std::move(result_);
  }

 private:
  void take_option() {
    const std::string& word = words_[at_];
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals);
    const CLI::Option* option = find_option(*result_.end, name);
    if (option == nullptr) strange(StrangeWord::Kind::option, name);
    ++at_;
    if (option == nullptr || equals != std::string::npos) return;
    const Takes takes = taken_by(*option);
    for (int i = 0; i < takes.most && at_ < words_.size(); ++i, ++at_) {
      const std::string& next = words_[at_];
      const bool ends = looks_like_option(next) || command_below(*result_.end, next) != nullptr;
      if (i >= takes.least && ends) return;
    }
  }

  void take_word(bool only_arguments) {
    const std::string& word = words_[at_];
    const CLI::App* below = only_arguments ? nullptr : command_below(*result_.end, word);
    if (below != nullptr) {
      result_.end = below;
    } else if (!take_argument()) {
      const bool could_be_command = !commands_below(*result_.end).empty();
      strange(could_be_command ? StrangeWord::Kind::command : StrangeWord::Kind::argument, word);
    }
    ++at_;
  }

  bool take_argument() {
    for (const CLI::Option* option : result_.end->get_options()) {
      if (!option->get_positional()) continue;
      if (taken_[option] >= option->get_items_expected_max()) continue;
      ++taken_[option];
      return true;
    }
    return false;
  }

  void strange(StrangeWord::Kind kind, const std::string& word) {
    result_.strange.push_back({kind, at_, word, result_.end});
  }

  const std::vector<std::string>& words_;
  std::size_t at_ = 0;
  CommandWalk result_;
  std::map<const CLI::Option*, int> taken_;  ///< words that the arguments have already
};

}  // namespace

CommandWalk walk_command_line(const CLI::App& app, const std::vector<std::string>& words) {
  return Walker(app, words).walk();
}

std::string path_of(const CLI::App& command) {
  const CLI::App* above = command.get_parent();
  return above == nullptr ? command.get_name() : path_of(*above) + " " + command.get_name();
}

const CLI::App* command_below(const CLI::App& app, const std::string& name) {
  for (const CLI::App* command : commands_below(app)) {
    if (command->check_name(name)) return command;
  }
  return nullptr;
}

std::vector<const CLI::App*> commands_below(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    if (!option->nonpositional() || option->get_group().empty()) continue;
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  if (!app.get_fallthrough() || app.get_parent() == nullptr) return names;
  for (std::string& name : option_names(*app.get_parent())) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

}  // namespace striate::app
