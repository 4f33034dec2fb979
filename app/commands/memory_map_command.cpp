#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

#include "app/commands/memory_command.hpp"
#include "app/files.hpp"
#include "app/memory/memory_json.hpp"
#include "app/memory/memory_map_svg.hpp"
#include "app/memory/memory_pictures.hpp"
#include "app/memory/open_memory.hpp"
#include "app/memory/text_table.hpp"
#include "app/perceive_files.hpp"
#include "app/run_result.hpp"

namespace striate {
namespace {

void print_map_json(const std::vector<Landmark>& landmarks, const std::vector<Route>& routes,
                    const std::vector<ObstacleCell>& cells) {
  nlohmann::ordered_json json = {{"landmarks", nlohmann::ordered_json::array()},
                                 {"routes", nlohmann::ordered_json::array()},
                                 {"cell_m", kObstacleCell_m},
                                 {"obstacle_cells", nlohmann::ordered_json::array()}};
  for (const Landmark& one : landmarks) {
    if (one.position) json["landmarks"].push_back(to_json(one));
  }
  for (const Route& one : routes) json["routes"].push_back(to_json(one));
  for (const ObstacleCell& one : cells) json["obstacle_cells"].push_back(to_json(one));
  fmt::print("{}", print_json(json));
}

void print_map(const std::vector<Landmark>& landmarks, const std::vector<Route>& routes,
               const std::vector<ObstacleCell>& cells) {
  std::unordered_map<std::int64_t, std::string> names;
  TextTable places({"landmark", ">x", ">y", ">sure to"});
  for (const Landmark& one : landmarks) {
    names[one.id] = one.name;
    if (!one.position || one.retired_s) continue;
    const MapPosition& at = *one.position;
    places.add({one.name, fmt::format("{:.2f} m", at.x_m), fmt::format("{:.2f} m", at.y_m),
                fmt::format("{:.2f} m", std::sqrt(at.var_x_m2 + at.var_y_m2))});
  }
  TextTable ways({"from", "to", ">distance", ">turn", ">driven", ">failed"});
  for (const Route& one : routes) {
    ways.add({names[one.from], names[one.to], fmt::format("{:.2f} m", one.distance_m),
              fmt::format("{:.0f} deg", one.turn_rad * 180.0 / std::numbers::pi),
              std::to_string(one.successes), std::to_string(one.failures)});
  }
  const int width = terminal_width();
  fmt::print("{}", places.empty() ? "no landmark has a position yet\n" : places.print(width));
  if (!ways.empty()) fmt::print("\n{}", ways.print(width));
  if (!cells.empty()) fmt::print("\nobstacle grid: {} cells of 10 cm\n", cells.size());
}

/// PNG or SVG, by the end of the name.
void draw_map(const std::string& file, const std::vector<Landmark>& landmarks,
              const std::vector<Route>& routes, const std::vector<ObstacleCell>& cells) {
  if (file.ends_with(".svg")) {
    write_file(file, pictures::memory_map_svg(landmarks, routes, cells));
  } else {
    write_picture(file, pictures::draw_memory_map(landmarks, routes, cells));
  }
}

void map(const MemoryCommandOptions& options, const std::string& picture) {
  if (picture.ends_with(".svg")) {
    check_writable(picture);
  } else {
    check_picture_writable(picture);
  }
  with_memory(options.file, Access::read, "reading its map",
              [&](MemoryTables& tables, MemoryFile&) {
                const std::vector<Landmark> landmarks = tables.landmarks.all(true);
                const std::vector<Route> routes = tables.places.routes();
                const std::vector<ObstacleCell> cells = tables.places.cells();
                if (!picture.empty()) {
                  draw_map(picture, tables.landmarks.all(false), routes, cells);
                }
                if (options.json) {
                  print_map_json(landmarks, routes, cells);
                } else {
                  print_map(landmarks, routes, cells);
                }
              });
}

void episodes(const MemoryCommandOptions& options, int most) {
  with_memory(options.file, Access::read, "reading it", [&](MemoryTables& tables, MemoryFile&) {
    std::vector<Episode> all = tables.sessions.episodes(most);
    std::reverse(all.begin(), all.end());
    if (options.json) {
      nlohmann::ordered_json json = nlohmann::ordered_json::array();
      for (const Episode& one : all) json.push_back(to_json(one));
      fmt::print("{}", print_json(json));
      return;
    }
    TextTable table({">session", ">time", "what", "landmark", "where", "text"});
    for (const Episode& one : all) {
      table.add({one.session ? std::to_string(*one.session) : "-",
                 fmt::format("{:.1f} s", one.time_s), one.kind, one.landmark,
                 one.x_m ? fmt::format("{:.2f} m, {:.2f} m", *one.x_m, one.y_m.value_or(0.0)) : "",
                 one.text});
    }
    fmt::print("{}",
               table.empty() ? options.file + ": no episode\n" : table.print(terminal_width()));
  });
}

}  // namespace

void add_memory_map_verbs(CLI::App& command, const SharedMemoryOptions& shared, int& exit_code) {
  auto picture = std::make_shared<std::string>();
  CLI::App* verb =
      command.add_subcommand("map", "Lists places and routes; or draws them with the obstacles.");
  verb->add_option("--picture", *picture, "writes the map from above (.png or .svg)");
  verb->callback([shared, picture, &exit_code] {
    map(*shared, *picture);
    exit_code = 0;
  });
  auto most = std::make_shared<int>(50);
  verb = command.add_subcommand("episodes", "Lists what happened, the newest last.");
  verb->add_option("--most", *most, "the newest so many; 0: all")
      ->check(CLI::Range(0, 1000000000))
      ->capture_default_str();
  verb->callback([shared, most, &exit_code] {
    episodes(*shared, *most == 0 ? -1 : *most);
    exit_code = 0;
  });
}

}  // namespace striate
