#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <string_view>

#include "app/commands/memory_command.hpp"
#include "app/memory/memory_diff.hpp"
#include "app/memory/memory_json.hpp"
#include "app/memory/open_memory.hpp"
#include "app/memory/text_table.hpp"
#include "base/files.hpp"
#include "base/user_error.hpp"
#include "memory/long_term/damage.hpp"
#include "memory/long_term/memory_writer.hpp"
#include "memory/long_term/merging.hpp"

namespace striate {
namespace {

int check(const MemoryCommandOptions& options) {
  std::vector<std::string> damage;
  with_memory(options.file, Access::read, "checking it", [&](MemoryTables&, MemoryFile& file) {
    damage = find_damage(file.database());
    if (options.json) {
      fmt::print(
          "{}", print_json({{"file", options.file}, {"good", damage.empty()}, {"damage", damage}}));
      return;
    }
    for (const std::string& line : damage) fmt::print("{}: {}\n", options.file, line);
    if (!damage.empty()) return;
    const auto count = [&](const char* query) {
      return file.database().execAndGet(query).getInt64();
    };
    fmt::print("{}: good: {} landmarks, {} views, {} sessions of which {} crashed, {} episodes\n",
               options.file, count("SELECT count(*) FROM landmark"),
               count("SELECT count(*) FROM landmark_view"), count("SELECT count(*) FROM session"),
               count("SELECT count(*) FROM session WHERE state = 'crashed'"),
               count("SELECT count(*) FROM episode"));
  });
  return damage.empty() ? 0 : 1;
}

void diff(const MemoryCommandOptions& options, const std::string& a, const std::string& b) {
  with_memory(a, Access::read, "comparing it", [&](MemoryTables& in_a, MemoryFile&) {
    with_memory(b, Access::read, "comparing it", [&](MemoryTables& in_b, MemoryFile&) {
      const std::vector<Difference> found = differences(in_a, in_b);
      if (options.json) {
        nlohmann::ordered_json json = nlohmann::ordered_json::array();
        for (const Difference& one : found) {
          json.push_back({{"name", one.name}, {"what", one.what}});
        }
        fmt::print("{}", print_json(json));
        return;
      }
      TextTable table({"landmark", fmt::format("A = {}, B = {}", a, b)});
      for (const Difference& one : found) table.add({one.name, one.what});
      fmt::print("{}", table.empty() ? "both know the same\n" : table.print(terminal_width()));
    });
  });
}

/// An export must not take the place of a memory: not of this one, and of no other.
void check_is_no_memory(const std::string& out, const std::string& memory) {
  std::error_code none;
  std::array<char, 16> begin{};
  std::ifstream stream(out, std::ios::binary);
  stream.read(begin.data(), begin.size());
  const bool is_database = std::string_view(begin.data(), begin.size()) ==
                           std::string_view("SQLite format 3\0", begin.size());
  if (!is_database && !std::filesystem::equivalent(out, memory, none)) return;
  throw UserError(
      fmt::format("{}: is a memory or another database; it is not written over\n    "
                  "give another file, e.g. striate memory {} export home.json",
                  out, memory));
}

void export_command(const MemoryCommandOptions& options, const std::string& out) {
  if (out != "-") {
    check_is_no_memory(out, options.file);
    check_writable(out);
  }
  std::string text;
  std::size_t landmarks = 0;
  with_memory(options.file, Access::read, "exporting it", [&](MemoryTables& tables, MemoryFile&) {
    const nlohmann::ordered_json json = export_memory(tables);
    landmarks = json.at("landmarks").size();
    const int damaged = json.at("damaged_views_left_out");
    if (damaged > 0) fmt::print(stderr, "{}: {} damaged views left out\n", options.file, damaged);
    text = print_json(json);
  });
  if (out == "-") {
    fmt::print("{}", text);
    return;
  }
  write_file(out, text);
  if (options.json) {
    fmt::print("{}", print_json({{"file", out}, {"landmarks", landmarks}}));
  } else {
    fmt::print("{}: {} landmarks\n", out, landmarks);
  }
}

/// Merges `other` into the memory, in a session of its own.
void take_in(const MemoryCommandOptions& options, const std::string& from, MemoryTables& other) {
  MemoryWriter writer(options.file, memory_options(Access::session, "striate memory"));
  print_notices(writer.notices());
  Merged merged;
  writer.commit([&](MemoryTables& tables) {
    merged = merge(tables, other, options.settings());
    if (merged.nothing_new()) return;
    const Session session = tables.sessions.begin(SessionKind::import, software_name(), from,
                                                  memory_options(Access::session, "").now_unix_s);
    tables.sessions.end(session.id, 0.0, "kept");
  });
  if (options.json) {
    fmt::print("{}", print_json({{"added", merged.added},
                                 {"joined", merged.joined},
                                 {"views", merged.views},
                                 {"damaged_views_left_out", merged.damaged},
                                 {"remarks", merged.remarks}}));
    return;
  }
  fmt::print("{}: {} landmarks added, {} joined with known ones, {} views came in{}\n",
             options.file, merged.added, merged.joined, merged.views,
             merged.damaged > 0 ? fmt::format(", {} damaged left out", merged.damaged) : "");
  for (const std::string& remark : merged.remarks) fmt::print("  {}\n", remark);
}

void merge_command(const MemoryCommandOptions& options, const std::string& other) {
  std::error_code none;
  if (std::filesystem::equivalent(options.file, other, none)) {
    throw UserError(fmt::format("{}: cannot be merged with itself", other));
  }
  with_memory(other, Access::read, "merging it",
              [&](MemoryTables& theirs, MemoryFile&) { take_in(options, other, theirs); });
}

void import_command(const MemoryCommandOptions& options, const std::string& from) {
  const std::string text = read_file(from);
  const ScratchFolder scratch;
  const std::string copy = scratch / "import.db";
  with_memory(copy, Access::session, "importing it",
              [&](MemoryTables& tables, MemoryFile&) { import_memory(text, from, tables); });
  with_memory(copy, Access::read, "importing it",
              [&](MemoryTables& theirs, MemoryFile&) { take_in(options, from, theirs); });
}

void add_check_and_diff(CLI::App& command, const SharedMemoryOptions& shared, int& exit_code) {
  CLI::App* verb = command.add_subcommand(
      "check",
      "Looks at every page, reference and checksum, and names what is damaged.\n"
      "Exit code 1 if something is.");
  verb->callback([shared, &exit_code] { exit_code = check(*shared); });
  auto files = std::make_shared<std::pair<std::string, std::string>>();
  verb = command.add_subcommand("diff", "What two memories know that is not the same.");
  verb->add_option("a", files->first, "one memory")->required();
  verb->add_option("b", files->second, "the other")->required();
  verb->callback([shared, files, &exit_code] {
    diff(*shared, files->first, files->second);
    exit_code = 0;
  });
}

}  // namespace

void add_memory_file_verbs(CLI::App& command, const SharedMemoryOptions& shared, int& exit_code) {
  add_check_and_diff(command, shared, exit_code);
  auto out = std::make_shared<std::string>();
  CLI::App* verb = command.add_subcommand("export", "Writes all that is remembered as JSON.");
  verb->add_option("out", *out, "the file to write; -: standard output")->required();
  verb->callback([shared, out, &exit_code] {
    export_command(*shared, *out);
    exit_code = 0;
  });
  auto in = std::make_shared<std::string>();
  verb = command.add_subcommand("import", "Takes in what 'export' wrote, as 'merge' does.");
  verb->add_option("in", *in, "the file to read")->required();
  verb->callback([shared, in, &exit_code] {
    import_command(*shared, *in);
    exit_code = 0;
  });
  auto other = std::make_shared<std::string>();
  verb = command.add_subcommand(
      "merge",
      "Takes in another robot's memory: landmarks of the same name, or that look the\n"
      "same, become one with the views of both. The other file is not changed.");
  verb->add_option("other", *other, "the other memory")->required();
  verb->callback([shared, other, &exit_code] {
    merge_command(*shared, *other);
    exit_code = 0;
  });
}

}  // namespace striate
