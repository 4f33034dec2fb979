#pragma once

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/mark.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "striate/base/plain_text.hpp"
#include "striate/config/node.hpp"

namespace striate::config {

/// Far deeper than any file that ships; more is an attack on the stack (ours)
inline constexpr int kMaxDepth = 32;
/// Aliases may multiply a short file: far more than a file that ships has (ours)
inline constexpr int kMaxValues = 20'000;

/// Thrown where reading on makes no sense; the mistake is noted already.
struct GiveUp {};

inline SourceLocation place_of(const YAML::Mark& mark) {
  return {mark.line + 1, mark.column + 1};
}

/// Builds the tree from parser events, because the library's own tree forgets duplicate keys,
/// expands alias bombs and reads 010 as 8.
class TreeBuilder final : public YAML::EventHandler {
 public:
  TreeBuilder(const std::string& text, Diagnostics& diagnostics)
      : text_(text), diagnostics_(diagnostics) {}
  Node take() { return std::move(root_); }
  /// Where the last text in quotes begins; line 0 where there is none.
  [[nodiscard]] SourceLocation last_quoted() const { return last_quoted_; }

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    refuse_anchor(mark, anchor);
    Node node;
    node.place = place_before(mark);
    put(std::move(node));
  }
  /// The parser does not follow aliases by itself, so a bomb of them stays small.
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    if (!alias_told_) {
      diagnostics_.add(fault::not_allowed, place_of(mark), "aliases (*name) are not allowed",
                       "write the value out where it is needed");
    }
    alias_told_ = true;
    Node node;
    node.kind = Node::Kind::scalar;
    node.place = place_of(mark);
    node.open = true;
    put(std::move(node));
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    refuse_anchor(mark, anchor);
    refuse_tag(mark, tag);
    Node node;
    node.kind = Node::Kind::scalar;
    node.place = place_of(mark);
    node.text = value;
    node.quoted = tag == "!";
    if (node.quoted) last_quoted_ = node.place;
    refuse_hidden_letters(node);
    put(std::move(node));
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(Node::Kind::list, mark, tag, anchor);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(Node::Kind::map, mark, tag, anchor);
  }
  void OnMapEnd() override { close(); }

 private:
  struct Level {
    Node node;
    bool key_is_next = true;
    std::string key;
    SourceLocation key_place;
  };

  /// An empty value has no place of its own, and the parser gives that of what follows. Returns
  /// where the '-' or ':' before it stands.
  [[nodiscard]] SourceLocation place_before(const YAML::Mark& mark) const {
    auto at = std::min(static_cast<std::size_t>(std::max(mark.pos, 0)), text_.size());
    while (at > 0 && std::string_view(" \t\r\n").find(text_[at - 1]) != std::string_view::npos)
      --at;
    if (at == 0 || (text_[at - 1] != '-' && text_[at - 1] != ':')) return place_of(mark);
    const auto line = std::count(text_.begin(), text_.begin() + static_cast<long>(at), '\n');
    const std::size_t newline = text_.rfind('\n', at - 1);
    const std::size_t begin = newline == std::string::npos ? 0 : newline + 1;
    return {static_cast<int>(line) + 1, static_cast<int>(at - begin)};
  }

  /// The first is told; the rest is the same mistake.
  void refuse_anchor(const YAML::Mark& mark, YAML::anchor_t anchor) {
    if (anchor == 0 || anchor_told_) return;
    anchor_told_ = true;
    diagnostics_.add(fault::not_allowed, place_of(mark), "anchors (&name) are not allowed",
                     "write the value out where it is needed");
  }

  /// What is read here is shown in terminals, tables and pictures later.
  void refuse_hidden_letters(Node& node) {
    const std::string plain = plain_lines(node.text);
    if (plain == node.text) return;
    diagnostics_.add(
        fault::not_allowed, node.place,
        fmt::format("'{}' holds what no terminal shows: a control character, a mark of "
                    "direction or a byte that is no UTF-8",
                    plain),
        "write the file as UTF-8, without them");
    node.text = plain;
  }

  void refuse_tag(const YAML::Mark& mark, const std::string& tag) {
    if (tag.empty() || tag == "?" || tag == "!") return;
    diagnostics_.add(fault::not_allowed, place_of(mark),
                     fmt::format("tags ('{}') are not allowed", tag), "leave the tag away");
  }

  void open(Node::Kind kind, const YAML::Mark& mark, const std::string& tag,
            YAML::anchor_t anchor) {
    refuse_anchor(mark, anchor);
    refuse_tag(mark, tag);
    if (static_cast<int>(levels_.size()) >= kMaxDepth) {
      diagnostics_.add(fault::not_allowed, place_of(mark),
                       fmt::format("nested deeper than {} levels", kMaxDepth),
                       "split it into several files");
      throw GiveUp{};
    }
    Level level;
    level.node.kind = kind;
    level.node.place = place_of(mark);
    levels_.push_back(std::move(level));
  }

  void close() {
    Node node = std::move(levels_.back().node);
    levels_.pop_back();
    put(std::move(node));
  }

  void put(Node node) {
    if (++values_ > kMaxValues) {
      diagnostics_.add(fault::not_allowed, node.place,
                       fmt::format("more than {} values in one file", kMaxValues),
                       "split it into several files");
      throw GiveUp{};
    }
    if (levels_.empty()) {
      root_ = std::move(node);
      return;
    }
    Level& level = levels_.back();
    if (level.node.kind == Node::Kind::list) {
      level.node.items.push_back(std::move(node));
    } else if (level.key_is_next) {
      take_key(level, node);
    } else {
      level.node.entries.push_back({level.key, level.key_place, std::move(node)});
      level.key_is_next = true;
    }
  }

  void take_key(Level& level, const Node& node) {
    if (node.kind != Node::Kind::scalar) {
      diagnostics_.add(fault::wrong_kind, node.place, "a key must be a plain word", "");
    } else if (const Node::Entry* earlier = level.node.find(node.text)) {
      diagnostics_.add(fault::duplicate_key, node.place,
                       fmt::format("duplicate key '{}'", node.text),
                       fmt::format("it stands already in line {}", earlier->key_place.line));
    }
    level.key = node.text;
    level.key_place = node.place;
    level.key_is_next = false;
  }

  const std::string& text_;
  Diagnostics& diagnostics_;
  bool anchor_told_ = false;
  bool alias_told_ = false;
  int values_ = 0;
  SourceLocation last_quoted_;
  Node root_;
  std::vector<Level> levels_;
};

}  // namespace striate::config
