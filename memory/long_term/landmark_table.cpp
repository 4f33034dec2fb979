#include "striate/memory/long_term/landmark_table.hpp"

#include <fmt/format.h>

#include <cstdlib>

#include "striate/base/plain_text.hpp"
#include "striate/memory/long_term/statement_use.hpp"

namespace striate::memory {
namespace {

constexpr const char* kSelect =
    "SELECT id, session, name, kind, x_m, y_m, var_x_m2, cov_xy_m2, var_y_m2, strength, uses, "
    "first_use_s, recent_uses_s, pinned, retired_s, retired_why, "
    "(SELECT count(*) FROM landmark_view v WHERE v.landmark = landmark.id), "
    "(SELECT coalesce(sum(keypoint_count), 0) FROM landmark_view v WHERE v.landmark = landmark.id) "
    "FROM landmark ";

Landmark read(const StatementUse& row) {
  Landmark mark;
  mark.id = row.column(0).getInt64();
  mark.session = row.column(1).getInt64();
  mark.name = plain_text(row.column(2).getString());
  mark.kind =
      row.column(3).getString() == "taught" ? LandmarkKind::taught : LandmarkKind::candidate;
  if (!row.column(4).isNull()) {
    mark.position = {row.column(4).getDouble(), row.column(5).getDouble(),
                     row.column(6).getDouble(), row.column(7).getDouble(),
                     row.column(8).getDouble()};
  }
  mark.strength = row.column(9).getDouble();
  mark.history.uses = row.count(10);
  mark.history.first_s = row.column(11).getDouble();
  mark.history.recent_s = parse_uses(row.column(12).getString());
  mark.pinned = row.column(13).getInt() != 0;
  mark.retired_s = row.maybe(14);
  mark.retired_why = plain_text(row.column(15).getString());
  mark.views = row.column(16).getInt();
  mark.keypoints = row.column(17).getInt();
  return mark;
}

/// The columns that `add` and `update` share, in their order.
void bind(StatementUse& use, const Landmark& mark) {
  if (mark.position) {
    const MapPosition& at = *mark.position;
    use.with(at.x_m).with(at.y_m).with(at.var_x_m2).with(at.cov_xy_m2).with(at.var_y_m2);
  } else {
    for (int k = 0; k < 5; ++k) use.with_null();
  }
  use.with(mark.strength).with(mark.history.uses).with(mark.history.first_s);
  use.with(print_uses(mark.history.recent_s)).with(mark.pinned ? 1 : 0);
  use.with(mark.retired_s).with(mark.retired_why);
}

}  // namespace

LandmarkTable::LandmarkTable(SQLite::Database& database)
    : database_(database),
      add_(database,
           "INSERT INTO landmark (x_m, y_m, var_x_m2, cov_xy_m2, var_y_m2, strength, uses, "
           "first_use_s, recent_uses_s, pinned, retired_s, retired_why, session, name, kind) "
           "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"),
      find_(database, std::string(kSelect).append("WHERE name = ?")),
      all_(database, std::string(kSelect).append("WHERE ? OR retired_s IS NULL ORDER BY name")),
      update_(database,
              "UPDATE landmark SET x_m = ?, y_m = ?, var_x_m2 = ?, cov_xy_m2 = ?, var_y_m2 = ?, "
              "strength = ?, uses = ?, first_use_s = ?, recent_uses_s = ?, pinned = ?, "
              "retired_s = ?, retired_why = ? WHERE id = ?"),
      set_position_(database,
                    "UPDATE landmark SET x_m = ?, y_m = ?, var_x_m2 = ?, cov_xy_m2 = ?, "
                    "var_y_m2 = ? WHERE id = ?"),
      rename_(database, "UPDATE landmark SET name = ?, kind = ? WHERE id = ?"),
      remove_(database, "DELETE FROM landmark WHERE id = ?") {}

std::int64_t LandmarkTable::add(const Landmark& landmark) {
  StatementUse use(add_);
  bind(use, landmark);
  use.with(landmark.session).with(landmark.name).with(std::string(name_of(landmark.kind))).run();
  return database_.getLastInsertRowid();
}

std::optional<Landmark> LandmarkTable::find(const std::string& name) {
  StatementUse use(find_);
  use.with(name);
  if (!use.next()) return std::nullopt;
  return read(use);
}

std::vector<Landmark> LandmarkTable::all(bool with_retired) {
  StatementUse use(all_);
  use.with(with_retired ? 1 : 0);
  std::vector<Landmark> marks;
  while (use.next()) marks.push_back(read(use));
  return marks;
}

void LandmarkTable::update(const Landmark& landmark) {
  StatementUse use(update_);
  bind(use, landmark);
  use.with(landmark.id).run();
}

void LandmarkTable::set_position(std::int64_t id, const MapPosition& at) {
  StatementUse use(set_position_);
  use.with(at.x_m).with(at.y_m).with(at.var_x_m2).with(at.cov_xy_m2).with(at.var_y_m2);
  use.with(id).run();
}

void LandmarkTable::rename(std::int64_t id, const std::string& name, LandmarkKind kind) {
  StatementUse(rename_).with(name).with(std::string(name_of(kind))).with(id).run();
}

void LandmarkTable::remove(std::int64_t id) {
  StatementUse(remove_).with(id).run();
}

std::string print_uses(const std::vector<double>& recent_s) {
  std::string text = "[";
  for (const double time_s : recent_s) {
    text += fmt::format("{}{:.3f}", text.size() > 1 ? ", " : "", time_s);
  }
  return text + "]";
}

std::vector<double> parse_uses(const std::string& text) {
  std::vector<double> recent_s;
  const char* at = text.c_str();
  while (*at == '[' || *at == ',' || *at == ' ') ++at;
  while (*at != '\0' && *at != ']') {
    char* end = nullptr;
    const double time_s = std::strtod(at, &end);
    if (end == at) break;
    recent_s.push_back(time_s);
    at = end;
    while (*at == ',' || *at == ' ') ++at;
  }
  return recent_s;
}

}  // namespace striate::memory
