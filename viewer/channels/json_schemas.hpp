#pragma once

/// What stands in the JSON of the channels `/striate/*`, as JSON Schemas (draft 2020-12).
namespace striate::viewer {

/// How the task stands: at its begin, and whenever the action or the mission's state changes.
inline constexpr const char* kTaskSchema = R"({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "title": "striate.Task", "type": "object", "additionalProperties": false,
  "required": ["mission", "state", "reason", "action", "tree"],
  "properties": {
    "mission": {"type": "string"},
    "state": {"enum": ["running", "succeeded", "failed", "interrupted"]},
    "reason": {"type": "string", "description": "why it ended"},
    "action": {"type": "string", "description": "that runs; empty: none"},
    "tree": {"$ref": "#/$defs/node"}
  },
  "$defs": {"node": {
    "type": "object", "additionalProperties": false,
    "required": ["title", "limits", "line", "children"],
    "properties": {
      "title": {"type": "string"},
      "limits": {"type": "string", "description": "how it may end or be skipped"},
      "line": {"type": "integer", "description": "in the script, from 1"},
      "children": {"type": "array", "items": {"$ref": "#/$defs/node"}}
    }
  }}
})";

/// What the behaviour wanted in a cycle, and what was sent to the motors.
inline constexpr const char* kWishSchema = R"({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "title": "striate.Wish", "type": "object", "additionalProperties": false,
  "required": ["why", "progress", "driver", "limited_by", "wish", "sent"],
  "properties": {
    "why": {"type": "string"},
    "progress": {"enum": ["running", "succeeded", "failed"]},
    "driver": {"type": "string", "description": "whose wish it was that drove"},
    "limited_by": {"type": "string"},
    "wish": {"$ref": "#/$defs/command"},
    "sent": {"$ref": "#/$defs/command"}
  },
  "$defs": {"command": {
    "type": "object", "additionalProperties": false,
    "required": ["forward_m_s", "turn_rad_s", "pan_rad", "tilt_rad"],
    "properties": {
      "forward_m_s": {"type": "number"}, "turn_rad_s": {"type": "number"},
      "pan_rad": {"type": "number"}, "tilt_rad": {"type": "number"}
    }
  }}
})";

/// What short-term memory holds, once a second; as `striate recall --json` prints it.
inline constexpr const char* kShortTermSchema = R"({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "title": "striate.ShortTermMemory", "type": "object",
  "required": ["kind", "cycle", "time_s", "action", "why", "limited_by", "pose", "picture",
               "corridor", "polar_map", "salient_regions", "landmarks", "commands"],
  "properties": {
    "kind": {"type": "string"}, "cycle": {"type": "integer"}, "time_s": {"type": "number"},
    "action": {"type": "string"}, "why": {"type": "string"}, "limited_by": {"type": "string"},
    "pose": {"type": "object", "properties": {
      "x_m": {"type": "number"}, "y_m": {"type": "number"}, "heading_rad": {"type": "number"},
      "forward_m_s": {"type": "number"}, "turn_rad_s": {"type": "number"},
      "pan_rad": {"type": "number"}, "tilt_rad": {"type": "number"}}},
    "picture": {"type": "object", "properties": {
      "age_s": {"type": ["number", "null"]}, "light_level": {"type": "number"},
      "noise_level": {"type": "number"}, "seen_share": {"type": "number"}}},
    "corridor": {"type": "object", "properties": {
      "axis_rad": {"type": "number"}, "offset_left_m": {"type": "number"},
      "width_m": {"type": "number"}, "width_known": {"type": "boolean"},
      "left_wall_m": {"type": ["number", "null"]}, "right_wall_m": {"type": ["number", "null"]},
      "progress_m": {"type": "number"}}},
    "polar_map": {"type": "array", "items": {"type": "object", "properties": {
      "to_m": {"type": "number"}, "sectors": {"type": "string"}}}},
    "salient_regions": {"type": "array", "items": {"type": "object", "properties": {
      "id": {"type": "integer"}, "bearing_rad": {"type": "number"},
      "distance_m": {"type": ["number", "null"]}, "size_rad": {"type": "number"},
      "salience": {"type": "number"}, "hits": {"type": "integer"},
      "activation": {"type": "number"}, "seen_s_ago": {"type": "number"},
      "inhibited": {"type": "boolean"}}}},
    "landmarks": {"type": "array", "items": {"type": "object", "properties": {
      "name": {"type": "string"}, "sightings": {"type": "integer"},
      "confirmed": {"type": "boolean"}, "score": {"type": "number"},
      "bearing_rad": {"type": "number"}, "distance_m": {"type": ["number", "null"]},
      "sigma_m": {"type": ["number", "null"]}, "seen_s_ago": {"type": ["number", "null"]}}}},
    "commands": {"type": "array", "items": {"type": "object", "properties": {
      "time_s": {"type": "number"}, "forward_m_s": {"type": "number"},
      "turn_rad_s": {"type": "number"}, "pan_rad": {"type": "number"},
      "tilt_rad": {"type": "number"}, "action": {"type": "string"}}}}
  }
})";

