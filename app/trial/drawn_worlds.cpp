#include "striate/app/trial/drawn_worlds.hpp"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <utility>

#include "striate/base/files.hpp"
#include "striate/base/user_error.hpp"
#include "striate/platform/simulator/random_world/random_world.hpp"

namespace striate::app {
namespace {

/// More is a typing error: at a minute each a trial of a week.
constexpr std::uint64_t kMostWorlds = 10000;

/// "1..200"; "7" is one seed.
std::pair<std::uint64_t, std::uint64_t> seeds_of(const std::string& text) {
  const std::size_t dots = text.find("..");
  const std::string first = text.substr(0, dots);
  const std::string last = dots == std::string::npos ? first : text.substr(dots + 2);
  const auto read = [](const std::string& digits, std::uint64_t& seed) {
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), seed);
    return error == std::errc{} && end == digits.data() + digits.size();
  };
  std::uint64_t from = 0, to = 0;
  if (!read(first, from) || !read(last, to) || from > to || to - from >= kMostWorlds) {
    throw UserError(fmt::format(
        "'--random-worlds {}' names no seeds\n    write the first and the last one, 1..200, at "
        "most {} of them",
        text, kMostWorlds));
  }
  return {from, to};
}

}  // namespace

simulator::BuildingKind building_kind_named(const std::string& kind, std::uint64_t seed) {
  const std::vector<std::string>& kinds = simulator::building_kinds();
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (kinds[i] == kind) return static_cast<simulator::BuildingKind>(i);
  }
  return simulator::kind_of_seed(seed);
}

void draw_trial_worlds(const DrawnWorldsOptions& drawn, TrialOptions& options) {
  const auto [from, to] = seeds_of(drawn.seeds);
  if (options.out.empty()) return;  // told with the other things that a trial needs
  const std::string folder = options.out + "/worlds";
  make_folder(folder, "--out");
  for (std::uint64_t i = 0; i <= to - from; ++i) {
    const std::uint64_t seed = from + i;
    const simulator::RandomWorld world =
        simulator::draw_random_world(building_kind_named(drawn.kind, seed), seed);
    const std::string file = fmt::format("{}/{}.yaml", folder, world.world.name);
    if (!std::filesystem::exists(file)) {
      write_file(file, world.yaml);
    } else if (read_file(file) != world.yaml) {
      throw UserError(
          fmt::format("{}: is not the building that is drawn from this seed now\n    another "
                      "version of Striate drew it: give another --out folder, or remove this one",
                      file));
    }
    options.worlds.push_back(file);
    options.world_seeds.push_back(seed);
  }
}

}  // namespace striate::app
