#include <memory>
#include <sstream>

#include "striate/base/user_error.hpp"
#include "striate/viewer/mcap/mcap_reader.hpp"
#include "striate/viewer/mcap/mcap_writer.hpp"
#include "tests/fuzz/fuzz_target.hpp"

using namespace striate;
using namespace striate::viewer;

/// The whole file, with checksums and without.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    mcap::Reader reader(
        std::make_unique<std::istringstream>(std::string(data, data + size), std::ios::binary),
        "run.mcap");
    mcap::Message message;
    while (reader.next(message)) {
    }
    for (const mcap::AttachmentPlace& place : reader.attachments()) (void)reader.read(place);
  } catch (const UserError&) {
  }
  return 0;
}

std::vector<std::string> striate::fuzz::seeds() {
  std::vector<std::string> list;
  for (const auto compression :
       {mcap::Compression::none, mcap::Compression::zstd, mcap::Compression::lz4}) {
    for (const bool checksums : {false, true}) {
      std::string file;
      mcap::Writer writer([&file](ByteView piece) { file.append(piece.begin(), piece.end()); },
                          {.library = "fuzz",
                           .compression = compression,
                           .chunk_bytes = 200,
                           .checksums = checksums});
      const Bytes some(50, 7);
      writer.add_metadata("striate", {{"task", "corridor"}});
      const auto schema = writer.add_schema("a/msg/B", "ros2msg", "uint8[] c\n");
      for (const char* topic : {"/one", "/two"}) {
        const auto channel = writer.add_channel(schema, topic, "cdr");
        for (std::uint64_t k = 0; k < 9; ++k) writer.write(channel, k * 100, some);
      }
      writer.attach({0, 0, "task.yaml", "application/yaml", some});
      writer.close();
      list.push_back(file);
    }
  }
  return list;
}
