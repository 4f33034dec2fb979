#include "app/place_text.hpp"

#include <fmt/format.h>

#include "config/quantity.hpp"
#include "config/user_error.hpp"

namespace striate {

Pose2 parse_place(const std::string& text) {
  config::Mistakes mistakes("--at");
  const config::Node list = parse_yaml("[" + text + "]", mistakes);
  const std::size_t count = list.items.size();
  Pose2 place;
  if (mistakes.none() && (count == 2 || count == 3)) {
    // m along the corridor: whatever the world is, a typing error lies outside
    constexpr config::Range kAlong{-1000.0, 100000.0};
    using config::Unit;
    place.x_m = read_quantity(list.items[0], Unit::length, kAlong, mistakes).value_or(0.0);
    place.y_m = read_quantity(list.items[1], Unit::length, {-1000, 1000}, mistakes).value_or(0.0);
    if (count == 3) {
      place.heading_rad =
          read_quantity(list.items[2], Unit::angle, {-7.0, 7.0}, mistakes).value_or(0.0);
    }
    if (mistakes.none()) return place;
  }
  const std::string why = mistakes.none() ? "" : " (" + mistakes.list().front().message + ")";
  throw UserError(fmt::format("--at \"{}\" is no place{}\n    write it like \"12 m, 0.2 m, 5 deg\"",
                              text, why));
}

double parse_time_s(const std::string& option, const std::string& text) {
  config::Mistakes mistakes(option);
  const config::Node node = parse_yaml(text, mistakes);
  if (mistakes.none()) {
    const auto time_s = read_quantity(node, config::Unit::duration, {0.0, 1e6}, mistakes);
    if (time_s && mistakes.none()) return *time_s;
  }
  throw UserError(fmt::format("{} \"{}\" is no time ({})\n    write it like \"12.3 s\"", option,
                              text, mistakes.none() ? "nothing" : mistakes.list().front().message));
}

}  // namespace striate
