#pragma once

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "striate/memory/long_term/records.hpp"

namespace striate::memory {

/// The table `landmark`. All errors are SQLite::Exception.
class LandmarkTable {
 public:
  explicit LandmarkTable(SQLite::Database& database);

  /// @return its id; what is in `landmark.id` and the counts is not read.
  std::int64_t add(const Landmark& landmark);
  [[nodiscard]] std::optional<Landmark> find(const std::string& name);
  /// By name. Retired ones too if asked for.
  [[nodiscard]] std::vector<Landmark> all(bool with_retired);

  /// Writes everything but id, session, name and kind.
  void update(const Landmark& landmark);
  /// Only where it is. Nothing where there is no such landmark any more.
  void set_position(std::int64_t id, const MapPosition& at);
  /// A candidate becomes a landmark that a person has named, or one is named anew.
  void rename(std::int64_t id, const std::string& name, LandmarkKind kind);
  /// With all its views and routes.
  void remove(std::int64_t id);

 private:
  SQLite::Database& database_;
  SQLite::Statement add_, find_, all_, update_, set_position_, rename_, remove_;
};

/// "[12.500, 3.000]" and back.
[[nodiscard]] std::string print_uses(const std::vector<double>& recent_s);
[[nodiscard]] std::vector<double> parse_uses(const std::string& text);

}  // namespace striate::memory
