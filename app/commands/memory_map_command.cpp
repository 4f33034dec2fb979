#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

#include "striate/agent/map_server_files.hpp"
#include "striate/agent/memory_json.hpp"
#include "striate/agent/open_memory.hpp"
#include "striate/agent/pictures/memory_map_svg.hpp"
#include "striate/agent/pictures/memory_pictures.hpp"
#include "striate/agent/run_result.hpp"
#include "striate/app/commands/memory_command.hpp"
#include "striate/app/memory/text_table.hpp"
#include "striate/app/perceive_files.hpp"
#include "striate/base/files.hpp"
#include "striate/base/user_error.hpp"

namespace striate::app {
namespace {

void print_map_json(const std::vector<memory::Landmark>& landmarks,
                    const std::vector<memory::Route>& routes,
                    const std::vector<memory::ObstacleCell>& cells) {
  nlohmann::ordered_json json = {{"landmarks", nlohmann::ordered_json::array()},
                                 {"routes", nlohmann::ordered_json::array()},
                                 {"cell_m", memory::kObstacleCell_m},
                                 {"obstacle_cells", nlohmann::ordered_json::array()}};
  for (const memory::Landmark& one : landmarks) {
    if (one.position) json["landmarks"].push_back(agent::to_json(one));
  }
  for (const memory::Route& one : routes) json["routes"].push_back(agent::to_json(one));
  for (const memory::ObstacleCell& one : cells)
    json["obstacle_cells"].push_back(agent::to_json(one));
  fmt::print("{}", agent::print_json(json));
}

void print_map(const std::vector<memory::Landmark>& landmarks,
               const std::vector<memory::Route>& routes,
               const std::vector<memory::ObstacleCell>& cells) {
  std::unordered_map<std::int64_t, std::string> names;
  TextTable places({"landmark", ">x", ">y", ">sure to"});
  for (const memory::Landmark& one : landmarks) {
    names[one.id] = one.name;
    if (!one.position || one.retired_s) continue;
    const memory::MapPosition& at = *one.position;
    places.add({one.name, fmt::format("{:.2f} m", at.x_m), fmt::format("{:.2f} m", at.y_m),
                fmt::format("{:.2f} m", std::sqrt(at.var_x_m2 + at.var_y_m2))});
  }
  TextTable ways({"from", "to", ">distance", ">turn", ">driven", ">failed"});
  for (const memory::Route& one : routes) {
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
void draw_map(const std::string& file, const std::vector<memory::Landmark>& landmarks,
              const std::vector<memory::Route>& routes,
              const std::vector<memory::ObstacleCell>& cells) {
  if (file.ends_with(".svg")) {
    write_file(file, agent::pictures::memory_map_svg(landmarks, routes, cells));
  } else {
    write_picture(file, agent::pictures::draw_memory_map(landmarks, routes, cells));
  }
}

/// FILE.yaml, and the picture beside it.
void write_map_server(const std::string& file, const std::vector<memory::ObstacleCell>& cells) {
  const std::filesystem::path picture = std::filesystem::path(file).replace_extension(".pgm");
  const agent::MapServerFiles files = agent::map_server_files(cells, picture.filename().string());
  write_file(picture, files.pgm);
  write_file(file, files.yaml);
}

void check_map_server(const std::string& file) {
  if (file.empty()) return;
  if (!file.ends_with(".yaml")) {
    throw UserError(
        fmt::format("--map-server {}: must end in .yaml; the picture beside it is "
                    "named after it, with .pgm",
                    file));
  }
  check_writable(file);
  check_writable(std::filesystem::path(file).replace_extension(".pgm").string());
}

void map(const MemoryCommandOptions& options, const std::string& image,
         const std::string& map_server) {
  if (image.ends_with(".svg")) {
    check_writable(image);
  } else {
    check_image_writable(image);
  }
  check_map_server(map_server);
  agent::with_memory(options.file, memory::Access::read, "reading its map",
                     [&](memory::MemoryTables& tables, memory::MemoryFile&) {
                       const std::vector<memory::Landmark> landmarks = tables.landmarks.all(true);
                       const std::vector<memory::Route> routes = tables.places.routes();
                       const std::vector<memory::ObstacleCell> cells = tables.places.cells();
                       if (!image.empty()) {
                         draw_map(image, tables.landmarks.all(false), routes, cells);
                       }
                       if (!map_server.empty()) write_map_server(map_server, cells);
                       if (options.json) {
                         print_map_json(landmarks, routes, cells);
                       } else {
                         print_map(landmarks, routes, cells);
                       }
                     });
}

void episodes(const MemoryCommandOptions& options, int most) {
  agent::with_memory(
      options.file, memory::Access::read, "reading it",
      [&](memory::MemoryTables& tables, memory::MemoryFile&) {
        std::vector<memory::Episode> all = tables.sessions.episodes(most);
        std::reverse(all.begin(), all.end());
        if (options.json) {
          nlohmann::ordered_json json = nlohmann::ordered_json::array();
          for (const memory::Episode& one : all) json.push_back(agent::to_json(one));
          fmt::print("{}", agent::print_json(json));
          return;
        }
        TextTable table({">session", ">time", "what", "landmark", "where", "text"});
        for (const memory::Episode& one : all) {
          table.add(
              {one.session ? std::to_string(*one.session) : "-",
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
  auto image = std::make_shared<std::string>();
  CLI::App* verb =
      command.add_subcommand("map", "Lists places and routes; or draws them with the obstacles.");
  verb->add_option("--picture", *image, "writes the map from above (.png or .svg)");
  auto map_server = std::make_shared<std::string>();
  verb->add_option("--map-server", *map_server,
                   "writes its obstacles as ROS's map_server and Nav2 read them: FILE.yaml, and "
                   "FILE.pgm beside it")
      ->type_name("FILE.yaml");
  verb->callback([shared, image, map_server, &exit_code] {
    map(*shared, *image, *map_server);
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

}  // namespace striate::app
