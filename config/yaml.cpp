#include "striate/config/yaml.hpp"

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
  std::istringstream stream(text);
  TreeBuilder builder(text, diagnostics);
  try {
    YAML::Parser parser(stream);
    if (!parser.HandleNextDocument(builder)) {
      diagnostics.add(fault::unreadable, {}, "the file is empty");
      return {};
    }
    Node root = builder.take();
    TreeBuilder second(text, diagnostics);
    if (parser.HandleNextDocument(second)) {
      diagnostics.add(fault::not_allowed, second.take().place, "a second YAML document begins here",
                      "keep one document in a file: remove the line ---");
    }
    return root;
  } catch (const YAML::Exception& error) {
    diagnostics.add(fault::unreadable, place_of(error.mark), "not readable as YAML: " + error.msg,
                    "look at indentation, colons and brackets here and in the line before");
  } catch (const GiveUp&) {
    return {};
  }
  return {};
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
