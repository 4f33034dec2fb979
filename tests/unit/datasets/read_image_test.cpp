#include "striate/platform/datasets/images/read_image.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "striate/base/crc_table.hpp"
#include "striate/base/user_error.hpp"
#include "tests/reference/temporary_folder.hpp"

namespace striate::datasets {
namespace {

namespace fs = std::filesystem;

/// Names of the corners of what is stored: 0 top left, 1 top right, 2 bottom left, 3 bottom right.
const std::array<cv::Vec3b, 4> kColours = {cv::Vec3b(0, 0, 255), cv::Vec3b(0, 255, 0),
                                           cv::Vec3b(255, 0, 0), cv::Vec3b(255, 255, 255)};
/// EXIF 2.3: which of them stands upright at the same four places, by orientation.
constexpr std::array<std::array<int, 4>, 8> kUpright = {{{0, 1, 2, 3},
                                                         {1, 0, 3, 2},
                                                         {3, 2, 1, 0},
                                                         {2, 3, 0, 1},
                                                         {0, 2, 1, 3},
                                                         {2, 0, 3, 1},
                                                         {3, 1, 2, 0},
                                                         {1, 3, 0, 2}}};

cv::Mat3b quarters() {
  cv::Mat3b image(32, 48);
  for (int k = 0; k < 4; ++k) {
    image(cv::Rect(k % 2 * 24, k / 2 * 16, 24, 16)).setTo(kColours.at(static_cast<std::size_t>(k)));
  }
  return image;
}

std::string little(std::uint32_t value, int bytes) {
  std::string text;
  for (int k = 0; k < bytes; ++k) text += static_cast<char>(value >> (8 * k) & 0xFFU);
  return text;
}

std::string big(std::uint32_t value, int bytes) {
  const std::string turned = little(value, bytes);
  return {turned.rbegin(), turned.rend()};
}

/// A TIFF directory that says nothing but the orientation.
std::string exif(int orientation, bool little_endian) {
  const auto put = little_endian ? little : big;
  const auto value = static_cast<std::uint32_t>(orientation);
  return (little_endian ? "II" : "MM") + put(42, 2) + put(8, 4) + put(1, 2) + put(0x0112, 2) +
         put(3, 2) + put(1, 4) + put(value, 2) + put(0, 2) + put(0, 4);
}

std::string encoded(const char* kind, const cv::Mat& image) {
  std::vector<uchar> bytes;
  cv::imencode(kind, image, bytes);
  return {bytes.begin(), bytes.end()};
}

std::string png_chunk(const std::string& name, const std::string& data) {
  static constexpr auto kTable = reflected_crc_table(0xEDB88320U);
  std::uint32_t c = 0xFFFFFFFFU;
  for (const char one : name + data) c = kTable[(c ^ static_cast<uchar>(one)) & 0xFFU] ^ (c >> 8);
  return big(static_cast<std::uint32_t>(data.size()), 4) + name + data + big(~c, 4);
}

std::string jpeg(int orientation) {
  const std::string data = std::string("Exif\0\0", 6) + exif(orientation, false);
  return encoded(".jpg", quarters())
      .insert(2, "\xFF\xE1" + big(static_cast<std::uint32_t>(data.size() + 2), 2) + data);
}

std::string png(int orientation) {
  return encoded(".png", quarters()).insert(33, png_chunk("eXIf", exif(orientation, true)));
}

std::string webp(int orientation) {
  std::string picture = encoded(".webp", quarters()).substr(12);
  const std::string data = exif(orientation, true);
  const std::string chunks = "VP8X" + little(10, 4) + little(8, 4) + little(47, 3) + little(31, 3) +
                             picture + "EXIF" + little(static_cast<std::uint32_t>(data.size()), 4) +
                             data;
  return "RIFF" + little(static_cast<std::uint32_t>(chunks.size() + 4), 4) + "WEBP" + chunks;
}

std::string tiff(int orientation) {
  const cv::Mat3b image = quarters();
  std::string pixels;
  for (const cv::Vec3b& one : image) {
    for (const int k : {2, 1, 0}) pixels += static_cast<char>(one[k]);
  }
  struct Entry {
    std::uint32_t tag, type, count, value;
  };
  const std::uint32_t bits_at = 8 + 2 + 10 * 12 + 4;
  const std::vector<Entry> entries = {{256, 3, 1, 48},
                                      {257, 3, 1, 32},
                                      {258, 3, 3, bits_at},
                                      {259, 3, 1, 1},
                                      {262, 3, 1, 2},
                                      {273, 4, 1, bits_at + 6},
                                      {274, 3, 1, static_cast<std::uint32_t>(orientation)},
                                      {277, 3, 1, 3},
                                      {278, 3, 1, 32},
                                      {279, 4, 1, static_cast<std::uint32_t>(pixels.size())}};
  std::string text = "II" + little(42, 2) + little(8, 4) + little(10, 2);
  for (const Entry& e : entries) {
    text += little(e.tag, 2) + little(e.type, 2) + little(e.count, 4) + little(e.value, 4);
  }
  return text + little(0, 4) + little(8, 2) + little(8, 2) + little(8, 2) + pixels;
}

class ReadImage : public testing::Test {
 protected:
  [[nodiscard]] fs::path write(const std::string& bytes, const std::string& name = "p") const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }
  [[nodiscard]] std::string error_of(const fs::path& left, const fs::path& right) const {
    try {
      (void)read_eye_pair(left, right);
    } catch (const UserError& error) {
      return error.what();
    }
    return "";
  }
  reference::TemporaryFolder folder_;
};

TEST_F(ReadImage, StandsUprightByTheOrientationOfEveryKindOfFile) {
  using Maker = std::string (*)(int);
  for (const auto& [kind, make] : {std::pair<const char*, Maker>{"jpeg", jpeg},
                                   {"png", png},
                                   {"webp", webp},
                                   {"tiff", tiff}}) {
    for (int orientation = 1; orientation <= 8; ++orientation) {
      const fs::path file = write(make(orientation));
      const cv::Mat3b image = read_any_image(file);
      const cv::Size size = orientation < 5 ? cv::Size(48, 32) : cv::Size(32, 48);
      ASSERT_EQ(image.size(), size) << kind << ' ' << orientation;
      EXPECT_EQ(read_any_grey(file).size(), size) << kind << ' ' << orientation;
      for (int k = 0; k < 4; ++k) {
        const int u = k % 2 == 0 ? 4 : size.width - 5;
        const int v = k / 2 == 0 ? 4 : size.height - 5;
        const int stored =
            kUpright.at(static_cast<std::size_t>(orientation - 1)).at(static_cast<std::size_t>(k));
        EXPECT_LT(cv::norm(image(v, u) - kColours.at(static_cast<std::size_t>(stored))), 60.0)
            << kind << ' ' << orientation << ", corner " << k;
      }
    }
  }
}

TEST_F(ReadImage, APairOfTurnedEyesIsRefusedSinceTheyAreNotSideBySide) {
  for (const std::string& turned : {jpeg(6), png(3), webp(8), tiff(6)}) {
    const fs::path file = write(turned, "turned");
    const fs::path straight = write(encoded(".png", quarters()), "straight");
    EXPECT_THAT(error_of(file, file), testing::HasSubstr("EXIF"));
    EXPECT_THAT(error_of(straight, file), testing::HasSubstr("turned: its EXIF"));
    EXPECT_EQ(error_of(straight, straight), "");
  }
}

std::string pnm(int kind, int most, const std::vector<int>& values) {
  std::string text = "P" + std::to_string(kind) + "\n16 16\n" + std::to_string(most) + "\n";
  const int samples = 256 * (kind == 3 || kind == 6 ? 3 : 1);
  for (int k = 0; k < samples; ++k) {
    const auto value = static_cast<std::uint32_t>(values[k % values.size()]);
    text += kind < 4 ? std::to_string(value) + "\n" : big(value, most > 255 ? 2 : 1);
  }
  return text;
}

TEST_F(ReadImage, WhiteOfPgmAndPpmIsWhatTheirHeadersCallWhite) {
  for (const int kind : {2, 3, 5, 6}) {
    for (const int most : {15, 100, 255, 300, 1023, 4095, 65535}) {
      const fs::path file = write(pnm(kind, most, {most, 0, most / 2, most, 0, most / 2}));
      const cv::Mat1b grey = read_any_grey(file);
      const cv::Mat3b image = read_any_image(file);
      const std::string what = "P" + std::to_string(kind) + ' ' + std::to_string(most);
      double brightest = 0.0;
      cv::minMaxLoc(image.reshape(1), nullptr, &brightest);
      EXPECT_GE(brightest, 254.0) << what;
      if (kind == 3 || kind == 6) continue;
      EXPECT_GE(grey(0, 0), 254) << what;
      EXPECT_EQ(grey(0, 1), 0) << what;
      EXPECT_NEAR(grey(0, 2), 127, most < 100 ? 10 : 2) << what;
    }
  }
}

TEST_F(ReadImage, TenTwelveAndFourteenBitsInSixteenAreNotBlack) {
  for (const char* kind : {".png", ".tiff"}) {
    for (const int most : {1023, 4095, 16383, 65535}) {
      cv::Mat1w image(16, 16, static_cast<ushort>(most / 2));
      image(3, 3) = static_cast<ushort>(most);
      const fs::path file = write(encoded(kind, image));
      EXPECT_EQ(read_any_grey(file)(3, 3), 255) << kind << most;
      EXPECT_NEAR(read_any_image(file)(0, 0)[1], 127, 1) << kind << most;
    }
  }
}

TEST_F(ReadImage, BothEyesHaveTheSameWhite) {
  const fs::path left = write(encoded(".png", cv::Mat1w(16, 16, ushort{4000})), "left");
  const fs::path right = write(encoded(".png", cv::Mat1w(16, 16, ushort{1000})), "right");
  for (const bool exchanged : {false, true}) {
    const EyePair pair = read_eye_pair(exchanged ? right : left, exchanged ? left : right);
    const GreyPair greys = read_grey_pair(exchanged ? right : left, exchanged ? left : right);
    const cv::Mat3b& bright = exchanged ? pair.right : pair.left;
    const cv::Mat3b& dim = exchanged ? pair.left : pair.right;
    EXPECT_EQ(bright(0, 0)[0], 249);
    EXPECT_EQ(dim(0, 0)[0], 62);
    EXPECT_EQ((exchanged ? greys.left : greys.right)(0, 0), 62);
  }
}

}  // namespace
}  // namespace striate::datasets
