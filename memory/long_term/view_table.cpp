#include "striate/memory/long_term/view_table.hpp"

#include <string>

#include "striate/memory/long_term/statement_use.hpp"
#include "striate/memory/long_term/view_codec.hpp"

namespace striate::memory {
namespace {

const std::string kColumns =
    "v.id, v.landmark, v.session, v.width_px, v.height_px, v.range_m, v.bearing_rad, v.crc, "
    "v.descriptors, v.keypoints";

}  // namespace

ViewTable::ViewTable(SQLite::Database& database)
    : database_(database),
      add_(database,
           "INSERT INTO landmark_view (landmark, session, width_px, height_px, keypoint_count, "
           "range_m, bearing_rad, crc, descriptors, keypoints, picture_crc, picture) "
           "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"),
      of_(database, "SELECT " + kColumns + ", v.picture_crc, v.picture FROM landmark_view v " +
                        "WHERE v.landmark = ? ORDER BY v.id"),
      each_(database, "SELECT " + kColumns +
                          " FROM landmark_view v CROSS JOIN landmark l ON l.id = v.landmark "
                          "WHERE l.retired_s IS NULL AND v.id <= ? ORDER BY v.id"),
      remove_(database, "DELETE FROM landmark_view WHERE id = ?"),
      count_of_session_(database, "SELECT count(*) FROM landmark_view WHERE session = ?"),
      remove_of_session_(database, "DELETE FROM landmark_view WHERE session = ?"),
      remove_empty_(database,
                    "DELETE FROM landmark WHERE session = ? AND NOT EXISTS "
                    "(SELECT 1 FROM landmark_view v WHERE v.landmark = landmark.id)") {}

std::int64_t ViewTable::add(const StoredView& view) {
  const auto descriptors = bytes_of(view.descriptors);
  const auto keypoints = bytes_of(view.keypoints);
  StatementUse use(add_);
  use.with(view.landmark).with(view.session).with(view.width_px).with(view.height_px);
  use.with(static_cast<std::int64_t>(view.keypoints.size()));
  use.with(view.range_m).with(view.bearing_rad);
  use.with(static_cast<std::int64_t>(
      checksum_of_view(view.width_px, view.height_px, descriptors, keypoints)));
  use.with_bytes(descriptors.data(), descriptors.size());
  use.with_bytes(keypoints.data(), keypoints.size());
  use.with(static_cast<std::int64_t>(crc32c(view.image)));
  if (view.image.empty()) {
    use.with_null();
  } else {
    use.with_bytes(view.image.data(), view.image.size());
  }
  use.run();
  return database_.getLastInsertRowid();
}

void ViewTable::read(const StatementUse& row, StoredView& view, bool with_image) {
  view.id = row.column(0).getInt64();
  view.landmark = row.column(1).getInt64();
  view.session = row.column(2).getInt64();
  view.width_px = row.column(3).getDouble();
  view.height_px = row.column(4).getDouble();
  view.range_m = row.maybe(5);
  view.bearing_rad = row.maybe(6);
  const auto descriptors = bytes_of(row.column(8));
  const auto keypoints = bytes_of(row.column(9));
  view.damaged = checksum_of_view(view.width_px, view.height_px, descriptors, keypoints) !=
                 static_cast<std::uint32_t>(row.column(7).getInt64());
  unpack(descriptors, view.descriptors);
  unpack(keypoints, view.keypoints);
  view.image.clear();
  if (with_image) {
    const auto image = bytes_of(row.column(11));
    // A damaged image is left out: copied on, it would get a checksum that fits.
    if (crc32c(image) == static_cast<std::uint32_t>(row.column(10).getInt64())) {
      view.image.assign(image.begin(), image.end());
    }
  }
}

std::vector<StoredView> ViewTable::of(std::int64_t landmark) {
  StatementUse use(of_);
  use.with(landmark);
  std::vector<StoredView> views;
  while (use.next()) read(use, views.emplace_back(), true);
  return views;
}

void ViewTable::for_each(const std::function<void(const StoredView&)>& take, std::int64_t last) {
  StatementUse use(each_);
  use.with(last);
  StoredView view;
  while (use.next()) {
    read(use, view, false);
    take(view);
  }
}

void ViewTable::remove(std::int64_t id) {
  StatementUse(remove_).with(id).run();
}

int ViewTable::count_of_session(std::int64_t session) {
  StatementUse use(count_of_session_);
  use.with(session);
  return use.next() ? use.column(0).getInt() : 0;
}

void ViewTable::remove_of_session(std::int64_t session) {
  StatementUse(remove_of_session_).with(session).run();
  StatementUse(remove_empty_).with(session).run();
}

}  // namespace striate::memory
