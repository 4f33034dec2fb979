#include "striate/config/yaml.hpp"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "striate/config/tree_builder.hpp"

namespace striate::config {
namespace {

/// 1 MB: three hundred times the largest file that ships; more is no configuration (ours)
constexpr std::size_t kMaxBytes = 1'000'000;

/// Reads events and keeps nothing.
class Nothing final : public YAML::EventHandler {
 public:
  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t,
                const std::string&) override {}
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {}
  void OnMapEnd() override {}
};

/// The library takes the end of the file for a closing quote where a line break stands before it.
/// After a comment it does not, and a comment changes nothing else.
bool ends_within_quotes(const std::string& text) {
  std::istringstream stream(text + "\n#");
  Nothing nothing;
  try {
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(nothing)) {
    }
  } catch (const YAML::Exception& error) {
    return error.msg == YAML::ErrorMsg::EOF_IN_SCALAR;
  }
  return false;
}

/// What the parser stumbles over may be far behind the mistake: a missing quote makes the next
/// opening one close the text.
std::string hint_for(const YAML::Exception& error, SourceLocation last_quoted) {
  if (last_quoted.line > 0 && last_quoted.line < error.mark.line + 1) {
    return fmt::format(
        "look at the quotes of the text that begins in line {}, and at indentation, "
        "colons and brackets here and in the line before",
        last_quoted.line);
  }
  return "look at indentation, colons and brackets here and in the line before";
}

void tell_unclosed_quote(SourceLocation quote, Diagnostics& diagnostics) {
  diagnostics.add(fault::unreadable, quote, "this quote is not closed: all that follows is text",
                  "put the closing quote at the end of the text");
}

Node read_documents(const std::string& text, Diagnostics& diagnostics) {
  // Without the last line break the library tells an open quote by its end, not by its beginning.
  std::istringstream stream(text.ends_with('\n') ? text : text + "\n");
  TreeBuilder builder(text, diagnostics);
  TreeBuilder second(text, diagnostics);
  const auto ends_in_quote = [&](SourceLocation& quote) {
    quote = second.last_quoted().line > 0 ? second.last_quoted() : builder.last_quoted();
    return quote.line > 0 && ends_within_quotes(text);
  };
  SourceLocation quote;
  try {
    YAML::Parser parser(stream);
    if (!parser.HandleNextDocument(builder)) {
      diagnostics.add(fault::unreadable, {}, "the file is empty");
      return {};
    }
    Node root = builder.take();
    const bool more = parser.HandleNextDocument(second);
    if (ends_in_quote(quote)) {
      tell_unclosed_quote(quote, diagnostics);
      return {};
    }
    if (more) {
      diagnostics.add(fault::not_allowed, second.take().place, "a second YAML document begins here",
                      "keep one document in a file: remove the line ---");
    }
    return root;
  } catch (const YAML::Exception& error) {
    if (ends_in_quote(quote)) {
      tell_unclosed_quote(quote, diagnostics);
    } else {
      diagnostics.add(fault::unreadable, place_of(error.mark), "not readable as YAML: " + error.msg,
                      hint_for(error, quote));
    }
  }
  return {};
}

}  // namespace

Node parse_yaml(const std::string& text, Diagnostics& diagnostics) {
  diagnostics.set_source(text);
  if (text.size() > kMaxBytes) {
    diagnostics.add(fault::unreadable, {}, "the file is larger than 1 MB",
                    "configuration files are small; split it");
    return {};
  }
  if (text.find('\0') != std::string::npos) {
    diagnostics.add(fault::unreadable, {}, "the file holds zero bytes: it is no text file");
    return {};
  }
  try {
    return read_documents(text, diagnostics);
  } catch (const GiveUp&) {
    return {};
  }
}

Node load_yaml(Diagnostics& diagnostics) {
  const std::filesystem::path path(diagnostics.file());
  std::error_code code;
  if (!std::filesystem::exists(path, code)) {
    diagnostics.add(fault::unreadable, {}, "there is no such file",
                    "look at the path; it is relative to where you are");
    return {};
  }
  if (!std::filesystem::is_regular_file(path, code)) {
    diagnostics.add(fault::unreadable, {}, "this is no file", "give the path of a YAML file");
    return {};
  }
  std::ifstream stream(path, std::ios::binary);
  std::string text(kMaxBytes + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad() || !stream.is_open()) {
    diagnostics.add(fault::unreadable, {}, "the file cannot be read", "look at its permissions");
    return {};
  }
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return parse_yaml(text, diagnostics);
}

}  // namespace striate::config
