#include "striate/app/recall/print_memory_state.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "striate/app/memory/text_table.hpp"
#include "striate/base/geometry.hpp"

namespace striate::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kRingLabel = 8;  // letters before a ring's line

std::string angle(const Json& rad) {
  return fmt::format("{:+.0f} deg", degrees(rad.get<double>()));
}

std::string metres(const Json& value) {
  return value.is_null() ? "-" : fmt::format("{:.2f} m", value.get<double>());
}

std::string seconds(const Json& value) {
  return value.is_null() ? "-" : fmt::format("{:.1f} s", value.get<double>());
}

std::string head(const Json& s) {
  const Json& pose = s.at("pose");
  const Json& image = s.at("picture");
  const Json& corridor = s.at("corridor");
  std::string text = fmt::format("cycle {}, {:.1f} s, {}: {}\n", s.at("cycle").get<std::uint64_t>(),
                                 s.at("time_s").get<double>(), s.at("action").get<std::string>(),
                                 s.at("why").get<std::string>());
  text += fmt::format("  place     {}, {}, heading {}; {:.2f} m/s, {}/s; head {}, {}\n",
                      metres(pose.at("x_m")), metres(pose.at("y_m")), angle(pose.at("heading_rad")),
                      pose.at("forward_m_s").get<double>(), angle(pose.at("turn_rad_s")),
                      angle(pose.at("pan_rad")), angle(pose.at("tilt_rad")));
  text += fmt::format("  image   {} old, light {:.2f}, noise {:.1f}, {:.0f} % of it known\n",
                      seconds(image.at("age_s")), image.at("light_level").get<double>(),
                      image.at("noise_level").get<double>(),
                      100.0 * image.at("seen_share").get<double>());
  text += fmt::format("  corridor  axis at {}, width {}{}, walls {} left, {} right; {} along\n",
                      angle(corridor.at("axis_rad")), metres(corridor.at("width_m")),
                      corridor.at("width_known").get<bool>() ? "" : " (assumed)",
                      metres(corridor.at("left_wall_m")), metres(corridor.at("right_wall_m")),
                      metres(corridor.at("progress_m")));
  text += fmt::format("  limited   {}\n", s.at("limited_by").get<std::string>());
  return text;
}

/// Neighbouring sectors share a letter where the line is short; what stands goes before all.
std::string folded(const std::string& sectors, std::size_t together) {
  // Rising: of letters that are folded the later one wins
  static constexpr std::string_view kOrder = " .o#";
  std::string text;
  for (std::size_t at = 0; at < sectors.size(); at += together) {
    std::size_t most = 0;
    for (std::size_t k = at; k < std::min(at + together, sectors.size()); ++k) {
      const std::size_t rank = kOrder.find(sectors[k]);
      if (rank != std::string_view::npos) most = std::max(most, rank);
    }
    text += kOrder[most];
  }
  return text;
}

/// The far rings above, so that up is away from the robot; ahead is in the middle.
std::string map(const Json& rings, int width) {
  std::size_t together = 1;
  while (72 / static_cast<int>(together) + kRingLabel > width && together < 12) ++together;
  const std::size_t quarter = 18 / together;
  std::string text = "\npolar map: # stands, o moves, . free\n";
  for (std::size_t k = rings.size(); k-- > 0;) {
    const std::string row = folded(rings[k].at("sectors").get<std::string>(), together);
    text += fmt::format("{:>5.2f} m {}", rings[k].at("to_m").get<double>(), row);
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  }
  return text + std::string(kRingLabel, ' ') +
         fmt::format("{0:<{1}}{2:<{1}}{3:<{1}}{4}\n", "back", quarter, "left", "ahead", "right");
}

std::string table(const std::string& title, const TextTable& rows, int width) {
  return rows.empty() ? fmt::format("\nno {}\n", title)
                      : fmt::format("\n{}\n{}", title, rows.print(width));
}

TextTable regions(const Json& list) {
  TextTable rows({">region", ">bearing", ">distance", ">size", ">salience", ">hits", ">activation",
                  ">seen ago", "attention"});
  for (const Json& one : list) {
    rows.add({std::to_string(one.at("id").get<int>()), angle(one.at("bearing_rad")),
              metres(one.at("distance_m")), angle(one.at("size_rad")).substr(1),
              fmt::format("{:.2f}", one.at("salience").get<double>()),
              std::to_string(one.at("hits").get<int>()),
              fmt::format("{:.2f}", one.at("activation").get<double>()),
              seconds(one.at("seen_s_ago")), one.at("inhibited").get<bool>() ? "inhibited" : ""});
  }
  return rows;
}

TextTable landmarks(const Json& list) {
  TextTable rows(
      {"landmark", ">bearing", ">distance", ">sure to", ">seen", ">seen ago", ">score", "state"});
  for (const Json& one : list) {
    rows.add({one.at("name").get<std::string>(), angle(one.at("bearing_rad")),
              metres(one.at("distance_m")), metres(one.at("sigma_m")),
              std::to_string(one.at("sightings").get<int>()), seconds(one.at("seen_s_ago")),
              fmt::format("{:.2f}", one.at("score").get<double>()),
              one.at("confirmed").get<bool>()       ? "confirmed"
              : one.at("sightings").get<int>() == 0 ? "recalled"
                                                    : "seen"});
  }
  return rows;
}

TextTable commands(const Json& list) {
  TextTable rows({">time", ">forward", ">turn", ">pan", ">tilt", "action"});
  for (const Json& one : list) {
    rows.add({seconds(one.at("time_s")),
              fmt::format("{:.2f} m/s", one.at("forward_m_s").get<double>()),
              angle(one.at("turn_rad_s")) + "/s", angle(one.at("pan_rad")),
              angle(one.at("tilt_rad")), one.at("action").get<std::string>()});
  }
  return rows;
}

}  // namespace

std::string print_memory_state(const nlohmann::ordered_json& state, int width) {
  return head(state) + map(state.at("polar_map"), width) +
         table("salient regions", regions(state.at("salient_regions")), width) +
         table("landmarks in mind", landmarks(state.at("landmarks")), width) +
         table("last commands", commands(state.at("commands")), width);
}

}  // namespace striate::app
