#pragma once

#include <map>
#include <string>
#include <utility>

#include "striate/config/node.hpp"

/// What people's keys mean: `K1`, `left_camera_matrix`, `LEFT.K`, `{left: {K: ...}}`.
namespace striate::datasets {

/// What a key may hold.
enum class Part {
  matrix,
  lens,
  turn,
  projection,
  way,
  to_depth,
  width,
  height,
  size,
  baseline,
  lens_model,
  fx,
  fy,
  cx,
  cy,
  none
};

/// Whose it is.
enum class Eye { both, first, second };

/// All that was understood of a file's keys, by part and eye.
class NamedParts {
 public:
  /// @param root must live as long
  explicit NamedParts(const config::Node& root);
  /// nullptr: there is none
  [[nodiscard]] const config::Node* find(Part part, Eye eye) const;
  /// Of this eye, or else of both.
  [[nodiscard]] const config::Node* own_or_common(Part part, Eye eye) const;
  /// What the file calls it, without control characters; "": there is none.
  [[nodiscard]] std::string key(Part part, Eye eye) const;

 private:
  struct Value {
    const config::Node* node = nullptr;
    std::string key;
  };
  std::map<std::pair<Part, Eye>, Value> values_;
};

}  // namespace striate::datasets
