#include "striate/app/command_line/completion.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace striate::app {
namespace {

/// What may stand for a value: its words, or a mark that the scripts below know.
std::string values_of(const OptionText& option) {
  if (!option.choices.empty()) return fmt::format("{}", fmt::join(option.choices, " "));
  return option.takes_files() ? "@files" : "@nothing";
}

void add_value_rows(const CommandText& command, const std::vector<OptionText>& options,
                    std::string& rows) {
  for (const OptionText& option : options) {
    if (option.value.empty()) continue;
    for (const std::string& name : option.names) {
      rows +=
          fmt::format("    \"{} {}\") values=\"{}\" ;;\n", command.path, name, values_of(option));
    }
  }
}

std::string names_of(const std::vector<OptionText>& options) {
  std::string names;
  for (const OptionText& option : options) {
    for (const std::string& name : option.names) names += (names.empty() ? "" : " ") + name;
  }
  return names;
}

std::string last_word(const std::string& path) {
  return path.substr(path.find_last_of(' ') + 1);
}

/// What may follow a command, beside options.
std::string arguments_of(const CommandText& command) {
  for (const OptionText& argument : command.arguments) {
    if (values_of(argument) != "@nothing") return values_of(argument);
  }
  return "@nothing";
}

struct Rows {
  std::string values;  ///< a row for each option that takes a value
  std::string places;  ///< a row for each command
};

void add_rows(const CommandText& command, const std::vector<OptionText>& from_above, Rows& rows) {
  std::vector<OptionText> options = command.options;
  for (const OptionText& above : from_above) {
    const auto same = [&above](const OptionText& own) { return own.names == above.names; };
    if (command.passes_on && std::none_of(options.begin(), options.end(), same)) {
      options.push_back(above);
    }
  }
  std::string below;
  for (const CommandText& one : command.commands) {
    below += (below.empty() ? "" : " ") + last_word(one.path);
  }
  add_value_rows(command, options, rows.values);
  rows.places += fmt::format("    \"{}\") commands=\"{}\" options=\"{}\" arguments=\"{}\" ;;\n",
                             command.path, below, names_of(options), arguments_of(command));
  for (const CommandText& one : command.commands) add_rows(one, options, rows);
}

/// Two functions of plain case lists, which both shells read.
std::string tables(const CommandText& striate) {
  Rows rows;
  add_rows(striate, {}, rows);
  return fmt::format(
      "# The values of an option that takes one, at a command.\n"
      "_striate_values() {{\n"
      "  case \"$1 $2\" in\n{}"
      "    *) return 1 ;;\n"
      "  esac\n"
      "}}\n\n"
      "# What may follow a command.\n"
      "_striate_place() {{\n"
      "  case \"$1\" in\n{}"
      "    *) return 1 ;;\n"
      "  esac\n"
      "}}\n\n",
      rows.values, rows.places);
}

// A word after an option that takes a value is that value, also where it reads like a command.
// bash takes "--option=value" for three words.
constexpr const char* kBash = R"(_striate_offer() {
  case "$1" in
    @nothing) ;;
    @files)
      local file
      while IFS= read -r file; do COMPREPLY+=("$file"); done < <(compgen -f -- "$2")
      compopt -o filenames 2> /dev/null
      ;;
    *) COMPREPLY+=($(compgen -W "$1" -- "$2")) ;;
  esac
}

_striate() {
  local current="${COMP_WORDS[COMP_CWORD]}" place=striate value_of="" word
  local values="" commands="" options="" arguments=""
  local -i i=1
  COMPREPLY=()
  [[ $current == "=" ]] && current=""
  while ((i < COMP_CWORD)); do
    word="${COMP_WORDS[i]}"
    i+=1
    if _striate_values "$place" "$word"; then
      if [[ ${COMP_WORDS[i]} == "=" ]] && ((i < COMP_CWORD)); then i+=1; fi
      ((i >= COMP_CWORD)) && value_of="$word"
      i+=1
    elif _striate_place "$place $word"; then
      place="$place $word"
    fi
  done
  if [[ -n $value_of ]]; then
    _striate_values "$place" "$value_of"
    _striate_offer "$values" "$current"
    return
  fi
  _striate_place "$place"
  if [[ $current == -* ]]; then
    _striate_offer "$options" "$current"
  else
    _striate_offer "$commands" "$current"
    _striate_offer "$arguments" "$current"
  fi
}

complete -F _striate striate
)";

constexpr const char* kZsh = R"(_striate_offer() {
  case "$1" in
    @nothing | "") ;;
    @files) _files ;;
    *) compadd -- ${=1} ;;
  esac
}

_striate() {
  local place=striate value_of="" word
  local values="" commands="" options="" arguments=""
  local -i i=2
  while ((i < CURRENT)); do
    word="${words[i]}"
    ((i += 1))
    if _striate_values "$place" "$word"; then
      ((i == CURRENT)) && value_of="$word"
      ((i += 1))
    elif _striate_place "$place $word"; then
      place="$place $word"
    fi
  done
  word="${words[CURRENT]}"
  if [[ -z $value_of && $word == --*=* ]] && compset -P '*='; then
    value_of="${word%%=*}"
  fi
  if [[ -n $value_of ]]; then
    _striate_values "$place" "$value_of" && _striate_offer "$values"
    return
  fi
  _striate_place "$place"
  if [[ $word == -* ]]; then
    _striate_offer "$options"
  else
    _striate_offer "$commands"
    _striate_offer "$arguments"
  fi
}

if [[ ${funcstack[1]} == _striate ]]; then
  _striate "$@"
else
  compdef _striate striate
fi
)";

}  // namespace

std::string bash_completion(const CommandText& striate) {
  return "# bash completion of striate; made by: striate help --completion bash\n\n" +
         tables(striate) + kBash;
}

std::string zsh_completion(const CommandText& striate) {
  return "#compdef striate\n# made by: striate help --completion zsh\n\n" + tables(striate) + kZsh;
}

}  // namespace striate::app
