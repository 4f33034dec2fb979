#pragma once

#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <string>

#include "striate/app/recognised_picture.hpp"
#include "striate/perception/percept.hpp"

/// A recognised thing in words and as JSON.
namespace striate::app {

/// How far a thing is, from the disparities within its middle half.
void add_range(const perception::DisparityMap& map, cv::Size picture, PlacedThing& placed);

/// One line for a person.
[[nodiscard]] std::string thing_text(const PlacedThing& placed);

[[nodiscard]] nlohmann::ordered_json thing_json(const PlacedThing& placed);

}  // namespace striate::app
