#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace striate::datasets {

/// What the first bytes of an image file promise, and whether the file keeps it.
struct ImageHeader {
  std::int64_t width_px = 0;  ///< as written there; 0 where the header does not say
  std::int64_t height_px = 0;
  bool floating = false;  ///< PFM, Radiance HDR or OpenEXR: no 8 or 16 bit pixels
  bool whole = true;      ///< false: the file ends too early, or a checksum is wrong
  int orientation = 1;    ///< as EXIF and TIFF count, 1 to 8; 1: the pixels stand upright
  int most = 0;           ///< the value of white where the header tells it (PNM); 0: it does not
  bool binary = true;     ///< false: PNM of numbers as text, whose decoders stretch up to 255
};

/// Reads the header of a PNG, JPEG, PNM (P1 to P6), BMP, TIFF or WebP file, so that sizes are
/// judged before any memory is taken for pixels, and files that were cut off are found, of which
/// decoders show what there is without a word. Nothing for what is none of them. Any bytes will do.
///
/// What is checked: PNG: every chunk's length and checksum up to IEND; JPEG: the segments up to the
/// end marker; binary PNM and uncompressed BMP: bytes enough; WebP: the length it tells. Of the
/// others cut-off files are left to the decoder. The orientation is read from JPEG, PNG, TIFF and
/// WebP.
[[nodiscard]] std::optional<ImageHeader> read_image_header(std::span<const std::uint8_t> bytes);

}  // namespace striate::datasets
