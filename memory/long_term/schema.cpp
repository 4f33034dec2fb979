#include "striate/memory/long_term/schema.hpp"

namespace striate::memory::schema {
namespace {

constexpr const char* kCreate = R"sql(
CREATE TABLE session (
  id INTEGER PRIMARY KEY,
  kind TEXT NOT NULL CHECK (kind IN ('teach', 'mission', 'replay', 'import')),
  state TEXT NOT NULL CHECK (state IN ('open', 'closed', 'crashed')),
  started_unix_s INTEGER NOT NULL CHECK (started_unix_s >= 0),
  operating_start_s REAL NOT NULL CHECK (operating_start_s >= 0),
  operating_s REAL NOT NULL DEFAULT 0 CHECK (operating_s >= 0),
  software TEXT NOT NULL,
  settings TEXT NOT NULL,
  outcome TEXT NOT NULL DEFAULT ''
) STRICT;

CREATE TABLE landmark (
  id INTEGER PRIMARY KEY,
  session INTEGER NOT NULL REFERENCES session (id),
  name TEXT NOT NULL UNIQUE CHECK (length(name) BETWEEN 1 AND 64),
  kind TEXT NOT NULL CHECK (kind IN ('taught', 'candidate')),
  x_m REAL, y_m REAL,
  var_x_m2 REAL CHECK (var_x_m2 >= 0), cov_xy_m2 REAL, var_y_m2 REAL CHECK (var_y_m2 >= 0),
  strength REAL NOT NULL CHECK (strength > 0 AND strength < 1),
  uses INTEGER NOT NULL CHECK (uses >= 0),
  first_use_s REAL NOT NULL CHECK (first_use_s >= 0),
  recent_uses_s TEXT NOT NULL
    CHECK (json_valid(recent_uses_s) AND json_array_length(recent_uses_s) <= 10),
  pinned INTEGER NOT NULL DEFAULT 0 CHECK (pinned IN (0, 1)),
  retired_s REAL CHECK (retired_s >= 0),
  retired_why TEXT NOT NULL DEFAULT '',
  CHECK ((x_m IS NULL) = (y_m IS NULL) AND (x_m IS NULL) = (var_x_m2 IS NULL)
    AND (x_m IS NULL) = (cov_xy_m2 IS NULL) AND (x_m IS NULL) = (var_y_m2 IS NULL)),
  CHECK (x_m IS NULL OR cov_xy_m2 * cov_xy_m2 <= var_x_m2 * var_y_m2 * 1.000001)
) STRICT;

CREATE TABLE landmark_view (
  id INTEGER PRIMARY KEY,
  landmark INTEGER NOT NULL REFERENCES landmark (id) ON DELETE CASCADE,
  session INTEGER NOT NULL REFERENCES session (id),
  width_px REAL NOT NULL CHECK (width_px > 0),
  height_px REAL NOT NULL CHECK (height_px > 0),
  keypoint_count INTEGER NOT NULL CHECK (keypoint_count > 0),
  range_m REAL CHECK (range_m > 0),
  bearing_rad REAL CHECK (bearing_rad BETWEEN -3.1416 AND 3.1416),
  crc INTEGER NOT NULL CHECK (crc BETWEEN 0 AND 4294967295),
  descriptors BLOB NOT NULL CHECK (length(descriptors) = 32 * keypoint_count),
  keypoints BLOB NOT NULL CHECK (length(keypoints) = 16 * keypoint_count),
  picture_crc INTEGER NOT NULL DEFAULT 0 CHECK (picture_crc BETWEEN 0 AND 4294967295),
  picture BLOB
) STRICT;
CREATE INDEX landmark_view_of ON landmark_view (landmark);

CREATE TABLE route (
  from_landmark INTEGER NOT NULL REFERENCES landmark (id) ON DELETE CASCADE,
  to_landmark INTEGER NOT NULL REFERENCES landmark (id) ON DELETE CASCADE,
  distance_m REAL NOT NULL CHECK (distance_m >= 0),
  turn_rad REAL NOT NULL CHECK (turn_rad BETWEEN -3.1416 AND 3.1416),
  distance_var_m2 REAL NOT NULL CHECK (distance_var_m2 >= 0),
  turn_var_rad2 REAL NOT NULL CHECK (turn_var_rad2 >= 0),
  successes INTEGER NOT NULL CHECK (successes >= 0),
  failures INTEGER NOT NULL CHECK (failures >= 0),
  PRIMARY KEY (from_landmark, to_landmark),
  CHECK (from_landmark <> to_landmark)
) STRICT, WITHOUT ROWID;

CREATE TABLE obstacle_cell (
  cell_row INTEGER NOT NULL,
  cell_column INTEGER NOT NULL,
  log_odds REAL NOT NULL CHECK (log_odds BETWEEN -20 AND 20),
  seen_s REAL NOT NULL CHECK (seen_s >= 0),
  PRIMARY KEY (cell_row, cell_column)
) STRICT, WITHOUT ROWID;

CREATE TABLE episode (
  id INTEGER PRIMARY KEY,
  session INTEGER REFERENCES session (id),
  time_s REAL NOT NULL CHECK (time_s >= 0),
  kind TEXT NOT NULL CHECK (length(kind) BETWEEN 1 AND 32),
  x_m REAL, y_m REAL, heading_rad REAL,
  landmark TEXT NOT NULL DEFAULT '',
  text TEXT NOT NULL DEFAULT ''
) STRICT;

CREATE TABLE migration (
  version INTEGER PRIMARY KEY CHECK (version >= 1),
  at_unix_s INTEGER NOT NULL CHECK (at_unix_s >= 0),
  software TEXT NOT NULL,
  backup TEXT NOT NULL
) STRICT;
)sql";

}  // namespace

const char* create() {
  return kCreate;
}

std::span<const Step> steps() {
  return {};
}

}  // namespace striate::memory::schema
