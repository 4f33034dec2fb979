#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

/// The first directory of a TIFF file.
namespace striate::datasets {

/// ImageBytes with bounds: what lies behind the end reads as zero.
class ImageBytes {
 public:
  explicit ImageBytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  [[nodiscard]] std::size_t size() const { return bytes_.size(); }
  [[nodiscard]] std::uint32_t at(std::size_t i) const { return i < size() ? bytes_[i] : 0U; }
  [[nodiscard]] std::uint32_t big16(std::size_t i) const { return at(i) << 8 | at(i + 1); }
  [[nodiscard]] std::uint32_t big32(std::size_t i) const { return big16(i) << 16 | big16(i + 2); }
  [[nodiscard]] std::uint32_t little16(std::size_t i) const { return at(i + 1) << 8 | at(i); }
  [[nodiscard]] std::uint32_t little32(std::size_t i) const {
    return little16(i + 2) << 16 | little16(i);
  }
  [[nodiscard]] bool says(std::size_t i, std::string_view text) const {
    for (std::size_t k = 0; k < text.size(); ++k) {
      if (i + k >= size() || bytes_[i + k] != static_cast<std::uint8_t>(text[k])) return false;
    }
    return true;
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

/// What a TIFF directory says, in a TIFF file or in the EXIF of another one.
struct TiffDirectory {
  std::int64_t width_px = 0;
  std::int64_t height_px = 0;
  int orientation = 1;
};

/// The first directory of the TIFF structure that begins at `start`.
[[nodiscard]] TiffDirectory tiff_directory(const ImageBytes& bytes, std::size_t start);

}  // namespace striate::datasets
