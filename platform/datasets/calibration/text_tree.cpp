#include "striate/platform/datasets/calibration/text_tree.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string_view>

#include "striate/base/plain_text.hpp"
#include "striate/config/yaml.hpp"
#include "striate/platform/datasets/calibration/xml_tree.hpp"

namespace striate::datasets {
namespace {

using config::Node;

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

/// OpenCV's `%YAML:1.0` is no directive of YAML, and its tags say nothing that the keys do not:
/// blanks take their place, so that every place in the text stays where it was.
std::string without_opencv_marks(std::string text) {
  if (text.starts_with("%YAML")) {
    for (std::size_t k = 0; k < text.size() && text[k] != '\n'; ++k) text[k] = ' ';
  }
  for (const std::string_view tag : {"!!opencv-matrix", "!!opencv-nd-matrix", "!!float", "!!int"}) {
    for (std::size_t at = text.find(tag); at != std::string::npos; at = text.find(tag, at)) {
      text.replace(at, tag.size(), tag.size(), ' ');
    }
  }
  return text;
}

/// `rostopic echo` ends each message with a line `---`, and may have written more of them.
std::string first_document(const std::string& text) {
  bool begun = false;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line(text.data() + at, end - at);
    const bool mark = line.starts_with("---") || line.starts_with("...");
    if (mark && begun) return text.substr(0, at);
    const std::size_t first = line.find_first_not_of(" \t");
    if (!mark && first != std::string_view::npos && line[first] != '#') begun = true;
    at = end + 1;
  }
  return text;
}

void add_words(const Node& node, const std::string& what, config::Diagnostics& diagnostics,
               std::vector<double>& numbers) {
  const std::string_view text = node.text;
  for (std::size_t at = 0; at < text.size();) {
    if (is_blank(text[at]) || text[at] == ',' || text[at] == ';') {
      ++at;
      continue;
    }
    std::size_t end = at;
    while (end < text.size() && !is_blank(text[end]) && text[end] != ',' && text[end] != ';') ++end;
    const auto number = number_of(text.substr(at, end - at));
    if (!number) {
      diagnostics.add(config::fault::no_number, node.place,
                      fmt::format("'{}' is no number",
                                  plain_text(text.substr(at, std::min<std::size_t>(end - at, 40)))),
                      fmt::format("{} must be finite numbers", what));
      return;
    }
    numbers.push_back(*number);
    at = end;
  }
}

void add_numbers(const Node& node, const std::string& what, config::Diagnostics& diagnostics,
                 std::vector<double>& numbers) {
  const std::size_t before = diagnostics.count();
  if (node.kind == Node::Kind::scalar) add_words(node, what, diagnostics, numbers);
  for (const Node& item : node.items) {
    add_numbers(item, what, diagnostics, numbers);
    if (diagnostics.count() != before) return;
  }
  if (node.kind != Node::Kind::map) return;
  if (const Node::Entry* data = node.find("data")) {
    add_numbers(data->value, what, diagnostics, numbers);
    return;
  }
  for (const Node::Entry& entry : node.entries) {
    add_numbers(entry.value, what, diagnostics, numbers);
    if (diagnostics.count() != before) return;
  }
}

}  // namespace

std::string plain_line_ends(const std::string& text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";  // UTF-8's mark of byte order
  std::string plain;
  plain.reserve(text.size());
  for (std::size_t k = text.starts_with(kMark) ? kMark.size() : 0; k < text.size(); ++k) {
    if (text[k] != '\r') {
      plain += text[k];
    } else if (k + 1 >= text.size() || text[k + 1] != '\n') {
      plain += '\n';  // old Macs
    }
  }
  return plain;
}

Node read_tree(const std::string& given, config::Diagnostics& diagnostics) {
  const std::string text = plain_line_ends(given);
  const std::size_t first = text.find_first_not_of(" \t\n");
  if (first != std::string::npos && text[first] == '<') return read_xml(text, diagnostics);
  return config::parse_yaml(first_document(without_opencv_marks(text)), diagnostics);
}

std::optional<double> number_of(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return {};
  return value;
}

std::vector<double> numbers_of(const Node& node, const std::string& what,
                               config::Diagnostics& diagnostics) {
  std::vector<double> numbers;
  add_numbers(node, what, diagnostics, numbers);
  return numbers;
}

const Node* first_of(const Node& map, const std::vector<std::string>& keys) {
  for (const std::string& key : keys) {
    if (const Node::Entry* entry = map.find(key)) return &entry->value;
  }
  return nullptr;
}

std::string keys_of(const Node& map, std::size_t most) {
  std::string text;
  for (std::size_t k = 0; k < map.entries.size() && k < most; ++k) {
    text += (k > 0 ? ", " : "") + plain_text(map.entries[k].key.substr(0, 40));
  }
  if (map.entries.size() > most) text += ", ...";
  return text;
}

}  // namespace striate::datasets
