#include <fmt/format.h>
#include <sqlite3.h>

#include "striate/agent/memory_json.hpp"
#include "striate/agent/open_memory.hpp"
#include "striate/app/commands/memory_command.hpp"
#include "striate/app/memory/text_table.hpp"
#include "striate/base/say.hpp"
#include "striate/base/user_error.hpp"
#include "striate/memory/long_term/forgetting.hpp"
#include "striate/memory/long_term/memory_errors.hpp"

namespace striate::app {
namespace {

void print_done(const MemoryCommandOptions& options, const std::string& name, const char* what) {
  if (options.json) {
    fmt::print("{}", agent::print_json({{"name", name}, {"done", what}}));
  } else {
    fmt::print("{}: {}\n", name, what);
  }
}

void print_plan(const MemoryCommandOptions& options, const memory::PrunePlan& plan, bool done) {
  if (options.json) {
    nlohmann::ordered_json json = {{"done", done},
                                   {"retire", nlohmann::ordered_json::array()},
                                   {"remove", nlohmann::ordered_json::array()},
                                   {"episodes", plan.episodes}};
    for (const memory::Landmark& one : plan.retire) json["retire"].push_back(agent::to_json(one));
    for (const memory::Landmark& one : plan.remove) json["remove"].push_back(agent::to_json(one));
    fmt::print("{}", agent::print_json(json));
    return;
  }
  if (plan.empty()) {
    fmt::print("nothing to prune\n");
    return;
  }
  TextTable table({"landmark", "what", "why"});
  for (const memory::Landmark& one : plan.retire) {
    table.add({one.name, "forget (can be restored)", one.retired_why});
  }
  for (const memory::Landmark& one : plan.remove) {
    table.add({one.name, "remove for good", "forgotten long ago: " + one.retired_why});
  }
  if (!table.empty()) fmt::print("{}", table.print(terminal_width()));
  if (plan.episodes > 0) fmt::print("{} old episodes: remove\n", plan.episodes);
  fmt::print("{}", done ? "done\n" : "nothing was changed: --yes does it\n");
}

/// What pruning gave back reaches the disk only when the file is written anew. That it cannot be is
/// no reason to say that nothing was pruned.
void give_room_back(const std::string& path) {
  const auto later = [&](const std::string& why) {
    say(stderr, fmt::format("{}: {}: its room is given back by the next prune --yes\n", path, why));
  };
  try {
    memory::MemoryFile file(path, agent::memory_options(memory::Access::edit, "striate memory"));
    file.database().exec("VACUUM");
  } catch (const SQLite::Exception& error) {
    const int code = error.getErrorCode() & memory::kPrimaryCode;
    later(code == SQLITE_BUSY || code == SQLITE_LOCKED ? "in use" : error.what());
  } catch (const UserError& error) {
    later(error.what());
  }
}

void prune_command(const MemoryCommandOptions& options, bool yes) {
  memory::PrunePlan plan;
  agent::with_memory(options.file, yes ? memory::Access::edit : memory::Access::read, "pruning it",
                     [&](memory::MemoryTables& tables, memory::MemoryFile&) {
                       const memory::LongTermSettings settings = options.settings();
                       plan = memory::plan_prune(tables, settings);
                       if (yes) memory::prune(tables, plan, settings);
                     });
  print_plan(options, plan, yes);  // "done" only once it is on the disk
  if (yes) give_room_back(options.file);
}

}  // namespace

namespace {

void add_rename(CLI::App& command, const SharedMemoryOptions& shared, int& exit_code) {
  struct Given {
    std::string name, to;
  };
  auto given = std::make_shared<Given>();
  CLI::App* verb =
      command.add_subcommand("rename",
                             "Gives a landmark another name; all that is known of it stays.\n"
                             "Example: striate memory home.db rename book \"red book\"");
  verb->add_option("name", given->name, "the landmark")->type_name("NAME")->required();
  verb->add_option("to", given->to, "its name from now on")->type_name("NAME")->required();
  verb->callback([shared, given, &exit_code] {
    agent::with_memory(shared->file, memory::Access::edit, "renaming it",
                       [&](memory::MemoryTables& tables, memory::MemoryFile&) {
                         memory::rename(tables, given->name, given->to);
                       });
    print_done(*shared, given->to, "renamed");
    exit_code = 0;
  });
}

}  // namespace

void add_memory_change_verbs(CLI::App& command, const SharedMemoryOptions& shared, int& exit_code) {
  add_rename(command, shared, exit_code);
  struct Given {
    std::string name;
    bool yes = false;
  };
  auto forgotten = std::make_shared<Given>();
  CLI::App* verb = command.add_subcommand(
      "forget", "Forgets a landmark: it is no longer looked for. 'restore' brings it back.");
  verb->add_option("name", forgotten->name, "the landmark")->type_name("NAME")->required();
  verb->callback([shared, forgotten, &exit_code] {
    agent::with_memory(shared->file, memory::Access::edit, "forgetting it",
                       [&](memory::MemoryTables& tables, memory::MemoryFile&) {
                         memory::forget(tables, forgotten->name, "a person asked for it");
                       });
    print_done(*shared, forgotten->name, "forgotten");
    exit_code = 0;
  });
  auto restored = std::make_shared<Given>();
  verb = command.add_subcommand("restore", "Brings a forgotten landmark back, and pins it.");
  verb->add_option("name", restored->name, "the landmark")->type_name("NAME")->required();
  verb->callback([shared, restored, &exit_code] {
    agent::with_memory(shared->file, memory::Access::edit, "restoring it",
                       [&](memory::MemoryTables& tables, memory::MemoryFile&) {
                         memory::restore(tables, restored->name);
                       });
    print_done(*shared, restored->name, "restored");
    exit_code = 0;
  });
  auto pruned = std::make_shared<Given>();
  verb = command.add_subcommand(
      "prune",
      "Shows what may go: weak and inactive landmarks that nobody taught are forgotten,\n"
      "those forgotten for 50 hours of work are removed for good, old episodes too.");
  verb->add_flag("--yes", pruned->yes, "does it");
  verb->callback([shared, pruned, &exit_code] {
    prune_command(*shared, pruned->yes);
    exit_code = 0;
  });
}

}  // namespace striate::app