/// What recognition teaches long-term memory; a message where there is something.
inline constexpr const char* kMemoryEventsSchema = R"({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "title": "striate.MemoryEvents", "type": "object", "additionalProperties": false,
  "required": ["recognised", "lessons"],
  "properties": {
    "recognised": {"type": "array", "items": {"type": "string"},
                   "description": "landmarks in the image of this cycle"},
    "lessons": {"type": "array", "items": {
      "type": "object", "additionalProperties": false, "required": ["landmark", "kind"],
      "properties": {"landmark": {"type": "string"}, "kind": {"enum": ["recognised", "missed"]}}}}
  }
})";

/// What a cycle is: its number, and how old its image was.
inline constexpr const char* kCycleSchema = R"({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "title": "striate.Cycle", "type": "object", "additionalProperties": false,
  "required": ["number", "time_s", "image_age_s", "new_image", "refused", "bumper", "stalled"],
  "properties": {
    "number": {"type": "integer", "description": "from 1"},
    "time_s": {"type": "number", "description": "of the mission's clock"},
    "image_age_s": {"type": ["number", "null"], "description": "null: no image has come yet"},
    "new_image": {"type": "boolean"},
    "refused": {"type": "string", "description": "why the newest image was not taken"},
    "bumper": {"type": "boolean"},
    "stalled": {"type": "boolean"}
  }
})";

/// What was found in an image, in pixels of it; a message a new image. Pixels of `width_px` x
/// `height_px`, which may be fewer than the image's own.
inline constexpr const char* kSeenSchema = R"({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "title": "striate.Seen", "type": "object", "additionalProperties": false,
  "required": ["stamp_s", "width_px", "height_px", "camera", "columns", "regions", "keypoints",
               "landmarks", "people"],
  "properties": {
    "stamp_s": {"type": "number", "description": "of the image, on the mission's clock"},
    "width_px": {"type": "integer"}, "height_px": {"type": "integer"},
    "camera": {"type": "object", "properties": {
      "height_m": {"type": "number"}, "forward_m": {"type": "number"},
      "pan_rad": {"type": "number"}, "tilt_rad": {"type": "number"},
      "focal_px": {"type": "number"}, "centre_u_px": {"type": "number"},
      "centre_v_px": {"type": "number"}}},
    "columns": {"type": "array", "description": "some of the image's, left to right",
      "items": {"type": "object", "properties": {
        "u_px": {"type": "integer"}, "bearing_rad": {"type": "number"},
        "free_from_m": {"type": "number"}, "free_to_m": {"type": "number"},
        "obstacle_m": {"type": ["number", "null"]}}}},
    "regions": {"type": "array", "description": "most salient first",
      "items": {"type": "object", "properties": {
        "u_px": {"type": "number"}, "v_px": {"type": "number"},
        "width_px": {"type": "number"}, "height_px": {"type": "number"},
        "salience": {"type": "number"}, "bearing_rad": {"type": "number"},
        "distance_m": {"type": ["number", "null"]}}}},
    "keypoints": {"type": "array", "items": {"type": "number"},
                  "description": "u, v, wavelength of one after the other"},
    "landmarks": {"type": "array", "description": "that were recognised",
      "items": {"type": "object", "properties": {
        "name": {"type": "string"}, "score": {"type": "number"},
        "u_px": {"type": "number"}, "v_px": {"type": "number"},
        "width_px": {"type": "number"}, "height_px": {"type": "number"},
        "distance_m": {"type": ["number", "null"]}}}},
    "people": {"type": "array", "description": "what moves by itself",
      "items": {"type": "object", "properties": {
        "from_u_px": {"type": "integer"}, "to_u_px": {"type": "integer"},
        "bearing_rad": {"type": "number"}, "distance_m": {"type": "number"},
        "forward_m_s": {"type": ["number", "null"]}, "left_m_s": {"type": ["number", "null"]}}}}
  }
})";

/// How each node of the task's tree stands; a message where one changes.
inline constexpr const char* kTaskNodesSchema = R"({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "title": "striate.TaskNodes", "type": "object", "additionalProperties": false,
  "required": ["states", "reason"],
  "properties": {
    "states": {"type": "string", "description":
      "a letter a node, each before its children: w waits, r runs, s succeeded, f failed, k skipped, h halted, - runs nothing by itself"},
    "reason": {"type": "string", "description": "of the newest failure; empty: none"}
  }
})";

}  // namespace striate::viewer
