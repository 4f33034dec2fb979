#include "striate/config/map_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace striate::config {

MapReader::MapReader(const Node& node, std::string what, Diagnostics& diagnostics)
    : node_(node), what_(std::move(what)), diagnostics_(diagnostics) {
  if (node_.kind != Node::Kind::map && node_.kind != Node::Kind::nothing) {
    diagnostics_.add(
        fault::wrong_kind, node_.place,
        fmt::format("{} must be a map of 'key: value', but is {}", what_, node_.describe()));
  }
}

const Node* MapReader::raw(const std::string& key) {
  if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.push_back(key);
  const Node::Entry* entry = node_.find(key);
  for (const auto& [was, now] : renamed_) {
    if (entry == nullptr && now == key) entry = node_.find(was);
  }
  return entry == nullptr ? nullptr : &entry->value;
}

bool MapReader::number(const std::string& key, double& target, Unit unit, Range range) {
  const Node* node = raw(key);
  if (node == nullptr || node->open) return false;
  const auto value = read_quantity(*node, unit, range, diagnostics_);
  if (value) target = *value;
  return value.has_value();
}

bool MapReader::integer(const std::string& key, int& target, Range range) {
  const Node* node = raw(key);
  if (node == nullptr || node->open) return false;
  const auto value = read_quantity(*node, Unit::none, range, diagnostics_);
  if (!value) return false;
  if (*value != std::floor(*value)) {
    diagnostics_.add(fault::no_number, node->place,
                     fmt::format("'{}' is not a whole number", node->text));
    return false;
  }
  target = static_cast<int>(*value);
  return true;
}

bool MapReader::flag(const std::string& key, bool& target) {
  const Node* node = raw(key);
  if (node == nullptr || node->open) return false;
  if (node->kind == Node::Kind::scalar && (node->text == "true" || node->text == "false")) {
    target = node->text == "true";
    return true;
  }
  diagnostics_.add(fault::unknown_choice, node->place,
                   fmt::format("{} is neither true nor false", node->describe()),
                   "write true or false");
  return false;
}

bool MapReader::text(const std::string& key, std::string& target) {
  const Node* node = raw(key);
  if (node == nullptr || node->open) return false;
  if (node->kind != Node::Kind::scalar) {
    diagnostics_.add(fault::wrong_kind, node->place,
                     fmt::format("'{}' must be a word or text, but is {}", key, node->describe()));
    return false;
  }
  target = node->text;
  return true;
}

bool MapReader::choice(const std::string& key, int& target, const std::vector<std::string>& names) {
  const Node* node = raw(key);
  if (node == nullptr || node->open) return false;
  const auto found = std::find(names.begin(), names.end(), node->text);
  if (node->kind == Node::Kind::scalar && found != names.end()) {
    target = static_cast<int>(found - names.begin());
    return true;
  }
  std::string hint = node->kind == Node::Kind::scalar ? suggest(node->text, names) : "";
  if (hint.empty()) hint = fmt::format("allowed: {}", fmt::join(names, ", "));
  diagnostics_.add(fault::unknown_choice, node->place,
                   fmt::format("{} is not known as '{}'", node->describe(), key), hint);
  return false;
}

bool MapReader::numbers(const std::string& key, const std::vector<double*>& targets, Unit unit,
                        Range range) {
  const Node* node = raw(key);
  if (node == nullptr || node->open) return false;
  if (node->kind != Node::Kind::list || node->items.size() != targets.size()) {
    diagnostics_.add(
        fault::wrong_kind, node->place,
        fmt::format("'{}' must be a list of {} values, but is {}", key, targets.size(),
                    node->kind == Node::Kind::list ? fmt::format("a list of {}", node->items.size())
                                                   : node->describe()),
        "write it like [9.0 m, 0.5 m]");
    return false;
  }
  bool good = true;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const auto value = read_quantity(node->items[i], unit, range, diagnostics_);
    if (value) *targets[i] = *value;
    good = good && value.has_value();
  }
  return good;
}

void MapReader::retired(const std::string& key, const std::string& note) {
  (void)raw(key);
  for (const Node::Entry& entry : node_.entries) {
    if (entry.key != key) continue;
    diagnostics_.warn(entry.key_place, fmt::format("'{}' has no effect any more", key), note);
  }
}

void MapReader::renamed(const std::string& was, const std::string& now) {
  renamed_.emplace_back(was, now);
  for (const Node::Entry& entry : node_.entries) {
    if (entry.key != was) continue;
    if (node_.find(now) == nullptr) {
      diagnostics_.warn(entry.key_place, fmt::format("'{}' is called '{}' now", was, now),
                        fmt::format("write '{}'; the next version will not know '{}'", now, was));
    } else {
      diagnostics_.add(
          fault::duplicate_key, entry.key_place,
          fmt::format("'{}' is the old name of '{}', which stands here, too", was, now),
          fmt::format("keep '{}'", now));
    }
  }
}

bool MapReader::require(const std::string& key) {
  if (raw(key) != nullptr) return true;
  if (node_.kind == Node::Kind::map || node_.kind == Node::Kind::nothing) {
    diagnostics_.add(fault::missing_key, node_.place, fmt::format("{} needs '{}'", what_, key));
  }
  return false;
}

void MapReader::finish() {
  for (const Node::Entry& entry : node_.entries) {
    if (std::find(known_.begin(), known_.end(), entry.key) != known_.end()) continue;
    const auto was_it = [&](const auto& names) { return names.first == entry.key; };
    if (std::any_of(renamed_.begin(), renamed_.end(), was_it)) continue;
    std::string hint = suggest(entry.key, known_);
    if (hint.empty() && !known_.empty()) {
      hint = fmt::format("known keys: {}", fmt::join(known_, ", "));
    }
    diagnostics_.add(fault::unknown_key, entry.key_place,
                     fmt::format("unknown key '{}' in {}", entry.key, what_), hint);
  }
}

}  // namespace striate::config
