#include <filesystem>

#include "striate/agent/landmark_knowledge.hpp"
#include "striate/agent/open_memory.hpp"
#include "striate/agent/pictures/memory_pictures.hpp"
#include "striate/app/memory/memory_transfer.hpp"
#include "striate/base/files.hpp"
#include "striate/base/user_error.hpp"
#include "striate/memory/long_term/activation.hpp"
#include "striate/memory/long_term/merging.hpp"
#include "tests/fuzz/fuzz_target.hpp"
#include "tests/fuzz/odd_numbers.hpp"
#include "tests/reference/exported_memory.hpp"

using namespace striate;
using nlohmann::ordered_json;

namespace {

/// A good export of which the input changes numbers.
std::string changed_export(fuzz::OddNumbers odd) {
  ordered_json json = ordered_json::parse(reference::exported_memory());
  std::vector<std::string> places;
  const ordered_json flat = json.flatten();
  for (const auto& [place, value] : flat.items()) {
    if (value.is_number()) places.push_back(place);
  }
  while (odd.next()) {
    ordered_json& number = json[ordered_json::json_pointer(places[odd.which(places.size())])];
    const double changed = odd.changed(number.get<double>());
    if (odd.raw() % 3 == 0) {
      number = static_cast<std::int64_t>(odd.raw());
    } else if (odd.raw() % 3 == 1) {
      number = odd.raw();
    } else {
      number = changed;
    }
  }
  return json.dump();
}

/// All that a program does with a memory.
void use(memory::MemoryTables& tables) {
  (void)app::export_memory(tables);
  const std::vector<memory::Landmark> landmarks = tables.landmarks.all(true);
  const std::vector<memory::Route> routes = tables.places.routes();
  for (const memory::Landmark& landmark : landmarks) {
    memory::Situation situation;
    situation.now_s = 100.0;
    (void)memory::explain(landmark, situation, routes, {});
    (void)agent::pictures::draw_views(landmark, tables.views.of(landmark.id));
  }
  try {
    (void)agent::pictures::draw_memory_map(landmarks, routes, tables.places.cells());
  } catch (const UserError&) {  // an empty map
  }
}

}  // namespace

/// JSON as it is, or a good one in which the input changes numbers.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const ScratchFolder folder;
  const bool is_json = size > 0 && data[0] == '{';
  const std::string text =
      is_json ? std::string(data, data + size) : changed_export(fuzz::OddNumbers(data, size));
  const std::string theirs = folder / "theirs.db";
  const std::string ours = folder / "ours.db";
  for (const std::string& file : {theirs, ours}) std::filesystem::remove(file);
  try {
    agent::with_memory(theirs, memory::Access::session, "importing it",
                       [&](memory::MemoryTables& tables, memory::MemoryFile&) {
                         app::import_memory(text, "fuzz.json", tables);
                         use(tables);
                       });
    agent::with_memory(ours, memory::Access::session, "merging it",
                       [&](memory::MemoryTables& tables, memory::MemoryFile&) {
                         agent::with_memory(theirs, memory::Access::read, "merging it",
                                            [&](memory::MemoryTables& other, memory::MemoryFile&) {
                                              (void)memory::merge(tables, other, {});
                                              (void)memory::merge(tables, other, {});
                                            });
                       });
    (void)agent::read_mission_knowledge(ours);
  } catch (const UserError&) {
  }
  return 0;
}

std::vector<std::string> striate::fuzz::seeds() {
  std::vector<std::string> seeds = fuzz::lists_of_changes();
  for (int k = 0; k < 50; ++k) seeds.push_back(reference::exported_memory());
  return seeds;
}
