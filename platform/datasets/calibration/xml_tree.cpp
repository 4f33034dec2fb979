#include "striate/platform/datasets/calibration/xml_tree.hpp"

#include <fmt/format.h>

#include <string_view>

#include "striate/base/plain_text.hpp"

namespace striate::datasets {
namespace {

using config::Node;
using config::SourceLocation;

constexpr std::size_t kMostXml_bytes = 1'000'000;  // bytes, as of YAML (config/yaml.cpp)
constexpr int kDeepestXml = 32;                    // levels, as of YAML (config/tree_builder.hpp)
constexpr int kMostXmlElements = 20'000;           // elements, likewise

/// Thrown where reading on makes no sense.
struct XmlMistake {
  std::size_t at;
  std::string message;
};

class XmlReader {
 public:
  explicit XmlReader(std::string_view text) : text_(text) {}

  Node read() {
    pass_over();
    Node document;
    document.kind = Node::Kind::map;
    document.entries.push_back(element(0));
    pass_over();
    if (at_ < text_.size()) throw XmlMistake{at_, "there is text behind the root element"};
    return document;
  }
  [[nodiscard]] SourceLocation place(std::size_t at) {
    while (counted_ < at && counted_ < text_.size()) {
      if (text_[counted_] == '\n') {
        ++line_;
        line_begins_ = counted_ + 1;
      }
      ++counted_;
    }
    return {line_, static_cast<int>(at - line_begins_) + 1};
  }

 private:
  [[nodiscard]] bool says(std::string_view what) const {
    return text_.substr(at_).starts_with(what);
  }
  void skip_to(std::string_view what) {
    const std::size_t end = text_.find(what, at_);
    if (end == std::string_view::npos) {
      throw XmlMistake{at_, fmt::format("this has no end '{}'", what)};
    }
    at_ = end + what.size();
  }
  void skip_blanks() {
    while (at_ < text_.size() && std::string_view(" \t\n\r").find(text_[at_]) != text_.npos) ++at_;
  }
  /// Blanks, comments, the prolog
  void pass_over() {
    while (true) {
      skip_blanks();
      if (says("<!--")) {
        skip_to("-->");
      } else if (says("<?")) {
        skip_to("?>");
      } else if (says("<!DOCTYPE")) {
        throw XmlMistake{at_, "a document type is not read"};
      } else {
        return;
      }
    }
  }
  std::string name() {
    const std::size_t begin = at_;
    while (at_ < text_.size() &&
           std::string_view(" \t\n\r/<>=\"'").find(text_[at_]) == text_.npos) {
      ++at_;
    }
    if (at_ == begin) throw XmlMistake{at_, "the name of an element is missing"};
    return std::string(text_.substr(begin, at_ - begin));
  }
  Node::Entry element(int depth) {
    if (!says("<")) throw XmlMistake{at_, "an element <...> is expected"};
    if (depth > kDeepestXml || ++elements_ > kMostXmlElements) {
      throw XmlMistake{at_, "there are too many elements, or they lie too deep"};
    }
    Node::Entry entry;
    entry.key_place = place(at_);
    ++at_;
    entry.key = name();
    const std::size_t begin = at_;
    const std::size_t end = text_.find('>', at_);
    if (end == std::string_view::npos) throw XmlMistake{begin, "this element is not closed"};
    at_ = end + 1;
    entry.value.place = place(at_);
    if (text_[end - 1] == '/') return entry;
    contents(entry, depth);
    return entry;
  }
  void contents(Node::Entry& entry, int depth) {
    std::string words;
    while (true) {
      if (at_ >= text_.size()) {
        throw XmlMistake{at_, fmt::format("<{}> is not closed", plain_text(entry.key))};
      }
      if (says("<!--")) {
        skip_to("-->");
      } else if (says("</")) {
        close(entry, words);
        return;
      } else if (says("<")) {
        entry.value.kind = Node::Kind::map;
        entry.value.entries.push_back(element(depth + 1));
      } else {
        words += text_[at_++];
      }
    }
  }
  void close(Node::Entry& entry, const std::string& words) {
    const std::size_t begin = at_;
    at_ += 2;
    const std::string closed = name();
    if (closed != entry.key) {
      throw XmlMistake{begin,
                       fmt::format("</{}> closes <{}>", plain_text(closed), plain_text(entry.key))};
    }
    skip_blanks();
    if (!says(">")) throw XmlMistake{at_, "'>' is missing"};
    ++at_;
    if (entry.value.kind == Node::Kind::map) return;
    const std::size_t first = words.find_first_not_of(" \t\n\r");
    if (first == std::string::npos) return;
    entry.value.kind = Node::Kind::scalar;
    entry.value.text = words.substr(first, words.find_last_not_of(" \t\n\r") - first + 1);
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t counted_ = 0;  ///< up to here lines are counted
  std::size_t line_begins_ = 0;
  int line_ = 1;
  int elements_ = 0;
};

}  // namespace

Node read_xml(const std::string& text, config::Diagnostics& diagnostics) {
  diagnostics.set_source(text);
  if (text.size() > kMostXml_bytes) {
    diagnostics.add(config::fault::unreadable, {}, "the file is larger than 1 MB");
    return {};
  }
  XmlReader reader(text);
  try {
    return reader.read();
  } catch (const XmlMistake& mistake) {
    diagnostics.add(config::fault::unreadable, XmlReader(text).place(mistake.at),
                    "not readable as XML: " + mistake.message);
    return {};
  }
}

}  // namespace striate::datasets
