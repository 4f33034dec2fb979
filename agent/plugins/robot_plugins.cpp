#include "striate/agent/plugins/robot_plugins.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <string_view>
#include <utility>

#include "striate/agent/plugins/load_plugin.hpp"
#include "striate/base/user_error.hpp"
#include "striate/config/map_reader.hpp"

namespace striate::agent {
namespace {

namespace fs = std::filesystem;
using config::Node;

/// Between what is wrong with a plugin and how to mend it.
constexpr std::string_view kHint = "\n  hint: ";

/// Takes one key out of a map. @return the entry with nothing in it where there is none
Node::Entry take(Node& map, const std::string& key) {
  for (auto entry = map.entries.begin(); entry != map.entries.end(); ++entry) {
    if (entry->key != key) continue;
    Node::Entry taken = std::move(*entry);
    map.entries.erase(entry);
    return taken;
  }
  return {};
}

void load(const Node& list, config::Diagnostics& diagnostics) {
  const fs::path folder = fs::path(diagnostics.file()).parent_path();
  for (const Node& item : list.items) {
    if (item.kind != Node::Kind::scalar) {
      diagnostics.add(item.place,
                      fmt::format("a plugin is a file, but this is {}", item.describe()));
      continue;
    }
    try {
      use_plugin((folder / item.text).string());
    } catch (const UserError& error) {
      const std::string text = error.what();
      const std::size_t hint = text.find(kHint);
      diagnostics.add(item.place, text.substr(0, hint),
                      hint == std::string::npos ? "" : text.substr(hint + kHint.size()));
    }
  }
}

NamedBody named_in(const Node& body, config::Diagnostics& diagnostics) {
  if (body.kind == Node::Kind::nothing) return {};
  if (body.kind == Node::Kind::scalar) return {body.text, body.place, {}};
  if (body.kind == Node::Kind::map && body.entries.size() == 1) {
    const Node::Entry& entry = body.entries.front();
    return {entry.key, entry.key_place, entry.value};
  }
  diagnostics.add(body.place, fmt::format("'body' must be one name, but is {}", body.describe()),
                  "write 'body: NAME', or 'body: {NAME: {...}}' with its settings");
  return {};
}

void check(const NamedBody& body, config::Diagnostics& diagnostics) {
  if (const BodyEntry* entry = body_registry().find(body.name)) {
    (void)entry->settings(body.settings, diagnostics);
    return;
  }
  std::vector<std::string> names{"pioneer"};
  for (const BodyEntry& known : body_registry()) names.push_back(known.name);
  std::string hint = config::suggest(body.name, names);
  if (hint.empty()) hint = "name the plugin that has it in 'plugins', or with --plugin";
  diagnostics.add(body.place, fmt::format("unknown body '{}'", body.name), hint);
}

}  // namespace

NamedBody take_plugins(Node& robot, config::Diagnostics& diagnostics, PluginLines lines) {
  const Node::Entry plugins = take(robot, "plugins");
  if (!plugins.key.empty() && plugins.value.kind != Node::Kind::list) {
    diagnostics.add(plugins.value.place, "'plugins' must be a list of files",
                    "write 'plugins: [FILE.so]'");
  } else if (lines == PluginLines::load) {
    load(plugins.value, diagnostics);
  }
  NamedBody body = named_in(take(robot, "body").value, diagnostics);
  // What is missing since its plugin was refused is not told as well.
  if (body.name == "pioneer" || !diagnostics.none()) return {};
  if (!body.name.empty()) check(body, diagnostics);
  return body;
}

std::vector<config::SettingLine> settings_of(const NamedBody& body) {
  const BodyEntry* entry = body_registry().find(body.name);
  if (entry == nullptr) return {};
  config::Diagnostics unheard("");
  return entry->settings(body.settings, unheard);
}

}  // namespace striate::agent
