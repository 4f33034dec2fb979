#include "striate/memory/long_term/salvage.hpp"

#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <string_view>

#include "striate/memory/long_term/row_copier.hpp"

namespace striate::memory {
namespace {

constexpr std::int64_t kFar = std::numeric_limits<std::int64_t>::max();
/// By hand. So many numbers in a row that cannot be read: what follows is taken for lost. A page
/// has room for some 500 of the smallest rows.
constexpr std::int64_t kGivesUpAfter = 100'000;
/// By hand. So far beyond the keys that were seen, cells between unreadable pages are looked for:
/// 10 m of the map.
constexpr std::int64_t kBeyondSeen = 100;
/// By hand: some seconds.
constexpr std::int64_t kMostKeysTried = 2'000'000;

/// A table whose rows have an id. @return what is left out; empty: nothing
std::string copy_by_id(SQLite::Database& damaged, SQLite::Database& fresh,
                       const std::string& table) {
  RowCopier rows(damaged, fresh, table, {"id"});
  std::int64_t lost = 0;
  std::int64_t in_a_row = 0;
  RowKey at;  // ids begin at 1
  while (true) {
    RowKey next = at;
    const RowFound found = rows.next(next);
    if (found == RowFound::none) break;
    if (found == RowFound::unreadable) {
      // The next row lies on a page that cannot be read, or one before it does: ids are given
      // without gaps, so the next number is asked for by itself.
      ++at.first;
      if (rows.copy(at) == RowFound::row) {
        lost += in_a_row;
        in_a_row = 0;
      } else if (++in_a_row == kGivesUpAfter) {
        return fmt::format("{}: {}all rows after number {}", table,
                           lost == 0 ? "" : fmt::format("up to {} rows, and ", lost),
                           at.first - in_a_row);
      }
      continue;
    }
    lost += in_a_row;
    in_a_row = 0;
    if (rows.copy(next) != RowFound::row) ++lost;
    at = next;
  }
  lost += in_a_row;
  return lost == 0 ? "" : fmt::format("{}: up to {} rows", table, lost);
}

/// The keys that were seen, as a box.
struct Box {
  std::int64_t low = kFar;
  std::int64_t high = -kFar;
  void take(std::int64_t value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

/// Between two readable ends: every key that could be there, one by one.
void copy_between(RowCopier& rows, RowKey low, RowKey high, const Box& first, const Box& second) {
  if (first.low > first.high) return;  // nothing of the table could be read
  std::int64_t tried = 0;
  const std::int64_t from = std::max(low.first, first.low - kBeyondSeen);
  const std::int64_t to = std::min(high.first, first.high + kBeyondSeen);
  for (std::int64_t a = from; a <= to; ++a) {
    for (std::int64_t b = second.low - kBeyondSeen; b <= second.high + kBeyondSeen; ++b) {
      const RowKey key{a, b};
      if (key <= low || key >= high) continue;
      if (++tried > kMostKeysTried) return;
      (void)rows.copy(key);
    }
  }
}

/// A table whose rows have two keys.
std::string copy_by_two(SQLite::Database& damaged, SQLite::Database& fresh,
                        const std::string& table, const std::vector<std::string>& keys) {
  RowCopier rows(damaged, fresh, table, keys);
  Box first;
  Box second;
  bool lost = false;
  const auto walk = [&](RowKey& at, bool up, const std::optional<RowKey>& until) {
    while (true) {
      RowKey key = at;
      const RowFound found = up ? rows.next(key) : rows.previous(key);
      if (found != RowFound::row || (until && key <= *until)) return found;
      lost = rows.copy(key) != RowFound::row || lost;
      first.take(key.first);
      second.take(key.second);
      at = key;
    }
  };
  RowKey low{-kFar, -kFar};
  if (walk(low, true, std::nullopt) == RowFound::unreadable) {
    RowKey high{kFar, kFar};
    lost = true;
    if (walk(high, false, low) == RowFound::unreadable)
      copy_between(rows, low, high, first, second);
  }
  return lost ? fmt::format("{}: rows that cannot be counted, {} are there", table, rows.copied())
              : "";
}

/// Stand-ins for what rows refer to and is lost. @return how many routes led to a lost landmark
std::int64_t mend_references(SQLite::Database& fresh) {
  fresh.exec(
      "INSERT INTO session (id, kind, state, started_unix_s, operating_start_s, software, "
      "settings, outcome) "
      "SELECT DISTINCT s, 'import', 'crashed', 0, 0, '', '', 'lost' FROM (SELECT session AS s FROM "
      "landmark UNION SELECT session FROM landmark_view UNION SELECT session FROM episode) "
      "WHERE s IS NOT NULL AND s NOT IN (SELECT id FROM session)");
  fresh.exec(
      "INSERT OR IGNORE INTO landmark (id, session, name, kind, strength, uses, first_use_s, "
      "recent_uses_s) "
      "SELECT landmark, min(session), 'lost_landmark_' || landmark, 'taught', 0.5, 0, 0, '[]' FROM "
      "landmark_view WHERE landmark NOT IN (SELECT id FROM landmark) GROUP BY landmark");
  fresh.exec("DELETE FROM landmark_view WHERE landmark NOT IN (SELECT id FROM landmark)");
  return fresh.exec(
      "DELETE FROM route WHERE from_landmark NOT IN (SELECT id FROM landmark) OR to_landmark NOT "
      "IN (SELECT id FROM landmark)");
}

}  // namespace

bool fill_up(const std::string& file, const std::string& copy) {
  // "Database File Format", 1.3: page size at byte 16 (1 stands for 65536), pages at byte 28, both
  // with the highest byte first.
  std::array<unsigned char, 32> header{};
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(reinterpret_cast<char*>(header.data()), header.size())) return false;
  if (std::string_view(reinterpret_cast<const char*>(header.data()), 16) !=
      std::string_view("SQLite format 3\0", 16)) {
    return false;
  }
  const std::uintmax_t page_bytes =
      header[16] == 0 && header[17] == 1 ? 65536U : header[16] * 256U + header[17];
  std::uintmax_t pages = 0;
  for (int i = 28; i < 32; ++i) pages = pages * 256U + header[static_cast<std::size_t>(i)];
  const std::uintmax_t told_bytes = pages * page_bytes;
  if (std::filesystem::file_size(file) >= told_bytes) return false;
  std::filesystem::copy_file(file, copy);
  std::filesystem::resize_file(copy, told_bytes);  // without taking room for the zeros
  if (std::filesystem::exists(file + "-wal")) {
    std::filesystem::copy_file(file + "-wal", copy + "-wal");
  }
  return true;
}

std::vector<std::string> salvage(SQLite::Database& damaged, SQLite::Database& fresh) {
  fresh.exec("PRAGMA foreign_keys = OFF");
  SQLite::Transaction transaction(fresh);
  std::vector<std::string> left_out;
  for (const char* table : {"session", "landmark", "landmark_view", "episode"}) {
    left_out.push_back(copy_by_id(damaged, fresh, table));
  }
  left_out.push_back(copy_by_two(damaged, fresh, "route", {"from_landmark", "to_landmark"}));
  left_out.push_back(copy_by_two(damaged, fresh, "obstacle_cell", {"cell_row", "cell_column"}));
  if (const std::int64_t routes = mend_references(fresh); routes > 0) {
    left_out.push_back(fmt::format("route: {} that led to landmarks that are lost", routes));
  }
  transaction.commit();
  fresh.exec("PRAGMA foreign_keys = ON");
  std::erase(left_out, "");
  return left_out;
}

}  // namespace striate::memory
