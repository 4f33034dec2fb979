#pragma once

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "striate/config/map_reader.hpp"

/// One `visit()` per settings struct lists key, field, unit and range; it parses, checks and
/// prints. Defaults exist only in the struct's initialisers.
///
///     struct StereoSettings { int candidates = 64; double max_m = 8.0; };
///     template <class V> void visit(V& v, StereoSettings& s) {
///       v.integer("candidates", s.candidates, {1, 640}, "pixels searched along the line");
///       v.number("max", s.max_m, Unit::length, {0.5, 50}, "farthest distance that is trusted");
///     }
namespace striate::config {

/// Reads a settings struct from a map.
class SettingsReader {
 public:
  SettingsReader(const Node& node, std::string what, Diagnostics& diagnostics)
      : map_(node, std::move(what), diagnostics) {}
  void number(const char* key, double& field, Unit unit, Range range, const char* /*help*/) {
    map_.number(key, field, unit, range);
  }
  void integer(const char* key, int& field, Range range, const char* /*help*/) {
    map_.integer(key, field, range);
  }
  void flag(const char* key, bool& field, const char* /*help*/) { map_.flag(key, field); }
  void text(const char* key, std::string& field, const char* /*help*/) { map_.text(key, field); }
  /// A key that had a meaning once: still accepted, with a warning. @param note what to do instead
  void retired(const char* key, const char* note) { map_.retired(key, note); }
  /// A key that has another name now; stands before the key itself in `visit()`.
  void renamed(const char* was, const char* now) { map_.renamed(was, now); }
  template <class Enum>
  void choice(const char* key, Enum& field, const std::vector<std::string>& names,
              const char* /*help*/) {
    int index = static_cast<int>(field);
    map_.choice(key, index, names);
    field = static_cast<Enum>(index);
  }
  template <class Section>
  void section(const char* key, Section& field) {
    if (const Node* node = map_.raw(key)) {
      SettingsReader inner(*node, key, map_.diagnostics());
      visit(inner, field);
      inner.finish();
    }
  }
  bool require(const std::string& key) { return map_.require(key); }
  void finish() { map_.finish(); }

 private:
  MapReader map_;
};

/// One line of `striate config`.
struct SettingLine {
  std::string key;      ///< "stereo.candidates"
  std::string value;    ///< "64", "0.4 m/s"
  std::string allowed;  ///< "1 .. 640", "paper, robust"
  std::string help;
};

/// Lists a settings struct as it is in force.
class SettingsPrinter {
 public:
  explicit SettingsPrinter(std::string prefix = {}) : prefix_(std::move(prefix)) {}
  void number(const char* key, double& field, Unit unit, Range range, const char* help);
  void integer(const char* key, int& field, Range range, const char* help);
  void flag(const char* key, bool& field, const char* help);
  void text(const char* key, std::string& field, const char* help);
  void retired(const char* /*key*/, const char* /*note*/) {}
  void renamed(const char* /*was*/, const char* /*now*/) {}
  template <class Enum>
  void choice(const char* key, Enum& field, const std::vector<std::string>& names,
              const char* help) {
    add_choice(key, static_cast<int>(field), names, help);
  }
  template <class Section>
  void section(const char* key, Section& field) {
    SettingsPrinter inner(prefix_ + key + ".");
    visit(inner, field);
    for (SettingLine& line : inner.lines_) lines_.push_back(std::move(line));
  }
  [[nodiscard]] const std::vector<SettingLine>& lines() const { return lines_; }

 private:
  void add_choice(const char* key, int index, const std::vector<std::string>& names,
                  const char* help);
  std::string prefix_;
  std::vector<SettingLine> lines_;
};

}  // namespace striate::config
