#include "striate/app/memory/memory_transfer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "striate/agent/open_memory.hpp"
#include "striate/agent/pictures/memory_pictures.hpp"
#include "striate/base/user_error.hpp"
#include "tests/reference/exported_memory.hpp"
#include "tests/reference/temporary_folder.hpp"

namespace striate::app {
namespace {

using nlohmann::ordered_json;
using testing::HasSubstr;

/// Why a text is not taken in; "" where it is.
std::string refused_import(const std::string& text) {
  const reference::TemporaryFolder folder;
  try {
    agent::with_memory(folder / "m.db", memory::Access::session, "importing it",
                       [&](memory::MemoryTables& tables, memory::MemoryFile&) {
                         import_memory(text, "home.json", tables);
                       });
  } catch (const UserError& error) {
    return error.what();
  }
  return {};
}

TEST(MemoryTransfer, TakesInAnExportAndGivesItOutAgain) {
  const reference::TemporaryFolder folder;
  ordered_json again;
  agent::with_memory(folder / "m.db", memory::Access::session, "importing it",
                     [&](memory::MemoryTables& tables, memory::MemoryFile&) {
                       import_memory(reference::exported_memory(), "home.json", tables);
                       again = export_memory(tables);
                     });
  const ordered_json given = ordered_json::parse(reference::exported_memory());
  EXPECT_EQ(again["landmarks"][0]["position"], given["landmarks"][0]["position"]);
  EXPECT_EQ(again["landmarks"][0]["uses"], 3);
  EXPECT_EQ(again["routes"][0], given["routes"][0]);
  EXPECT_EQ(again["obstacle_cells"], given["obstacle_cells"]);
}

/// Each number of the export, one by one: a value that its place cannot have is refused with the
/// name of that place, and none is undefined on the way.
TEST(MemoryTransfer, RefusesEveryNumberThatCannotBe) {
  const ordered_json good = ordered_json::parse(reference::exported_memory());
  const std::vector<ordered_json> odd = {1e300, 18446744073709551615ULL,
                                         std::numeric_limits<std::int64_t>::min(), "text"};
  int numbers = 0;
  const ordered_json flat = good.flatten();
  for (const auto& [pointer, value] : flat.items()) {
    // The database gives ids of its own to looks and episodes.
    const bool own_id = pointer.ends_with("/id") && (pointer.find("/looks") != std::string::npos ||
                                                     pointer.find("/episodes") == 0);
    if (!value.is_number() || own_id || pointer == "/damaged_views_left_out") continue;
    ++numbers;
    for (const ordered_json& one : odd) {
      ordered_json changed = good;
      changed[ordered_json::json_pointer(pointer)] = one;
      EXPECT_THAT(refused_import(changed.dump()), HasSubstr("home.json: no export of a memory"))
          << pointer << " = " << one;
    }
  }
  EXPECT_GT(numbers, 45);
  EXPECT_EQ(refused_import(good.dump()), "");
}

TEST(MemoryTransfer, SaysWhichNumberItIs) {
  ordered_json changed = ordered_json::parse(reference::exported_memory());
  changed["obstacle_cells"][1]["column"] = 3'000'000'000LL;
  EXPECT_THAT(refused_import(changed.dump()), HasSubstr("'column' is 3e+09"));
  changed["obstacle_cells"][1]["column"] = 1.5;
  EXPECT_THAT(refused_import(changed.dump()), HasSubstr("'column' is 1.5, which is no whole"));
}

TEST(MemoryTransfer, AFileOfNothingButBracketsIsRefusedWithoutTakingMemory) {
  EXPECT_THAT(refused_import(std::string(4'000'000, '[')), HasSubstr("nested deeper"));
}

TEST(MemoryTransfer, KeypointsOfNoImageAreRefused) {
  std::string text = reference::exported_memory();
  const std::size_t at = text.find("\"keypoint_bytes\": \"") + 19;
  text.replace(at, 22, "////////////////////fw");  // numbers that are none
  EXPECT_THAT(refused_import(text), HasSubstr("keypoint"));
}

/// A memory's file may have been written by others as well.
TEST(MemoryPictures, AMapOfPlacesFarOutIsDrawnWithinItsFrame) {
  memory::Landmark far;
  far.name = "far";
  far.position = memory::MapPosition{1e300, -1e300, 1e300, 0.0, 1e300};
  memory::Landmark here;
  here.name = "here";
  here.position = memory::MapPosition{};
  const cv::Mat3b map = agent::pictures::draw_memory_map(
      {far, here}, {{1, 2}}, {{2'147'483'647, -2'147'483'647, 1.0, 0.0}});
  EXPECT_LT(map.cols, 1100);
  EXPECT_LT(map.rows, 1100);
  memory::StoredView view;
  view.width_px = 1e300;
  view.height_px = std::nan("");
  view.keypoints.resize(3);
  view.keypoints[0].x_px = 1e30F;
  view.keypoints[1].size_px = std::nanf("");
  EXPECT_FALSE(agent::pictures::draw_views(here, {view}).empty());
}

}  // namespace
}  // namespace striate::app
