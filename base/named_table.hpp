#pragma once

#include <cstddef>
#include <deque>
#include <iterator>
#include <mutex>
#include <shared_mutex>
#include <string_view>
#include <utility>
#include <vector>

namespace striate {

/// Entries that are found by their `name`, in the order in which they were added. An entry stays
/// where it is, so a pointer to it holds as long as the table. Entries may be added in one thread
/// while others search and go through the table: they see those that were there when they began.
template <class Entry>
class NamedTable {
 public:
  class const_iterator {
   public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = Entry;
    using difference_type = std::ptrdiff_t;
    using pointer = const Entry*;
    using reference = const Entry&;

    const_iterator() = default;
    const_iterator(const NamedTable* table, std::size_t place) : table_(table), place_(place) {}
    reference operator*() const { return table_->at(place_); }
    pointer operator->() const { return &table_->at(place_); }
    const_iterator& operator++() {
      ++place_;
      return *this;
    }
    const_iterator operator++(int) { return {table_, place_++}; }
    bool operator==(const const_iterator&) const = default;

   private:
    const NamedTable* table_ = nullptr;
    std::size_t place_ = 0;
  };

  NamedTable() = default;
  explicit NamedTable(std::vector<Entry> entries) {
    for (Entry& entry : entries) entries_.push_back(std::move(entry));
  }

  /// @return false, and nothing is added, where the name is taken
  bool add(Entry entry) {
    const std::unique_lock alone(mutex_);
    if (found(entry.name) != nullptr) return false;
    entries_.push_back(std::move(entry));
    return true;
  }
  /// The entry of that name, or nullptr.
  [[nodiscard]] const Entry* find(std::string_view name) const {
    const std::shared_lock among_readers(mutex_);
    return found(name);
  }

  [[nodiscard]] const_iterator begin() const { return {this, 0}; }
  [[nodiscard]] const_iterator end() const { return {this, size()}; }
  [[nodiscard]] std::size_t size() const {
    const std::shared_lock among_readers(mutex_);
    return entries_.size();
  }
  [[nodiscard]] bool empty() const { return size() == 0; }

 private:
  [[nodiscard]] const Entry& at(std::size_t place) const {
    const std::shared_lock among_readers(mutex_);
    return entries_[place];
  }
  [[nodiscard]] const Entry* found(std::string_view name) const {
    for (const Entry& entry : entries_) {
      if (entry.name == name) return &entry;
    }
    return nullptr;
  }

  mutable std::shared_mutex mutex_;
  std::deque<Entry> entries_;
};

}  // namespace striate
