#pragma once

#include <opencv2/core/mat.hpp>

#include "striate/base/bytes.hpp"

/// An image within a recording's cycle: its size, and its pixels as PNG.
namespace striate::replay {

/// Writes an image of 8-bit BGR; an empty one as 0 x 0 without bytes.
void put_image(ByteWriter& writer, const cv::Mat3b& image);

/// Reads it back. The size is compared with what the PNG's own head says before any memory is taken
/// for pixels. @throws BadBytes where the bytes are no such image
[[nodiscard]] cv::Mat3b take_image(ByteReader& reader);

}  // namespace striate::replay
