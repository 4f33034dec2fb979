#include "striate/platform/simulator/random_world/random_world.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "striate/config/diagnostics.hpp"
#include "striate/platform/simulator/random_world/draft.hpp"
#include "striate/platform/simulator/random_world/draw_difficulties.hpp"
#include "striate/platform/simulator/world_reader.hpp"
#include "striate/platform/simulator/world_writer.hpp"

namespace striate::simulator {
namespace {

/// Of 1500 buildings the unluckiest took a handful of proposals; this is never reached.
constexpr int kMostProposals = 100;
/// The way is compared with a millimetre to spare: widths are whole millimetres and more, so that
/// no rounding of a machine decides.
constexpr double kSpare_m = 0.001;
constexpr int kBeforeFirst_cm = 250;      ///< the robot starts at 1 m and looks before it drives
constexpr int kBehindLast_cm = 350;       ///< the goal is 2 m before the end wall
constexpr std::uint64_t kShapeTopic = 2;  ///< width, height, order of the stretches
constexpr std::uint64_t kProposalTopic = 16;  ///< times the proposal's number

using LayStretch = void (*)(Draft&);

/// nullptr: no stretch of its own.
LayStretch layer_of(Difficulty difficulty) {
  switch (difficulty) {
    case Difficulty::low_thing:
      return lay_low_thing;
    case Difficulty::overhang:
      return lay_overhang;
    case Difficulty::pinch:
      return lay_pinch;
    case Difficulty::dark:
      return lay_dark;
    case Difficulty::bend:
      return lay_bend;
    case Difficulty::pocket:
      return lay_pocket;
    case Difficulty::thin_pole:
      return lay_thin_poles;
    case Difficulty::sunlight:
      return lay_sunlight;
    case Difficulty::late_thing:
      return lay_late_thing;
    case Difficulty::ring:
      return lay_ring;
    case Difficulty::side_branch:
      return lay_side_branch;
    case Difficulty::glass:
      return lay_glass;
    case Difficulty::stairs:
      return lay_stairs;
    case Difficulty::wet_floor:
      return lay_wet_floor;
    case Difficulty::crowd:
      break;
  }
  return nullptr;
}

/// The stretches of the building in their order; each is laid by one function.
std::vector<LayStretch> draw_order(const BuildingStyle& style,
                                   const std::vector<Difficulty>& difficulties, Dice& dice) {
  std::vector<LayStretch> order;
  for (const Difficulty difficulty : difficulties) {
    if (const LayStretch lay = layer_of(difficulty)) order.push_back(lay);
  }
  // A second bend makes a corridor of three legs: a U's half, or an S.
  const bool bends =
      std::find(difficulties.begin(), difficulties.end(), Difficulty::bend) != difficulties.end();
  if (bends && dice.chance(40)) order.push_back(lay_bend);
  for (int i = dice.throw_between(style.plain_stretches); i > 0; --i) {
    order.push_back(lay_furniture);
  }
  dice.shuffle(order);
  return order;
}

struct Proposal {
  Draft draft;
  std::string crowd;
};

Proposal propose(BuildingKind kind, std::uint64_t seed, const std::vector<Difficulty>& difficulties,
                 int number) {
  const BuildingStyle& style = style_of(kind);
  Dice shape(seed, kind, kShapeTopic);
  Proposal proposal{
      Draft(style, Dice(seed, kind, kProposalTopic * static_cast<std::uint64_t>(number))), ""};
  Draft& draft = proposal.draft;
  draft.width_cm = shape.throw_in_steps(style.width_cm, 10);
  draft.world.name = random_world_name(kind, seed);
  draft.world.file = draft.world.name + ".yaml";
  draft.world.width_m = metres_of(draft.width_cm);
  draft.world.height_m = metres_of(shape.throw_in_steps(style.height_cm, 5));
  draft.world.eyes = draw_eyes(kind, seed);
  draft.x_cm = kBeforeFirst_cm;
  for (const LayStretch lay : draw_order(style, difficulties, shape)) lay(draft);
  draft.x_cm += kBehindLast_cm;
  draft.world.length_m = metres_of(draft.x_cm);
  draft.world.goal_beyond_m = metres_of(draft.x_cm - 200);
  hang_lamps(draft);
  furnish_walls(draft);
  const bool crowd =
      std::find(difficulties.begin(), difficulties.end(), Difficulty::crowd) != difficulties.end();
  proposal.crowd = send_people(draft, crowd);
  return proposal;
}

WorldNotes notes_of(const RandomWorld& drawn, const std::string& crowd) {
  std::string kind = building_kinds()[static_cast<std::size_t>(drawn.kind)];
  WorldNotes notes;
  notes.head = fmt::format(
      "Drawn by 'striate world --random --kind {} --seed {}', which writes the same again.\n"
      "Along the corridor:",
      kind, drawn.seed);
  for (const DrawnStretch& stretch : drawn.stretches) {
    notes.head +=
        fmt::format("\n  {:5.1f} m to {:5.1f} m: {}", stretch.from_m, stretch.to_m, stretch.story);
  }
  if (!crowd.empty()) notes.head += "\n  everywhere: " + crowd;
  const std::vector<DrawnStretch>& stretches = drawn.stretches;
  notes.obstacle = [&stretches](std::size_t i) {
    for (const DrawnStretch& stretch : stretches) {
      if (stretch.first_obstacle == i && stretch.end_obstacle > i) return stretch.story;
    }
    return std::string();
  };
  return notes;
}

/// Reads the proposal back, as everybody will. False where the reader or the plan refuses it.
bool take(RandomWorld& drawn, const Proposal& proposal) {
  drawn.stretches = proposal.draft.stretches;
  drawn.yaml = world_as_yaml(proposal.draft.world, notes_of(drawn, proposal.crowd));
  config::Diagnostics diagnostics(proposal.draft.world.file);
  drawn.world = parse_world(drawn.yaml, diagnostics);
  if (!diagnostics.none()) return false;
  drawn.passage = widest_passage(drawn.world, build_floor_plan(drawn.world));
  return drawn.passage.width_m >= kDrivable_m + kSpare_m;
}

}  // namespace

std::string random_world_name(BuildingKind kind, std::uint64_t seed) {
  return fmt::format("{}_{:04d}", building_kinds()[static_cast<std::size_t>(kind)], seed);
}

std::optional<DrawnFrom> drawn_from(const std::string& name) {
  const std::size_t digits = name.rfind('_') + 1;  // 0 where there is none
  const std::string kind = name.substr(0, digits == 0 ? 0 : digits - 1);
  for (std::size_t i = 0; i < building_kinds().size(); ++i) {
    if (building_kinds()[i] != kind) continue;
    DrawnFrom from{static_cast<BuildingKind>(i), 0};
    const char* end = name.data() + name.size();
    const auto read = std::from_chars(name.data() + digits, end, from.seed);
    // As it is written, and not otherwise: office_7 is somebody's own.
    if (read.ec != std::errc{} || read.ptr != end) return std::nullopt;
    if (name != random_world_name(from.kind, from.seed)) return std::nullopt;
    return from;
  }
  return std::nullopt;
}

RandomWorld draw_random_world(BuildingKind kind, std::uint64_t seed) {
  RandomWorld drawn;
  drawn.kind = kind;
  drawn.seed = seed;
  drawn.difficulties = draw_difficulties(kind, seed);
  for (int number = 1; number <= kMostProposals; ++number) {
    drawn.proposals = number;
    if (take(drawn, propose(kind, seed, drawn.difficulties, number))) return drawn;
  }
  throw std::runtime_error(fmt::format("{}: none of {} proposals can be driven through",
                                       random_world_name(kind, seed), kMostProposals));
}

}  // namespace striate::simulator
