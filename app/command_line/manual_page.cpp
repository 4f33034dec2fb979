#include "striate/app/command_line/manual_page.hpp"

#include <fmt/format.h>

#include <sstream>

namespace striate::app {
namespace {

/// Text for roff: a hyphen that can be copied as one, and no line that is taken for a request.
std::string roff(const std::string& text) {
  std::string out;
  bool line_begins = true;
  for (const char c : text) {
    if (line_begins && (c == '.' || c == '\'')) out += "\\&";
    line_begins = c == '\n';
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else {
      out += c;
    }
  }
  return out;
}

/// One filled paragraph; roff takes a line that begins with a space for the end of one.
std::string paragraph(const std::string& text) {
  std::istringstream lines(text);
  std::string out;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t begin = line.find_first_not_of(' ');
    if (begin != std::string::npos) out += roff(line.substr(begin)) + "\n";
  }
  return out;
}

/// Lines as they are.
std::string verbatim(const std::vector<std::string>& lines) {
  std::string out = ".PP\n.nf\n";
  for (const std::string& line : lines) out += roff(line) + "\n";
  return out + ".fi\n";
}

std::string heading_of(const OptionText& option) {
  std::string names;
  for (const std::string& name : option.names) {
    names += fmt::format("{}\\fB{}\\fR", names.empty() ? "" : ", ", roff(name));
  }
  if (option.value.empty() || option.names.front()[0] != '-') return names;
  if (option.choices.empty()) return fmt::format("{} \\fI{}\\fR", names, roff(option.value));
  return fmt::format("{} {}", names, roff(fmt::format("{}", fmt::join(option.choices, "|"))));
}

std::string remarks_of(const OptionText& option) {
  std::string remarks;
  const auto add = [&remarks](const std::string& remark) {
    remarks += (remarks.empty() ? "" : "; ") + remark;
  };
  if (option.required) add("must be given");
  if (!option.range.empty()) add(option.range);
  if (!option.default_value.empty()) add("default " + option.default_value);
  if (option.repeated) add("may be given several times");
  if (!option.needs.empty()) add(fmt::format("only with {}", fmt::join(option.needs, ", ")));
  return remarks.empty() ? "" : "(" + remarks + ")\n";
}

std::string entry(const OptionText& option) {
  return ".TP\n" + heading_of(option) + "\n" + paragraph(option.help) +
         paragraph(remarks_of(option));
}

std::string synopsis(const CommandText& command) {
  std::string line = fmt::format("\\fB{}\\fR", roff(command.path));
  if (!command.options.empty()) line += " [\\fIOPTIONS\\fR]";
  for (const OptionText& argument : command.arguments) {
    const std::string name =
        fmt::format("\\fI{}\\fR{}", roff(argument.names.front()), argument.repeated ? "..." : "");
    line += argument.required ? " " + name : " [" + name + "]";
  }
  if (!command.commands.empty()) line += " \\fICOMMAND\\fR";
  return line + "\n";
}

void add_command(const CommandText& command, std::string& page) {
  page += fmt::format(".SS {}\n", roff(command.path)) + synopsis(command) + ".PP\n" +
          paragraph(command.about);
  for (const OptionText& argument : command.arguments) page += entry(argument);
  for (const OptionText& option : command.options) page += entry(option);
  if (!command.examples.empty()) page += verbatim(command.examples);
  for (const CommandText& below : command.commands) add_command(below, page);
}

constexpr const char* kEnd = R"(.SH EXIT STATUS
.TP
.B 0
success
.TP
.B 1
the mission failed, or something broke while the command was at work
.TP
.B 2
a mistake in what was given: an unknown option, a broken file, an output that cannot be written
.TP
.B 130
interrupted with Ctrl\-C
.SH ENVIRONMENT
.TP
.B COLUMNS
width of tables; without it that of the terminal
.TP
.B XDG_CONFIG_HOME
the folder in which
.I striate
holds your own tasks, worlds and robots; without it
.I ~/.config
.TP
.B ROS_MASTER_URI
the ROS 1 master of
.B striate ros
.SH FILES
.TP
.IR tasks/*.yaml ,
.IR worlds/*.yaml ,
.I robots/*.yaml
task scripts, worlds of the simulator, and settings of a robot and its mind: first of
.I config
beside the program or
.I ../share/striate/config
of its folder, then of
.IR ~/.config/striate .
Each is found there by its name alone:
.BR "striate config \-\-paths" .
.TP
.I home.db
the long\-term memory, where
.B \-\-memory
has this default: an SQLite database
)";

constexpr const char* kNotes =
    ".SH NOTES\nOptions with a bare number carry its unit in their name "
    "(\\fB\\-\\-tilt\\-deg\\fR,\n"
    "\\fB\\-\\-way\\-m\\fR); where the value is text it carries its own unit (\"12 m\").\n";

}  // namespace

std::string manual_page(const CommandText& striate, const std::string& software) {
  std::string page = fmt::format(
      ".\\\" made by: striate help --man\n"
      ".TH STRIATE 1 \"\" \"{}\" \"User Commands\"\n"
      ".SH NAME\nstriate \\- a cognitive robot that sees with a model of the visual cortex\n"
      ".SH SYNOPSIS\n",
      roff(software));
  for (const CommandText& command : striate.commands) page += synopsis(command) + ".br\n";
  page += ".SH DESCRIPTION\n" + paragraph(striate.about);
  page += ".SH OPTIONS\n";
  for (const OptionText& option : striate.options) page += entry(option);
  page += ".SH COMMANDS\n";
  for (const CommandText& command : striate.commands) add_command(command, page);
  page += kEnd;
  page += kNotes;
  page += ".SH EXAMPLES\n" + verbatim(striate.examples);
  return page;
}

}  // namespace striate::app
