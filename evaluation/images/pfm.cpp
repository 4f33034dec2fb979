#include "striate/evaluation/images/pfm.hpp"

#include <fmt/format.h>

#include <bit>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <vector>

#include "striate/base/user_error.hpp"

namespace striate::evaluation {
namespace {

/// More than any camera's; a head that promises it is damaged (as in read_image.cpp)
constexpr long kLongestSide_px = 16384;
/// 40 million: 160 MB as floats; a head that promises more is damaged
constexpr long kMostPixels = 40'000'000;

[[noreturn]] void refuse(const std::string& name, const std::string& why) {
  throw UserError(fmt::format("{}: {}; a grey PFM file is needed", name, why));
}

/// One word of the header, of bounded length, and the one blank behind it.
std::string word(std::istream& in) {
  std::string text;
  int c = in.get();
  for (int skipped = 0; skipped < 64 && c != EOF && std::isspace(c) != 0; ++skipped) c = in.get();
  while (c != EOF && std::isspace(c) == 0 && text.size() < 32) {
    text += static_cast<char>(c);
    c = in.get();
  }
  return text;
}

long side(std::istream& in, const std::string& name) {
  const std::string text = word(in);
  char* end = nullptr;
  const long value = std::strtol(text.c_str(), &end, 10);
  if (text.empty() || *end != '\0' || value < 1) refuse(name, "its width or height is no number");
  if (value > kLongestSide_px) refuse(name, "is larger than 16384 px");
  return value;
}

float decoded(std::uint32_t bits, bool little_endian) {
  if (little_endian != (std::endian::native == std::endian::little)) bits = __builtin_bswap32(bits);
  const auto value = std::bit_cast<float>(bits);
  return std::isnan(value) ? std::numeric_limits<float>::infinity() : value;
}

}  // namespace

cv::Mat1f read_pfm(std::istream& in, const std::string& name) {
  const std::string kind = word(in);
  if (kind == "PF") refuse(name, "has three channels");
  if (kind != "Pf") refuse(name, "does not begin with Pf");
  const long width = side(in, name);
  const long height = side(in, name);
  if (width * height > kMostPixels) refuse(name, "has more than 40 million pixels");
  const std::string scale_text = word(in);
  char* end = nullptr;
  const double scale = std::strtod(scale_text.c_str(), &end);
  if (scale_text.empty() || *end != '\0' || !std::isfinite(scale) || scale == 0.0) {
    refuse(name, "its scale is no number, or zero");
  }
  std::vector<std::uint32_t> row(static_cast<std::size_t>(width));
  const auto bytes = static_cast<std::streamsize>(row.size() * sizeof(std::uint32_t));
  cv::Mat1f values(static_cast<int>(height), static_cast<int>(width));
  for (int v = static_cast<int>(height) - 1; v >= 0; --v) {
    if (!in.read(reinterpret_cast<char*>(row.data()), bytes)) refuse(name, "ends too early");
    for (int u = 0; u < values.cols; ++u) {
      values(v, u) = decoded(row[static_cast<std::size_t>(u)], scale < 0.0);
    }
  }
  return values;
}

cv::Mat1f read_pfm(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) refuse(file.string(), "is no file");
  std::ifstream in(file, std::ios::binary);
  if (!in) refuse(file.string(), "cannot be opened");
  return read_pfm(in, file.string());
}

}  // namespace striate::evaluation
