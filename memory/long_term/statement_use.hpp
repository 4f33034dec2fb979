#pragma once

#include <SQLiteCpp/Statement.h>

#include <algorithm>
#include <cstdint>
#include <optional>

namespace striate::memory {

/// One use of a statement that is prepared once: clean before, given back after, whatever happens
/// between. A statement that is not given back keeps its read transaction open.
class StatementUse {
 public:
  explicit StatementUse(SQLite::Statement& statement) : statement_(statement) {
    statement_.tryReset();
    statement_.clearBindings();
  }
  ~StatementUse() { statement_.tryReset(); }
  StatementUse(const StatementUse&) = delete;
  StatementUse& operator=(const StatementUse&) = delete;

  /// Binds the next parameter; nothing of an optional is NULL.
  template <class T>
  StatementUse& with(const T& value) {
    statement_.bind(++bound_, value);
    return *this;
  }
  template <class T>
  StatementUse& with(const std::optional<T>& value) {
    ++bound_;
    if (value) statement_.bind(bound_, *value);
    return *this;
  }
  /// Bytes that stay where they are until the statement has run.
  StatementUse& with_bytes(const void* data, std::size_t size) {
    statement_.bindNoCopy(++bound_, data, static_cast<int>(size));
    return *this;
  }
  StatementUse& with_null() {
    ++bound_;
    return *this;
  }

  /// @return rows changed.
  int run() { return statement_.exec(); }
  [[nodiscard]] bool next() { return statement_.executeStep(); }
  [[nodiscard]] SQLite::Column column(int index) const { return statement_.getColumn(index); }
  /// How often something was: whatever the file says, what can be added to others and counted on.
  [[nodiscard]] std::int64_t count(int index) const {
    constexpr std::int64_t kMost = 1'000'000'000'000;  // by hand: once a second for 30 000 years
    return std::clamp<std::int64_t>(statement_.getColumn(index).getInt64(), 0, kMost);
  }
  [[nodiscard]] std::optional<double> maybe(int index) const {
    const SQLite::Column value = statement_.getColumn(index);
    return value.isNull() ? std::nullopt : std::optional<double>(value.getDouble());
  }

 private:
  SQLite::Statement& statement_;
  int bound_ = 0;
};

}  // namespace striate::memory
