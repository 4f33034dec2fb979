#include <fmt/format.h>

#include "striate/agent/landmark_list.hpp"
#include "striate/agent/memory_json.hpp"
#include "striate/agent/open_memory.hpp"
#include "striate/agent/pictures/memory_pictures.hpp"
#include "striate/agent/run_result.hpp"
#include "striate/app/commands/memory_command.hpp"
#include "striate/app/memory/text_table.hpp"
#include "striate/app/perceive_files.hpp"
#include "striate/base/files.hpp"
#include "striate/memory/long_term/forgetting.hpp"

namespace striate::app {
namespace {

std::string pose_text(const memory::Landmark& landmark) {
  if (!landmark.position) return "-";
  return fmt::format("{:.2f} m, {:.2f} m", landmark.position->x_m, landmark.position->y_m);
}

std::string state_text(const memory::Landmark& landmark) {
  if (landmark.retired_s) return "forgotten";
  return landmark.pinned ? "pinned" : "kept";
}

std::string ago(const memory::Landmark& landmark, double now_s) {
  const std::vector<double>& recent_s = landmark.history.recent_s;
  return recent_s.empty() ? "never" : memory::print_time_span(now_s - recent_s.front());
}

/// The most active first, as they would be looked for.
void list(const MemoryCommandOptions& options, bool with_retired) {
  agent::with_memory(
      options.file, memory::Access::read, "listing it",
      [&](memory::MemoryTables& tables, memory::MemoryFile&) {
        const std::vector<agent::ListedLandmark> rows =
            agent::list_landmarks(tables, with_retired, options.settings());
        if (options.json) {
          fmt::print("{}", agent::print_json(agent::to_json(rows)));
          return;
        }
        const double now_s = tables.sessions.operating_now_s();
        TextTable table({"name", "kind", ">views", ">keypoints", ">strength", ">activation",
                         ">uses", ">last used", "place", "state"});
        for (const auto& [activation, landmark] : rows) {
          table.add({landmark.name, name_of(landmark.kind), std::to_string(landmark.views),
                     std::to_string(landmark.keypoints), fmt::format("{:.2f}", landmark.strength),
                     fmt::format("{:+.2f}", activation), std::to_string(landmark.history.uses),
                     ago(landmark, now_s), pose_text(landmark), state_text(landmark)});
        }
        fmt::print(
            "{}", table.empty() ? options.file + ": no landmark\n" : table.print(terminal_width()));
      });
}

nlohmann::ordered_json shown_json(const memory::Landmark& landmark,
                                  const std::vector<memory::StoredView>& views) {
  nlohmann::ordered_json json = agent::to_json(landmark);
  json["looks"] = nlohmann::ordered_json::array();
  for (const memory::StoredView& view : views) json["looks"].push_back(agent::to_json(view));
  return json;
}

void print_shown(const memory::Landmark& landmark, const std::vector<memory::StoredView>& views,
                 double now_s) {
  fmt::print("{} ({}, {}{})\n", landmark.name, name_of(landmark.kind), state_text(landmark),
             landmark.retired_why.empty() ? "" : ": " + landmark.retired_why);
  fmt::print("  strength {:.2f}, uses {}, the last {} of work ago, place {}\n", landmark.strength,
             landmark.history.uses, ago(landmark, now_s), pose_text(landmark));
  TextTable table({">view", ">width", ">height", ">keypoints", ">range", ">picture", "state"});
  for (const memory::StoredView& view : views) {
    table.add({std::to_string(view.id), fmt::format("{:.0f} px", view.width_px),
               fmt::format("{:.0f} px", view.height_px), std::to_string(view.keypoints.size()),
               view.range_m ? fmt::format("{:.2f} m", *view.range_m) : "-",
               view.image.empty() ? "-" : fmt::format("{} kB", view.image.size() / 1024 + 1),
               view.damaged ? "damaged: not used" : "good"});
  }
  if (!table.empty()) fmt::print("{}", table.print(terminal_width()));
}

void show(const MemoryCommandOptions& options, const std::string& name, const std::string& image) {
  check_image_writable(image);
  agent::with_memory(options.file, memory::Access::read, "showing it",
                     [&](memory::MemoryTables& tables, memory::MemoryFile&) {
                       const memory::Landmark landmark = memory::find_landmark(tables, name);
                       const std::vector<memory::StoredView> views = tables.views.of(landmark.id);
                       if (!image.empty())
                         write_picture(image, agent::pictures::draw_views(landmark, views));
                       if (options.json) {
                         fmt::print("{}", agent::print_json(shown_json(landmark, views)));
                       } else {
                         print_shown(landmark, views, tables.sessions.operating_now_s());
                       }
                     });
}

void why(const MemoryCommandOptions& options, const std::string& name, const std::string& goal) {
  agent::with_memory(
      options.file, memory::Access::read, "explaining it",
      [&](memory::MemoryTables& tables, memory::MemoryFile&) {
        const memory::LongTermSettings settings = options.settings();
        const memory::Landmark landmark = memory::find_landmark(tables, name);
        memory::Situation situation{tables.sessions.operating_now_s(), 0, {}};
        if (!goal.empty()) situation.goal = memory::find_landmark(tables, goal).id;
        const std::vector<memory::Route> routes = tables.places.routes();
        const std::string keeps = agent::fate_of(landmark, situation.now_s, settings);
        if (options.json) {
          const memory::Activation parts =
              memory::activation_of(landmark, situation, routes, settings);
          fmt::print("{}", agent::print_json({{"name", landmark.name},
                                              {"activation", parts.total()},
                                              {"base", parts.base},
                                              {"goal", parts.goal},
                                              {"route", parts.route},
                                              {"strength", parts.strength},
                                              {"fate", keeps}}));
          return;
        }
        for (const std::string& line : memory::explain(landmark, situation, routes, settings)) {
          fmt::print("{}\n", line);
        }
        fmt::print("  {}.\n", keeps);
      });
}

void add_show_and_why(CLI::App& command, const SharedMemoryOptions& shared, int& exit_code) {
  struct Named {
    std::string name;
    std::string image;
    std::string goal;
  };
  auto shown = std::make_shared<Named>();
  CLI::App* verb = command.add_subcommand("show", "Shows one landmark and its views.");
  verb->add_option("name", shown->name, "the landmark")->type_name("NAME")->required();
  verb->add_option("--picture", shown->image, "writes its views with their keypoints (PNG)");
  verb->callback([shared, shown, &exit_code] {
    show(*shared, shown->name, shown->image);
    exit_code = 0;
  });
  auto explained = std::make_shared<Named>();
  verb = command.add_subcommand(
      "why",
      "Explains in words and numbers how readily a landmark comes to mind, and whether it\n"
      "will be forgotten. Times are of work: a night in the cupboard does not count.");
  verb->add_option("name", explained->name, "the landmark")->type_name("NAME")->required();
  verb->add_option("--goal", explained->goal, "as if the task were after this landmark")
      ->type_name("NAME");
  verb->callback([shared, explained, &exit_code] {
    why(*shared, explained->name, explained->goal);
    exit_code = 0;
  });
}

}  // namespace

void add_memory_look_verbs(CLI::App& command, const SharedMemoryOptions& shared, int& exit_code) {
  auto all = std::make_shared<bool>(false);
  CLI::App* verb = command.add_subcommand("list", "Lists the landmarks, the most active first.");
  verb->add_flag("--all", *all, "forgotten ones too");
  verb->callback([shared, all, &exit_code] {
    list(*shared, *all);
    exit_code = 0;
  });
  add_show_and_why(command, shared, exit_code);
}

}  // namespace striate::app
