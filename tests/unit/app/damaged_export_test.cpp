#include <SQLiteCpp/Transaction.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "striate/agent/open_memory.hpp"
#include "striate/app/memory/memory_transfer.hpp"
#include "striate/base/user_error.hpp"
#include "striate/memory/long_term/memory_file.hpp"
#include "striate/memory/long_term/view_codec.hpp"
#include "tests/reference/temporary_folder.hpp"

/// A memory of which a page cannot be read: all the rest is exported.
namespace striate::app {
namespace {

constexpr int kLandmarks = 40;
constexpr int kViews = 3;
constexpr int kEpisodes = 1200;
constexpr int kCells = 40;  // each way
constexpr std::size_t kPage_bytes = 32768;

memory::StoredView view_of(std::int64_t landmark, std::int64_t session, unsigned seed) {
  memory::StoredView view;
  view.landmark = landmark;
  view.session = session;
  view.width_px = view.height_px = 200.0;
  for (unsigned k = 0; k < 60; ++k) {
    view.keypoints.push_back({static_cast<float>(k), static_cast<float>(seed % 100), 8.0F, 0.0F});
    memory::StoredDescriptor descriptor{};
    descriptor.fill(static_cast<std::uint8_t>(seed + k));
    view.descriptors.push_back(descriptor);
  }
  view.image.assign(3000, static_cast<std::uint8_t>(seed));
  return view;
}

void fill(memory::MemoryTables& tables) {
  for (int i = 0; i < kLandmarks; ++i) {
    const memory::Session session =
        tables.sessions.begin(memory::SessionKind::teach, "test", std::to_string(i), 1700000000);
    memory::Landmark landmark;
    landmark.session = session.id;
    landmark.name = "thing_" + std::to_string(i);
    landmark.history = {1, 0.0, {0.0}};
    const std::int64_t id = tables.landmarks.add(landmark);
    for (int v = 0; v < kViews; ++v) {
      tables.views.add(view_of(id, session.id, static_cast<unsigned>(10 * i + v)));
    }
    tables.sessions.end(session.id, 1.0, "kept");
    if (i > 0) tables.places.put(memory::Route{id - 1, id, 2.0, 0.1, 0.1, 0.1, 1, 0});
  }
  for (int i = 0; i < kEpisodes; ++i) {
    memory::Episode episode;
    episode.session = 1 + i % kLandmarks;
    episode.time_s = i;
    episode.kind = "note";
    episode.text = "the " + std::to_string(i) + "th thing that happened, told at some length";
    tables.sessions.add(episode);
  }
  for (int row = 0; row < kCells; ++row) {
    for (int column = 0; column < kCells; ++column) {
      tables.places.put(memory::ObstacleCell{column, row, 1.0, 2.0});
    }
  }
}

/// The rows of a table that SQLite reads when asked for each by itself.
std::size_t readable(const std::string& file, const std::string& table, const std::string& keys,
                     const std::vector<std::pair<int, int>>& all) {
  SQLite::Database database(file);
  SQLite::Statement row(database, "SELECT * FROM " + table + " WHERE " + keys);
  std::size_t count = 0;
  for (const auto& [first, second] : all) {
    row.tryReset();
    row.bind(1, first);
    if (row.getBindParameterCount() > 1) row.bind(2, second);
    try {
      count += row.executeStep() ? 1 : 0;
    } catch (const SQLite::Exception&) {
    }
  }
  return count;
}

std::vector<std::pair<int, int>> ids(int count) {
  std::vector<std::pair<int, int>> keys;
  for (int i = 1; i <= count; ++i) keys.emplace_back(i, 0);
  return keys;
}

std::vector<std::pair<int, int>> cells() {
  std::vector<std::pair<int, int>> keys;
  for (int row = 0; row < kCells; ++row) {
    for (int column = 0; column < kCells; ++column) keys.emplace_back(row, column);
  }
  return keys;
}

class DamagedExport : public testing::Test {
 protected:
  DamagedExport() {
    memory::MemoryFile file(whole_, agent::memory_options(memory::Access::session, "test"));
    memory::MemoryTables tables(file.database());
    SQLite::Transaction transaction(file.database());
    fill(tables);
    transaction.commit();
    file.copy_to(copied_);
  }
  /// A copy in which some pages, counted from 1, hold zeros.
  void zero(const std::vector<std::size_t>& pages) {
    std::filesystem::copy_file(copied_, damaged_,
                               std::filesystem::copy_options::overwrite_existing);
    std::fstream stream(damaged_, std::ios::in | std::ios::out | std::ios::binary);
    const std::string zeros(kPage_bytes, '\0');
    for (const std::size_t page : pages) {
      stream.seekp(static_cast<std::streamoff>((page - 1) * kPage_bytes));
      stream << zeros;
    }
  }
  /// Every row that can be read is in the export, which can be imported again.
  void expect_what_is_readable() {
    const auto json = export_readable(damaged_);
    std::size_t views = 0;
    std::size_t stand_ins = 0;
    for (const auto& landmark : json.at("landmarks")) {
      views += landmark.at("looks").size();
      stand_ins += landmark.at("name").get<std::string>().starts_with("lost_landmark_") ? 1 : 0;
    }
    EXPECT_EQ(json.at("episodes").size(), readable(damaged_, "episode", "id = ?", ids(kEpisodes)));
    EXPECT_EQ(json.at("landmarks").size() - stand_ins,
              readable(damaged_, "landmark", "id = ?", ids(kLandmarks)));
    EXPECT_EQ(views + json.at("damaged_views_left_out").get<std::size_t>(),
              readable(damaged_, "landmark_view", "id = ?", ids(kLandmarks * kViews)));
    EXPECT_EQ(json.at("obstacle_cells").size(),
              readable(damaged_, "obstacle_cell", "cell_row = ? AND cell_column = ?", cells()));
    const reference::TemporaryFolder folder;
    EXPECT_NO_THROW(agent::with_memory(folder / "new.db", memory::Access::session, "importing it",
                                       [&](memory::MemoryTables& tables, memory::MemoryFile&) {
                                         import_memory(json.dump(), "saved.json", tables);
                                       }));
  }
  [[nodiscard]] std::size_t pages() const {
    return std::filesystem::file_size(copied_) / kPage_bytes;
  }

