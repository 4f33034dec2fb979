#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <string_view>

#include "striate/agent/memory_json.hpp"
#include "striate/agent/open_memory.hpp"
#include "striate/app/commands/memory_command.hpp"
#include "striate/app/memory/memory_diff.hpp"
#include "striate/app/memory/memory_transfer.hpp"
#include "striate/app/memory/text_table.hpp"
#include "striate/base/files.hpp"
#include "striate/base/say.hpp"
#include "striate/base/shell_text.hpp"
#include "striate/base/user_error.hpp"
#include "striate/memory/long_term/damage.hpp"
#include "striate/memory/long_term/memory_writer.hpp"
#include "striate/memory/long_term/merging.hpp"

namespace striate::app {
namespace {

int check(const MemoryCommandOptions& options) {
  std::vector<std::string> damage;
  agent::with_memory(
      options.file, memory::Access::read, "checking it",
      [&](memory::MemoryTables&, memory::MemoryFile& file) {
        damage = memory::find_damage(file.database());
        if (options.json) {
          fmt::print("{}",
                     agent::print_json(
                         {{"file", options.file}, {"good", damage.empty()}, {"damage", damage}}));
          return;
        }
        for (const std::string& line : damage) fmt::print("{}: {}\n", options.file, line);
        if (!damage.empty()) return;
        const auto count = [&](const char* query) {
          return file.database().execAndGet(query).getInt64();
        };
        fmt::print(
            "{}: good: {} landmarks, {} views, {} sessions of which {} crashed, {} episodes\n",
            options.file, count("SELECT count(*) FROM landmark"),
            count("SELECT count(*) FROM landmark_view"), count("SELECT count(*) FROM session"),
            count("SELECT count(*) FROM session WHERE state = 'crashed'"),
            count("SELECT count(*) FROM episode"));
      });
  return damage.empty() ? 0 : 1;
}

void diff(const MemoryCommandOptions& options, const std::string& a, const std::string& b) {
  agent::with_memory(a, memory::Access::read, "comparing it",
                     [&](memory::MemoryTables& in_a, memory::MemoryFile&) {
                       agent::with_memory(
                           b, memory::Access::read, "comparing it",
                           [&](memory::MemoryTables& in_b, memory::MemoryFile&) {
                             const std::vector<Difference> found = differences(in_a, in_b);
                             if (options.json) {
                               nlohmann::ordered_json json = nlohmann::ordered_json::array();
                               for (const Difference& one : found) {
                                 json.push_back({{"name", one.name}, {"what", one.what}});
                               }
                               fmt::print("{}", agent::print_json(json));
                               return;
                             }
                             TextTable table({"landmark", fmt::format("A = {}, B = {}", a, b)});
                             for (const Difference& one : found) table.add({one.name, one.what});
                             fmt::print("{}", table.empty() ? "both know the same\n"
                                                            : table.print(terminal_width()));
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
                  out, shell_word(memory)));
}

void say_what_is_left_out(const std::string& file, const nlohmann::ordered_json& exported) {
  if (const int views = exported.at("damaged_views_left_out"); views > 0) {
    say(stderr, fmt::format("{}: {} damaged views left out\n", file, views));
  }
  if (!exported.contains("rows_left_out")) return;
  std::string text = fmt::format("{}: damaged; left out because it cannot be read:\n", file);
  for (const auto& one : exported.at("rows_left_out")) {
    text += fmt::format("  {}\n", one.get<std::string>());
  }
  say(stderr, text);
}

void export_command(const MemoryCommandOptions& options, const std::string& out) {
  if (out != "-") {
    check_is_no_memory(out, options.file);
    check_writable(out);
  }
  const nlohmann::ordered_json exported = export_readable(options.file);
  say_what_is_left_out(options.file, exported);
  const std::size_t landmarks = exported.at("landmarks").size();
  const std::string text = agent::print_json(exported);
  if (out == "-") {
    fmt::print("{}", text);
    return;
  }
  write_file(out, text);
  if (options.json) {
    fmt::print("{}", agent::print_json({{"file", out}, {"landmarks", landmarks}}));
  } else {
    fmt::print("{}: {} landmarks\n", out, landmarks);
  }
}

/// Merges `other` into the memory, in a session of its own.
void take_in(const MemoryCommandOptions& options, const std::string& from,
             memory::MemoryTables& other) {
  memory::MemoryWriter writer(options.file,
                              agent::memory_options(memory::Access::session, "striate memory"));
  agent::print_notices(writer.notices());
  memory::Merged merged;
  writer.commit([&](memory::MemoryTables& tables) {
    merged = memory::merge(tables, other, options.settings());
    if (merged.nothing_new()) return;
    const memory::Session session =
        tables.sessions.begin(memory::SessionKind::import, agent::software_name(), from,
                              agent::memory_options(memory::Access::session, "").now_unix_s);
    tables.sessions.end(session.id, 0.0, "kept");
  });
  if (options.json) {
    fmt::print("{}", agent::print_json({{"added", merged.added},
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
  agent::with_memory(
      other, memory::Access::read, "merging it",
      [&](memory::MemoryTables& theirs, memory::MemoryFile&) { take_in(options, other, theirs); });
}

void import_command(const MemoryCommandOptions& options, const std::string& from) {
  const std::string text = read_file(from);
  const ScratchFolder scratch;
  const std::string copy = scratch / "import.db";
  agent::with_memory(copy, memory::Access::session, "importing it",
                     [&](memory::MemoryTables& tables, memory::MemoryFile&) {
                       import_memory(text, from, tables);
                     });
  agent::with_memory(
      copy, memory::Access::read, "importing it",
      [&](memory::MemoryTables& theirs, memory::MemoryFile&) { take_in(options, from, theirs); });
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

}  // namespace striate::app
