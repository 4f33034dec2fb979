#pragma once

#include <cstddef>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string>

namespace striate::remote {

/// The fields of a sensor_msgs/Image, not copied.
struct RawImage {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint32_t step = 0;  ///< bytes of a row
  bool big_endian = false;
  std::string encoding;  ///< as in sensor_msgs/image_encodings.h
  const std::uint8_t* data = nullptr;
  std::size_t size = 0;
};

/// A BGR image of its own memory. Understands mono8, mono16, bgr8, rgb8, bgra8, rgba8, 8UC1, 8UC3
/// and the four bayer_*8. @param bits of the camera's pixels, where the encoding has 16: as many as
/// were used in any image so far, which this one may raise; 8 at first. @throws std::runtime_error
/// for other encodings and for sizes that do not agree with the data.
[[nodiscard]] cv::Mat3b decode(const RawImage& image, int& bits);

/// A BGR image from JPEG or PNG bytes. @param bits as above. @throws std::runtime_error where they
/// are none, or tell of a size that no camera has: a few bytes may promise gigabytes.
[[nodiscard]] cv::Mat3b decode_compressed(const std::uint8_t* data, std::size_t size, int& bits);

}  // namespace striate::remote
