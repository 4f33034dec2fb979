#include "striate/platform/remote/image_codec.hpp"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "striate/platform/interface/pixel_range.hpp"

namespace striate::remote {
namespace {

/// No camera has more; a message that promises it is damaged (ours)
constexpr std::uint32_t kMostPixelsASide = 16384;

/// By hand: three times the largest of today's industrial cameras, 200 MB of colours
constexpr std::uint64_t kMostPixels = 67'108'864;

struct Encoding {
  const char* name;
  int cv_type;
  int to_bgr;  ///< a cv::ColorConversionCodes; kAsItIs: BGR already
};
constexpr int kAsItIs = -1;  ///< no cv::ColorConversionCodes has it

// OpenCV names a Bayer pattern by its second row, ROS by its first.
constexpr Encoding kEncodings[] = {
    {"bgr8", CV_8UC3, kAsItIs},
    {"8UC3", CV_8UC3, kAsItIs},
    {"rgb8", CV_8UC3, cv::COLOR_RGB2BGR},
    {"bgra8", CV_8UC4, cv::COLOR_BGRA2BGR},
    {"rgba8", CV_8UC4, cv::COLOR_RGBA2BGR},
    {"mono8", CV_8UC1, cv::COLOR_GRAY2BGR},
    {"8UC1", CV_8UC1, cv::COLOR_GRAY2BGR},
    {"mono16", CV_16UC1, cv::COLOR_GRAY2BGR},
    {"bayer_rggb8", CV_8UC1, cv::COLOR_BayerBG2BGR},
    {"bayer_bggr8", CV_8UC1, cv::COLOR_BayerRG2BGR},
    {"bayer_gbrg8", CV_8UC1, cv::COLOR_BayerGR2BGR},
    {"bayer_grbg8", CV_8UC1, cv::COLOR_BayerGB2BGR},
};

const Encoding& encoding_of(const std::string& name) {
  for (const Encoding& one : kEncodings) {
    if (name == one.name) return one;
  }
  throw std::runtime_error("images of the encoding '" + name + "' are not understood");
}

/// Grey values of 16 bits in this machine's order, little-endian as all that ROS 1 runs on.
cv::Mat ordered(const cv::Mat& words, bool big_endian) {
  if (!big_endian) return words;
  cv::Mat turned(words.size(), CV_16UC1);
  for (int v = 0; v < words.rows; ++v) {
    const std::uint8_t* from = words.ptr(v);
    for (int u = 0; u < words.cols; ++u) {
      turned.at<std::uint16_t>(v, u) =
          static_cast<std::uint16_t>(from[2 * u] << 8U | from[2 * u + 1]);
    }
  }
  return turned;
}

std::uint64_t big_endian(const std::uint8_t* from, int bytes) {
  std::uint64_t value = 0;
  for (int i = 0; i < bytes; ++i) value = value << 8U | from[i];
  return value;
}

/// The pixels that a JPEG or PNG tells of in its head, before anything of it is decoded; none where
/// it is neither. PNG: ISO 15948, 11.2.2; JPEG: ITU T.81, B.2.2.
std::uint64_t pixels_told(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kPngHead = 24;  // bytes: signature, and IHDR up to the height
  if (size >= kPngHead && big_endian(data, 4) == 0x89504E47) {
    return big_endian(data + 16, 4) * big_endian(data + 20, 4);
  }
  if (size < 4 || big_endian(data, 2) != 0xFFD8) return 0;
  for (std::size_t at = 2; at + 9 <= size && data[at] == 0xFF;) {
    const std::uint8_t marker = data[at + 1];
    const bool is_frame =
        marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
    if (is_frame) return big_endian(data + at + 5, 2) * big_endian(data + at + 7, 2);
    at += marker == 0xFF ? 1 : 2 + static_cast<std::size_t>(big_endian(data + at + 2, 2));
  }
  return 0;
}

/// With 8 bits a channel. A camera of 12 bits leaves the upper four of 16 empty.
cv::Mat shown(const cv::Mat& image, int& bits) {
  if (image.depth() != CV_16U) return image;
  bits = std::max(bits, bits_used(image));
  return as_eight_bits(image, most_of_bits(bits));
}

}  // namespace

cv::Mat3b decode(const RawImage& image, int& bits) {
  const Encoding& encoding = encoding_of(image.encoding);
  const std::size_t row = static_cast<std::size_t>(image.width) * CV_ELEM_SIZE(encoding.cv_type);
  const bool possible = image.width > 0 && image.height > 0 && image.width <= kMostPixelsASide &&
                        image.height <= kMostPixelsASide && image.step >= row &&
                        image.size / image.step >= image.height;
  if (!possible) throw std::runtime_error("an image whose size does not agree with its data");
  // OpenCV only reads through this view.
  cv::Mat view(static_cast<int>(image.height), static_cast<int>(image.width), encoding.cv_type,
               const_cast<std::uint8_t*>(image.data), image.step);
  if (encoding.cv_type == CV_16UC1) view = shown(ordered(view, image.big_endian), bits);
  cv::Mat3b bgr;
  if (encoding.to_bgr == kAsItIs) {
    view.copyTo(bgr);
  } else {
    cv::cvtColor(view, bgr, encoding.to_bgr);
  }
  return bgr;
}

cv::Mat3b decode_compressed(const std::uint8_t* data, std::size_t size, int& bits) {
  cv::Mat image;
  const std::uint64_t told = pixels_told(data, size);
  if (told > kMostPixels) throw std::runtime_error("a compressed image that is far too large");
  if (told > 0 && size < (std::size_t{1} << 30)) {
    const cv::Mat bytes(1, static_cast<int>(size), CV_8UC1, const_cast<std::uint8_t*>(data));
    image = cv::imdecode(bytes, cv::IMREAD_COLOR | cv::IMREAD_ANYDEPTH);
  }
  if (image.empty()) throw std::runtime_error("a compressed image that is no JPEG or PNG");
  return shown(image, bits);
}

}  // namespace striate::remote
