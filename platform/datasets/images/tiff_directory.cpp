#include "striate/platform/datasets/images/tiff_directory.hpp"

#include <algorithm>
#include <cstddef>

#include "striate/base/crc_table.hpp"

namespace striate::datasets {

TiffDirectory tiff_directory(const ImageBytes& bytes, std::size_t start) {
  const bool little = bytes.says(start, "II");
  const auto two = [&](std::size_t i) { return little ? bytes.little16(i) : bytes.big16(i); };
  const auto four = [&](std::size_t i) { return little ? bytes.little32(i) : bytes.big32(i); };
  // TIFF 6.0 tags ImageWidth, ImageLength and Orientation, type SHORT
  constexpr std::uint32_t kWidth = 256, kHeight = 257, kOrientation = 274, kShort = 3;
  TiffDirectory found;
  if (!little && !bytes.says(start, "MM")) return found;
  const std::size_t directory = start + four(start + 4);
  for (std::size_t entry = 0; entry < two(directory); ++entry) {
    const std::size_t at = directory + 2 + 12 * entry;
    if (at + 12 > bytes.size()) break;
    const std::int64_t value = two(at + 2) == kShort ? two(at + 8) : four(at + 8);
    // The larger one where a tag stands twice: decoders differ in which they take.
    if (two(at) == kWidth) found.width_px = std::max(found.width_px, value);
    if (two(at) == kHeight) found.height_px = std::max(found.height_px, value);
    if (two(at) == kOrientation && value >= 1 && value <= 8) {
      found.orientation = static_cast<int>(value);
    }
  }
  return found;
}

}  // namespace striate::datasets
