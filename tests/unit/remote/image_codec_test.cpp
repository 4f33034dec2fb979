#include "striate/platform/remote/image_codec.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace striate::remote {
namespace {

RawImage raw(const char* encoding, std::uint32_t width, std::uint32_t height, std::uint32_t step,
             const std::vector<std::uint8_t>& bytes) {
  RawImage image;
  image.encoding = encoding;
  image.width = width;
  image.height = height;
  image.step = step;
  image.data = bytes.data();
  image.size = bytes.size();
  return image;
}

cv::Mat3b decode(const RawImage& image) {
  int bits = 8;
  return decode(image, bits);
}

cv::Mat3b decode_compressed(const std::uint8_t* data, std::size_t size) {
  int bits = 8;
  return remote::decode_compressed(data, size, bits);
}

TEST(ImageCodec, TurnsColoursToBgrAndSkipsThePaddingOfRows) {
  const std::vector<std::uint8_t> bytes = {1, 2, 3, 99, 4, 5, 6, 99};
  const cv::Mat3b rgb = decode(raw("rgb8", 1, 2, 4, bytes));
  EXPECT_EQ(rgb(0, 0), cv::Vec3b(3, 2, 1));
  EXPECT_EQ(rgb(1, 0), cv::Vec3b(6, 5, 4));
  EXPECT_EQ(decode(raw("bgr8", 1, 2, 4, bytes))(1, 0), cv::Vec3b(4, 5, 6));
  EXPECT_EQ(decode(raw("rgba8", 1, 2, 4, bytes))(0, 0), cv::Vec3b(3, 2, 1));
  EXPECT_EQ(decode(raw("mono8", 4, 2, 4, bytes))(1, 3), cv::Vec3b(99, 99, 99));
}

TEST(ImageCodec, ReadsSixteenBitsOfEitherOrder) {
  const std::vector<std::uint8_t> bytes = {0x12, 0x34, 0x56, 0x78};
  RawImage image = raw("mono16", 2, 1, 4, bytes);
  EXPECT_EQ(decode(image)(0, 1)[0], 0x78);
  image.big_endian = true;
  EXPECT_EQ(decode(image)(0, 1)[0], 0x56);
}

TEST(ImageCodec, TwelveBitsInSixteenAreNotBlackAndTheirBitsAreRememberedForTheOtherEye) {
  const std::vector<std::uint8_t> bright = {0xff, 0x0f, 0x00, 0x08};  // 4095 and 2048
  int bits = 8;
  EXPECT_EQ(decode(raw("mono16", 2, 1, 4, bright), bits)(0, 0)[0], 255);
  EXPECT_EQ(bits, 12);
  const std::vector<std::uint8_t> dim = {0xff, 0x03, 0x00, 0x02};  // 1023 and 512
  EXPECT_EQ(decode(raw("mono16", 2, 1, 4, dim), bits)(0, 0)[0], 64);
  EXPECT_EQ(bits, 12) << "a dimmer image has no fewer";
  std::vector<std::uint8_t> png;
  cv::imencode(".png", cv::Mat1w(2, 3, std::uint16_t{4095}), png);
  EXPECT_EQ(remote::decode_compressed(png.data(), png.size(), bits)(1, 2), cv::Vec3b::all(255));
}

TEST(ImageCodec, KnowsTheFourBayerPatterns) {
  // A red scene: only the red cells of the mosaic are lit.
  const auto mosaic = [](int red_u, int red_v) {
    std::vector<std::uint8_t> bytes(64, 0);
    for (int v = red_v; v < 8; v += 2) {
      for (int u = red_u; u < 8; u += 2) bytes[static_cast<std::size_t>(8 * v + u)] = 200;
    }
    return bytes;
  };
  struct Pattern {
    const char* name;
    int red_u;
    int red_v;
  };
  for (const Pattern& p : {Pattern{"bayer_rggb8", 0, 0}, Pattern{"bayer_grbg8", 1, 0},
                           Pattern{"bayer_gbrg8", 0, 1}, Pattern{"bayer_bggr8", 1, 1}}) {
    const std::vector<std::uint8_t> bytes = mosaic(p.red_u, p.red_v);
    const cv::Vec3b colour = decode(raw(p.name, 8, 8, 8, bytes))(4, 4);
    EXPECT_EQ(colour, cv::Vec3b(0, 0, 200)) << p.name;
  }
}

TEST(ImageCodec, RefusesSizesThatDoNotAgreeWithTheData) {
  const std::vector<std::uint8_t> bytes(24, 0);
  EXPECT_NO_THROW((void)decode(raw("bgr8", 4, 2, 12, bytes)));
  EXPECT_THROW((void)decode(raw("bgr8", 4, 3, 12, bytes)), std::runtime_error);
  EXPECT_THROW((void)decode(raw("bgr8", 4, 2, 11, bytes)), std::runtime_error);
  EXPECT_THROW((void)decode(raw("bgr8", 0, 2, 12, bytes)), std::runtime_error);
  EXPECT_THROW((void)decode(raw("bgr8", 1, 4294967295u, 4294967295u, bytes)), std::runtime_error);
  EXPECT_THROW((void)decode(raw("bgr8", 4, 2, 0, bytes)), std::runtime_error);
  EXPECT_THROW((void)decode(raw("yuv422", 4, 2, 12, bytes)), std::runtime_error);
}

TEST(ImageCodec, ReadsCompressedImages) {
  cv::Mat3b image(4, 6, cv::Vec3b(10, 20, 30));
  std::vector<std::uint8_t> bytes;
  cv::imencode(".png", image, bytes);
  EXPECT_EQ(decode_compressed(bytes.data(), bytes.size())(3, 5), cv::Vec3b(10, 20, 30));
  bytes.resize(bytes.size() / 3);
  EXPECT_THROW((void)decode_compressed(bytes.data(), 10), std::runtime_error);
  EXPECT_THROW((void)decode_compressed(nullptr, 0), std::runtime_error);
}

TEST(ImageCodec, FewBytesThatPromiseGigabytesAreRefusedBeforeTheyAreDecoded) {
  for (const char* kind : {".png", ".jpg"}) {
    std::vector<std::uint8_t> bytes;
    cv::imencode(kind, cv::Mat3b(30, 40, cv::Vec3b::all(9)), bytes);
    EXPECT_EQ(decode_compressed(bytes.data(), bytes.size()).size(), cv::Size(40, 30)) << kind;
    // Where each says its size.
    const bool png = std::string(kind) == ".png";
    const std::vector<std::uint8_t> size = png ? std::vector<std::uint8_t>{0, 0, 0, 40, 0, 0, 0, 30}
                                               : std::vector<std::uint8_t>{0, 30, 0, 40};
    const auto at = std::search(bytes.begin(), bytes.end(), size.begin(), size.end());
    ASSERT_NE(at, bytes.end()) << kind;
    std::fill(at + (png ? 2 : 0), at + 4, std::uint8_t{0xFF});
    if (png) std::fill(at + 6, at + 8, std::uint8_t{0xFF});
    EXPECT_THROW((void)decode_compressed(bytes.data(), bytes.size()), std::runtime_error) << kind;
    try {
      (void)decode_compressed(bytes.data(), bytes.size());
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "a compressed image that is far too large") << kind;
    }
  }
}

}  // namespace
}  // namespace striate::remote
