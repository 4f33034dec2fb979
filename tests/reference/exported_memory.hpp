#pragma once

#include <string>

/// A small memory as `striate memory export` writes it, with a row in every table.
namespace striate::reference {

inline std::string exported_memory() {
  return R"({
  "striate_memory": 1,
  "sessions": [
    {"id": 1, "kind": "teach", "state": "closed", "started_unix_s": 1700000000,
     "operating_start_s": 0.0, "operating_s": 60.5, "software": "striate 0.1.0",
     "settings": "", "outcome": "kept"}],
  "landmarks": [
    {"id": 1, "session": 1, "name": "book", "kind": "taught",
     "position": {"x_m": 1.5, "y_m": -0.5, "var_x_m2": 0.01, "cov_xy_m2": 0.0, "var_y_m2": 0.02},
     "strength": 0.5, "uses": 3, "first_use_s": 1.0, "recent_uses_s": [30.0, 20.0, 1.0],
     "pinned": false, "retired_s": null, "retired_why": "",
     "looks": [
       {"id": 1, "session": 1, "width_px": 64.0, "height_px": 48.0, "range_m": 1.2,
        "bearing_rad": 0.1, "descriptor_bytes": "AAECAwQFBgcICQoLDA0ODxAREhMUFRYXGBkaGxwdHh8=",
        "keypoint_bytes": "AAAoQQAAokEAAABBAAAAPw==", "picture": ""}]},
    {"id": 2, "session": 1, "name": "cup", "kind": "candidate", "position": null,
     "strength": 0.9, "uses": 1, "first_use_s": 5.0, "recent_uses_s": [5.0],
     "pinned": true, "retired_s": 50.0, "retired_why": "unused", "looks": []}],
  "routes": [
    {"from": 1, "to": 2, "distance_m": 3.0, "turn_rad": 0.5, "distance_var_m2": 0.1,
     "turn_var_rad2": 0.01, "successes": 4, "failures": 1}],
  "obstacle_cells": [
    {"column": 12, "row": -7, "log_odds": 1.5, "seen_s": 40.0},
    {"column": 13, "row": -7, "log_odds": -1.0, "seen_s": 41.0}],
  "episodes": [
    {"id": 1, "session": 1, "time_s": 12.0, "kind": "taught", "x_m": 0.5, "y_m": 0.25,
     "heading_rad": 0.1, "landmark": "book", "text": "one"},
    {"id": 2, "session": null, "time_s": 13.0, "kind": "forgotten", "x_m": null, "y_m": null,
     "heading_rad": null, "landmark": "", "text": "two"}],
  "damaged_views_left_out": 0
})";
}

}  // namespace striate::reference
