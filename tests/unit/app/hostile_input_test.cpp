#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <optional>
#include <sstream>

#include "striate/app/perceive.hpp"
#include "striate/base/user_error.hpp"
#include "striate/evaluation/images/pfm.hpp"
#include "striate/platform/datasets/images/image_header.hpp"
#include "striate/platform/datasets/images/read_image.hpp"

namespace striate::app {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class HostileInput : public testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        fs::temp_directory_path() / (std::string("striate_hostile_") +
                                     testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] fs::path write(const cv::Mat& image) const {
    cv::imwrite((folder_ / "p.png").string(), image);
    return folder_ / "p.png";
  }
  [[nodiscard]] fs::path write_bytes(const std::vector<uchar>& bytes) const {
    std::ofstream(folder_ / "p.png", std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    return folder_ / "p.png";
  }
  /// Nothing that packs well: a cut takes pixels away.
  [[nodiscard]] static cv::Mat3b noisy_image() {
    cv::Mat3b image(48, 64);
    cv::theRNG().state = 7;
    cv::randu(image, 0, 256);
    return image;
  }
  [[nodiscard]] static std::string error_of(const fs::path& file) {
    try {
      (void)datasets::read_any_image(file);
    } catch (const UserError& e) {
      return e.what();
    }
    return "";
  }

  fs::path folder_;
};

std::string pfm(const std::string& header, const std::vector<float>& values) {
  return header + std::string(reinterpret_cast<const char*>(values.data()), 4 * values.size());
}

std::string pfm_error(const std::string& bytes) {
  std::istringstream in(bytes);
  try {
    (void)evaluation::read_pfm(in, "f.pfm");
  } catch (const UserError& e) {
    return e.what();
  }
  return "";
}

TEST_F(HostileInput, TinyHugeAndLongImagesAreRefusedWithTheirSize) {
  EXPECT_THAT(error_of(write(cv::Mat1b(1, 1, uchar{3}))), HasSubstr("p.png: is 1 x 1 px"));
  EXPECT_THAT(error_of(write(cv::Mat1b(8000, 8000, uchar{3}))), HasSubstr("8000 x 8000"));
  EXPECT_THAT(error_of(write(cv::Mat1b(100, 20000, uchar{3}))), HasSubstr("20000 x 100"));
}

TEST_F(HostileInput, TruncatedEmptyAndMissingFilesAreNoImages) {
  const fs::path whole = write(cv::Mat3b(64, 64, cv::Vec3b(1, 2, 3)));
  fs::resize_file(whole, 40);
  EXPECT_THAT(error_of(whole), HasSubstr("is no image"));
  std::ofstream(folder_ / "empty.png").flush();
  EXPECT_THAT(error_of(folder_ / "empty.png"), HasSubstr("is no image"));
  EXPECT_THAT(error_of(folder_), HasSubstr("is a folder"));
  EXPECT_THAT(error_of(folder_ / "nowhere.png"), HasSubstr("no such file"));
}

TEST_F(HostileInput, AFileThatWasCutOffAnywhereIsNoImage) {
  const cv::Mat3b whole = noisy_image();
  for (const char* kind : {".png", ".jpg", ".ppm", ".bmp", ".tiff", ".webp"}) {
    std::vector<uchar> bytes;
    cv::imencode(kind, whole, bytes);
    EXPECT_EQ(datasets::read_any_image(write_bytes(bytes)).size(), whole.size()) << kind;
    for (const double share : {0.3, 0.6, 0.95}) {
      std::vector<uchar> part = bytes;
      part.resize(static_cast<std::size_t>(share * static_cast<double>(bytes.size())));
      EXPECT_THAT(error_of(write_bytes(part)), HasSubstr("is no image")) << kind << ' ' << share;
    }
  }
}

TEST_F(HostileInput, APngWithADamagedByteIsNoImage) {
  std::vector<uchar> bytes;
  cv::imencode(".png", noisy_image(), bytes);
  bytes[bytes.size() / 2] ^= 4U;
  EXPECT_THAT(error_of(write_bytes(bytes)), HasSubstr("damaged"));
}

TEST_F(HostileInput, AHugeSizeInTheHeaderIsRefusedBeforeAnythingIsDecoded) {
  for (const char* kind : {".png", ".jpg", ".bmp", ".tiff", ".webp"}) {
    std::vector<uchar> bytes;
    cv::imencode(kind, cv::Mat3b(32, 32), bytes);
    const std::optional<datasets::ImageHeader> header = datasets::read_image_header(bytes);
    ASSERT_TRUE(header.has_value()) << kind;
    EXPECT_EQ(header->width_px, 32) << kind;
    EXPECT_EQ(header->height_px, 32) << kind;
    EXPECT_TRUE(header->whole) << kind;
  }
  std::vector<uchar> png;
  cv::imencode(".png", cv::Mat1b(32, 32, uchar{3}), png);
  png[17] = png[21] = 0x10;  // 1048608 px each way
  EXPECT_THAT(error_of(write_bytes(png)), HasSubstr("1048608 x 1048608"));
  std::vector<uchar> bmp;
  cv::imencode(".bmp", cv::Mat1b(32, 32, uchar{3}), bmp);
  bmp[21] = bmp[25] = 0x7f;  // 2130706464 px each way: the bytes of that do not fit 64 bits
  EXPECT_THAT(error_of(write_bytes(bmp)), HasSubstr("2130706464 x 2130706464"));
  const std::string pgm = "P5\n# comment 7\n99999 99999\n255\n";
  EXPECT_THAT(error_of(write_bytes({pgm.begin(), pgm.end()})), HasSubstr("99999 x 99999"));
}

TEST_F(HostileInput, FloatingPointPixelsAreSaidToBeThat) {
  const std::string pfm = "Pf\n32 32\n-1.0\n" + std::string(4096, '\xff');  // all NaN
  EXPECT_THAT(error_of(write_bytes({pfm.begin(), pfm.end()})), HasSubstr("floating-point"));
}

TEST_F(HostileInput, SixteenBitsAreScaledAndAlphaIsDropped) {
  const cv::Mat3b deep = datasets::read_any_image(write(cv::Mat1w(32, 32, ushort{200 * 257})));
  EXPECT_EQ(deep(5, 5), cv::Vec3b::all(200));
  const cv::Mat3b clear = datasets::read_any_image(write(cv::Mat4b(32, 32, cv::Vec4b(9, 8, 7, 0))));
  EXPECT_EQ(clear(5, 5), cv::Vec3b(9, 8, 7));
}

TEST_F(HostileInput, BlackAndWhitePairsGiveAnAnswer) {
  for (const uchar grey : {uchar{0}, uchar{255}}) {
    PerceiveOptions options;
    options.left = options.right = write(cv::Mat1b(120, 160, grey));
    options.out = folder_ / "out";
    EXPECT_FALSE(perceive(options).frame.left.empty());
  }
}

TEST(Pfm, ReadsBothEndiansUprightAndTurnsNanToUnknown) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::istringstream little(pfm("Pf\n2 2\n-1.0\n", {1.0F, 2.0F, nan, 4.0F}));
  const cv::Mat1f read = evaluation::read_pfm(little, "f.pfm");
  EXPECT_EQ(read(1, 0), 1.0F);
  EXPECT_EQ(read(0, 1), 4.0F);
  EXPECT_EQ(read(0, 0), std::numeric_limits<float>::infinity());
  std::istringstream big(std::string("Pf\n1 1\n1.0\n") + std::string("\x3F\x80\x00\x00", 4));
  EXPECT_EQ(evaluation::read_pfm(big, "f.pfm")(0, 0), 1.0F);
}

TEST(Pfm, RefusesWhatIsNoGreyPfm) {
  EXPECT_THAT(pfm_error(""), HasSubstr("f.pfm: does not begin with Pf"));
  EXPECT_THAT(pfm_error("PF\n1 1\n-1\n"), HasSubstr("three channels"));
  EXPECT_THAT(pfm_error("Pf\n-1 1\n-1\n"), HasSubstr("no number"));
  EXPECT_THAT(pfm_error("Pf\n99999999999 1\n-1\n"), HasSubstr("16384"));
  EXPECT_THAT(pfm_error("Pf\n16000 16000\n-1\n"), HasSubstr("40 million"));
  EXPECT_THAT(pfm_error("Pf\n1 1\nnan\n1234"), HasSubstr("scale"));
  EXPECT_THAT(pfm_error("Pf\n2 2\n-1\n1234"), HasSubstr("ends too early"));
}

}  // namespace
}  // namespace striate::app
