#include "striate/app/pose_text.hpp"

#include <fmt/format.h>

#include "striate/base/user_error.hpp"
#include "striate/config/quantity.hpp"
#include "striate/config/yaml.hpp"

namespace striate::app {

Pose2 parse_pose(const std::string& text) {
  config::Diagnostics diagnostics("--at");
  const config::Node list = parse_yaml("[" + text + "]", diagnostics);
  const std::size_t count = list.items.size();
  Pose2 place;
  if (diagnostics.none() && (count == 2 || count == 3)) {
    // m along the corridor: whatever the world is, a typing error lies outside
    constexpr config::Range kAlong{-1000.0, 100000.0};
    using config::Unit;
    place.x_m = read_quantity(list.items[0], Unit::length, kAlong, diagnostics).value_or(0.0);
    place.y_m =
        read_quantity(list.items[1], Unit::length, {-1000, 1000}, diagnostics).value_or(0.0);
    if (count == 3) {
      place.heading_rad =
          read_quantity(list.items[2], Unit::angle, {-7.0, 7.0}, diagnostics).value_or(0.0);
    }
    if (diagnostics.none()) return place;
  }
  const std::string why = diagnostics.none() ? "" : " (" + diagnostics.list().front().message + ")";
  throw UserError(fmt::format("--at \"{}\" is no place{}\n    write it like \"12 m, 0.2 m, 5 deg\"",
                              text, why));
}

double parse_time_s(const std::string& option, const std::string& text) {
  config::Diagnostics diagnostics(option);
  const config::Node node = parse_yaml(text, diagnostics);
  if (diagnostics.none()) {
    const auto time_s = read_quantity(node, config::Unit::duration, {0.0, 1e6}, diagnostics);
    if (time_s && diagnostics.none()) return *time_s;
  }
  throw UserError(fmt::format("{} \"{}\" is no time ({})\n    write it like \"12.3 s\"", option,
                              text,
                              diagnostics.none() ? "nothing" : diagnostics.list().front().message));
}

}  // namespace striate::app
