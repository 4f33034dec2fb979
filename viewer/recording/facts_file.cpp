#include "striate/viewer/recording/facts_file.hpp"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "striate/base/user_error.hpp"
#include "striate/base/version.hpp"

namespace striate::viewer {
namespace {

mcap::WriterOptions writer_options(mcap::Compression compression) {
  mcap::WriterOptions options;
  options.library = std::string("striate ") + kVersion;
  options.compression = compression;
  return options;
}

ByteView bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

mcap::TextMap metadata_of(const replay::RecordedSetup& setup) {
  mcap::TextMap map{{"software", setup.software},
                    {"task", setup.task},
                    {"world", setup.world},
                    {"seed", std::to_string(setup.seed)},
                    {"emergency_layer", setup.emergency_layer ? "on" : "off"},
                    {"clock", "nanoseconds since the body started"}};
  for (const auto& [name, value] : setup.variables) map["var." + name] = value;
  return map;
}

}  // namespace

FactsFile::FactsFile(const std::string& file, mcap::Compression compression,
                     const replay::RecordedSetup& setup, const tasks::Task& task) try
    : sink_(file),
      writer_([this](ByteView piece) { sink_.write(piece); }, writer_options(compression)),
      channels_(setup.robot, task) {
  write_head(setup);
} catch (const UserError&) {
  throw;
} catch (const std::exception& error) {
  throw UserError(fmt::format("{}: cannot be written: {}", file, error.what()));
}

void FactsFile::write_head(const replay::RecordedSetup& setup) {
  writer_.add_metadata("striate", metadata_of(setup));
  const auto attach = [this](const std::string& name, const char* type, ByteView data) {
    writer_.attach({0, 0, name, type, data});
  };
  for (const auto& [name, text] : setup.task_files) {
    attach("task/" + name, "application/yaml", bytes_of(text));
  }
  if (!setup.robot_file.empty()) {
    attach("robot.yaml", "application/yaml", bytes_of(setup.robot_text));
  }
  std::string settings;
  for (const auto& [key, value] : setup.settings) settings += fmt::format("{} {}\n", key, value);
  attach("settings.txt", "text/plain", bytes_of(settings));
  if (!setup.memory.empty()) attach("memory.db", "application/vnd.sqlite3", setup.memory);

  std::map<std::string, std::uint16_t> schemas;
  for (const ChannelInfo& channel : channel_list()) {
    auto [schema, is_new] = schemas.try_emplace(channel.schema_name, 0);
    if (is_new) {
      schema->second =
          writer_.add_schema(channel.schema_name, channel.schema_encoding, channel.schema);
    }
    ids_.push_back(writer_.add_channel(schema->second, channel.name, channel.encoding));
  }
}

void FactsFile::add(const CycleFacts& facts) {
  const std::uint64_t before = bytes();
  channels_.publish(facts, [this](Topic topic, std::uint64_t log_time_ns, ByteView message) {
    writer_.write(ids_[static_cast<std::size_t>(topic)], log_time_ns, message);
  });
  // A chunk that ended in this cycle holds all of those before.
  if (bytes() > before) whole_ = added_;
  ++added_;
}

void FactsFile::close() {
  writer_.close();
  sink_.close();
  whole_ = added_;
}

}  // namespace striate::viewer