  reference::TemporaryFolder folder_;
  std::string whole_ = folder_ / "whole.db";
  std::string copied_ = folder_ / "copied.db";
  std::string damaged_ = folder_ / "damaged.db";
};

TEST_F(DamagedExport, GivesEveryReadableRowWhateverPageIsZero) {
  ASSERT_GT(pages(), 25U);
  int with_losses = 0;
  for (std::size_t page = 2; page <= pages(); page += 3) {
    SCOPED_TRACE(page);
    zero({page});
    expect_what_is_readable();
    with_losses += export_readable(damaged_).contains("rows_left_out") ? 1 : 0;
  }
  EXPECT_GT(with_losses, 4);
}

TEST_F(DamagedExport, GivesWhatIsReadableBetweenTwoZeroPages) {
  for (std::size_t page = 2; page + 3 <= pages(); page += 7) {
    SCOPED_TRACE(page);
    zero({page, page + 2});
    expect_what_is_readable();
  }
}

TEST_F(DamagedExport, OfAWholeMemoryLeavesNothingOut) {
  const auto json = export_readable(copied_);
  EXPECT_FALSE(json.contains("rows_left_out"));
  EXPECT_EQ(json.at("landmarks").size(), std::size_t{kLandmarks});
  EXPECT_EQ(json.at("episodes").size(), std::size_t{kEpisodes});
}

TEST_F(DamagedExport, OfAFileThatWasCutOffGivesItsBeginning) {
  std::filesystem::copy_file(copied_, damaged_, std::filesystem::copy_options::overwrite_existing);
  std::filesystem::resize_file(damaged_, pages() / 2 * kPage_bytes + 1000);
  const auto json = export_readable(damaged_);
  EXPECT_GT(json.at("landmarks").size(), 0U);
  EXPECT_TRUE(json.contains("rows_left_out"));
  EXPECT_LT(std::filesystem::file_size(damaged_), pages() * kPage_bytes) << "it is not touched";
}

}  // namespace
}  // namespace striate::app
