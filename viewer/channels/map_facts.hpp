#pragma once

#include "striate/viewer/channels/shown_facts.hpp"

/// Maps and routes of memory as facts.
namespace striate::viewer {

void take_local(const memory::LocalGrid& grid, FloorGrid& floor);

void take_global(const memory::Localisation& place, FloorGrid& floor);

void take_routes(const memory::Localisation& place, SlowFacts& slow);

void take_map(const memory::Localisation& place, CycleFacts& facts);

}  // namespace striate::viewer
