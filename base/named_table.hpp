#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <string_view>
#include <utility>
#include <vector>

namespace striate {

/// Entries that are found by their `name`, in the order in which they were added. An entry stays
/// where it is, so a pointer to it holds as long as the table.
template <class Entry>
class NamedTable {
 public:
  using const_iterator = typename std::deque<Entry>::const_iterator;

  NamedTable() = default;
  explicit NamedTable(std::vector<Entry> entries) {
    for (Entry& entry : entries) entries_.push_back(std::move(entry));
  }

  /// @return false, and nothing is added, where the name is taken
  bool add(Entry entry) {
    if (find(entry.name) != nullptr) return false;
    entries_.push_back(std::move(entry));
    return true;
  }
  /// The entry of that name, or nullptr.
  [[nodiscard]] const Entry* find(std::string_view name) const {
    const auto found = std::find_if(begin(), end(), [&](const Entry& e) { return e.name == name; });
    return found == end() ? nullptr : &*found;
  }

  [[nodiscard]] const_iterator begin() const { return entries_.begin(); }
  [[nodiscard]] const_iterator end() const { return entries_.end(); }
  [[nodiscard]] std::size_t size() const { return entries_.size(); }
  [[nodiscard]] bool empty() const { return entries_.empty(); }

 private:
  std::deque<Entry> entries_;
};

}  // namespace striate
