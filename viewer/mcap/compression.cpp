#include "striate/viewer/mcap/compression.hpp"

#include <fmt/format.h>
#include <lz4frame.h>
#include <zstd.h>

#include <algorithm>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>

namespace striate::viewer::mcap {
namespace {

/// By hand: the images are PNG already, so that more effort is lost on them.
constexpr int kZstdLevel = 1;

Bytes compress_by_zstd(ByteView bytes) {
  Bytes smaller(ZSTD_compressBound(bytes.size()));
  const std::size_t size =
      ZSTD_compress(smaller.data(), smaller.size(), bytes.data(), bytes.size(), kZstdLevel);
  if (ZSTD_isError(size) != 0) throw std::runtime_error(ZSTD_getErrorName(size));
  smaller.resize(size);
  return smaller;
}

Bytes compress_by_lz4(ByteView bytes) {
  LZ4F_preferences_t preferences{};
  preferences.frameInfo.contentSize = bytes.size();
  Bytes smaller(LZ4F_compressFrameBound(bytes.size(), &preferences));
  const std::size_t size =
      LZ4F_compressFrame(smaller.data(), smaller.size(), bytes.data(), bytes.size(), &preferences);
  if (LZ4F_isError(size) != 0) throw std::runtime_error(LZ4F_getErrorName(size));
  smaller.resize(size);
  return smaller;
}

void decompress_by_zstd(ByteView bytes, Bytes& to) {
  const std::size_t size = ZSTD_decompress(to.data(), to.size(), bytes.data(), bytes.size());
  if (ZSTD_isError(size) != 0) {
    throw BadBytes(fmt::format("zstd cannot read it: {}", ZSTD_getErrorName(size)));
  }
  if (size != to.size()) throw BadBytes("zstd makes fewer bytes of it than was promised");
}

void decompress_by_lz4(ByteView bytes, Bytes& to) {
  LZ4F_dctx* made = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&made, LZ4F_VERSION)) != 0) {
    throw std::bad_alloc();
  }
  const std::unique_ptr<LZ4F_dctx, LZ4F_errorCode_t (*)(LZ4F_dctx*)> context(
      made, LZ4F_freeDecompressionContext);
  std::size_t read = 0;
  std::size_t written = 0;
  std::size_t wants = 1;  // bytes still expected; 0: the frame has ended
  while (wants != 0) {
    std::size_t out = to.size() - written;
    std::size_t in = bytes.size() - read;
    wants = LZ4F_decompress(context.get(), to.data() + written, &out, bytes.data() + read, &in,
                            nullptr);
    if (LZ4F_isError(wants) != 0) {
      throw BadBytes(fmt::format("lz4 cannot read it: {}", LZ4F_getErrorName(wants)));
    }
    if (in == 0 && out == 0 && wants != 0) throw BadBytes("lz4 cannot read it to its end");
    read += in;
    written += out;
  }
  if (written != to.size()) throw BadBytes("lz4 makes fewer bytes of it than was promised");
}

}  // namespace

std::string_view name_in_file(Compression compression) {
  switch (compression) {
    case Compression::zstd:
      return "zstd";
    case Compression::lz4:
      return "lz4";
    case Compression::none:
      break;
  }
  return "";
}

Compression compression_of(std::string_view word) {
  if (word == "none") return Compression::none;
  if (word == "zstd") return Compression::zstd;
  if (word == "lz4") return Compression::lz4;
  throw std::invalid_argument("no such compression");
}

Bytes compress(ByteView bytes, Compression compression) {
  switch (compression) {
    case Compression::zstd:
      return compress_by_zstd(bytes);
    case Compression::lz4:
      return compress_by_lz4(bytes);
    case Compression::none:
      break;
  }
  return {bytes.begin(), bytes.end()};
}

void decompress(ByteView bytes, std::string_view name, std::uint64_t size, Bytes& to) {
  const bool known = name.empty() || name == "zstd" || name == "lz4";
  if (!known) throw BadBytes("an unknown compression");
  if (name.empty() && size != bytes.size()) throw BadBytes("it has not the size that was promised");
  to.resize(size);
  if (name == "zstd") {
    decompress_by_zstd(bytes, to);
  } else if (name == "lz4") {
    decompress_by_lz4(bytes, to);
  } else {
    std::copy(bytes.begin(), bytes.end(), to.begin());
  }
}

}  // namespace striate::viewer::mcap
