#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <opencv2/imgproc.hpp>

#include "striate/base/user_error.hpp"
#include "striate/perception/descriptor/dense_descriptor.hpp"
#include "striate/perception/descriptor/striate_descriptor.hpp"
#include "tests/reference/direction_reference.hpp"
#include "tests/reference/every_target.hpp"
#include "tests/reference/pooling_reference.hpp"
#include "tests/reference/test_images.hpp"

namespace striate::perception {
namespace {

std::vector<DescribedFrame> some_frames() {
  std::vector<DescribedFrame> frames;
  for (int k = 0; k < 20; ++k) {
    frames.push_back({40.0 + 4.3 * k, 60.0 + 2.1 * k, 4.0 + 0.4 * k, 0.3 * k});
  }
  return frames;
}

std::vector<Descriptor> described(const cv::Mat1b& image, const std::vector<DescribedFrame>& frames,
                                  StriateOrientation orientation = StriateOrientation::given) {
  StriateSettings settings;
  settings.orientation = orientation;
  StriateDescriber describer(settings);
  describer.prepare(image);
  std::vector<Descriptor> result;
  describer.describe(frames, result);
  return result;
}

double mean_distance(const std::vector<Descriptor>& a, const std::vector<Descriptor>& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += hamming_distance(a[k], b[k]);
  return sum / static_cast<double>(a.size());
}

/// A quarter turn clockwise as it is seen: (u, v) goes to (height - 1 - v, u).
std::vector<DescribedFrame> turned(std::vector<DescribedFrame> frames, int height) {
  for (DescribedFrame& frame : frames) {
    const double u_px = frame.u_px;
    frame.u_px = height - 1 - frame.v_px;
    frame.v_px = u_px;
    frame.angle_rad += 0.5 * std::numbers::pi;
  }
  return frames;
}

std::string table_of(int bits) {
  std::string text = "# a comment\n";
  for (int k = 0; k < bits; ++k) text += std::to_string(k) + " 399 -12\n";
  return text;
}

TEST(StriateDescriptor, IsTheSameOnEveryInstructionSet) {
  const cv::Mat1b image = reference::texture({160, 140}, 3);
  const auto expected = described(image, some_frames());
  reference::on_every_target([&](const std::string& name) {
    EXPECT_EQ(described(image, some_frames()), expected) << name;
  });
}

TEST(StriateDescriptor, OfAFrameDoesNotDependOnTheOthers) {
  const cv::Mat1b image = reference::texture({160, 140}, 3);
  const auto together = described(image, some_frames());
  for (std::size_t k = 0; k < together.size(); ++k) {
    EXPECT_EQ(described(image, {some_frames()[k]}).front(), together[k]);
  }
}

TEST(StriateDescriptor, HardlyChangesWithExposure) {
  const cv::Mat1b image = reference::texture({160, 140}, 3, 0, 60);
  cv::Mat1b brighter;
  image.convertTo(brighter, CV_8U, 1.3, 10.0);
  EXPECT_LT(mean_distance(described(image, some_frames()), described(brighter, some_frames())),
            8.0);
}

TEST(StriateDescriptor, TurnsWithTheFrame) {
  const cv::Mat1b image = reference::texture({160, 140}, 3);
  cv::Mat1b rotated;
  cv::rotate(image, rotated, cv::ROTATE_90_CLOCKWISE);
  const auto frames = turned(some_frames(), image.rows);
  EXPECT_LT(mean_distance(described(image, some_frames()), described(rotated, frames)), 12.0);
}

TEST(StriateDescriptor, WithItsOwnAngleIgnoresATurnThatItIsNotTold) {
  const cv::Mat1b image = reference::texture({160, 140}, 3);
  cv::Mat1b rotated;
  cv::rotate(image, rotated, cv::ROTATE_90_CLOCKWISE);
  const auto frames = turned(some_frames(), image.rows);
  const auto own = StriateOrientation::dominant, upright = StriateOrientation::upright;
  EXPECT_LT(mean_distance(described(image, some_frames(), own), described(rotated, frames, own)),
            32.0);
  EXPECT_GT(
      mean_distance(described(image, some_frames(), upright), described(rotated, frames, upright)),
      60.0);
}

TEST(StriateDescriptor, TellsPlacesApart) {
  const cv::Mat1b image = reference::texture({160, 140}, 3);
  auto elsewhere = some_frames();
  for (DescribedFrame& frame : elsewhere) frame.v_px -= 40.0;
  EXPECT_GT(mean_distance(described(image, some_frames()), described(image, elsewhere)), 60.0);
}

TEST(StriateDescriptor, DescribesSmallestImages) {
  EXPECT_NO_THROW(described(cv::Mat1b(1, 1, std::uint8_t{7}), {{0.0, 0.0, 3.0, 0.0}}));
}

TEST(StriateDescriptor, RefusesFramesWithoutSizeAndEmptyImages) {
  StriateDescriber describer(StriateSettings{});
  EXPECT_THROW(describer.prepare(cv::Mat1b()), std::invalid_argument);
  EXPECT_THROW(described(reference::texture({64, 64}, 1), {{1.0, 1.0, 0.0, 0.0}}),
               std::invalid_argument);
}

TEST(StriateDescriptor, OfAFrameOutsideTheImageIsThatOfTheNearestPlaceInside) {
  const cv::Mat1b image = reference::texture({160, 140}, 3);
  const std::vector<DescribedFrame> frames = {{-30.0, 50.0, 8.0, 0.4}, {80.0, 60.0, 8.0, 0.4}};
  EXPECT_EQ(described(image, frames)[0], described(image, {{-0.5, 50.0, 8.0, 0.4}})[0]);
}

/// The angles that are found in the middle of an image.
std::vector<DescribedFrame> oriented(const cv::Mat1b& image, bool second) {
  StriateDescriber describer(StriateSettings{});
  describer.prepare(image);
  const DescribedFrame frame{0.5 * (image.cols - 1), 0.5 * (image.rows - 1), 8.0, 0.0};
  std::vector<DescribedFrame> turned;
  std::vector<Descriptor> descriptors;
  describer.describe_oriented({&frame, 1}, second, turned, descriptors);
  EXPECT_EQ(turned.size(), descriptors.size());
  return turned;
}

TEST(DominantAngle, PointsToWhereAnEdgeGrowsBrighter) {
  for (const double angle_deg : {0.0, 30.0, 101.0, 180.0, 247.0, 300.0}) {
    const double angle = angle_deg * std::numbers::pi / 180.0;
    cv::Mat1b image(cv::Size(81, 81));
    for (int y = 0; y < 81; ++y) {
      for (int x = 0; x < 81; ++x) {
        const double across = (x - 40) * std::cos(angle) + (y - 40) * std::sin(angle);
        image(y, x) = cv::saturate_cast<std::uint8_t>(128.0 + 20.0 * std::clamp(across, -4.0, 4.0));
      }
    }
    const auto turned = oriented(image, true);
    ASSERT_EQ(turned.size(), 1U) << angle_deg;
    EXPECT_NEAR(std::remainder(turned[0].angle_rad - angle, 2.0 * std::numbers::pi), 0.0, 0.05)
        << angle_deg;
  }
}

TEST(DominantAngle, OfACornerAreTwoAndOneWhereOnlyOneIsAskedFor) {
  cv::Mat1b image(cv::Size(81, 81), std::uint8_t{60});
  image(cv::Rect(40, 40, 41, 41)).setTo(200);
  EXPECT_EQ(oriented(image, true).size(), 2U);
  EXPECT_EQ(oriented(image, false).size(), 1U);
  EXPECT_EQ(oriented(cv::Mat1b(cv::Size(81, 81), std::uint8_t{60}), true).size(), 1U)
      << "nothing to see";
}

/// Odd responses made by rule; also the extreme ones, none at all, and those along the axes.
std::vector<std::int16_t> odd_values(int stride, int rows) {
  std::vector<std::int16_t> values(kOrientations * static_cast<std::size_t>(stride * rows));
  for (std::size_t k = 0; k < values.size(); ++k) {
    values[k] = static_cast<std::int16_t>(reference::hash_noise(static_cast<int>(k), 8, 1) - 32768);
    const std::size_t pixel = k % static_cast<std::size_t>(stride * rows);
    if (pixel % 5 == 1) values[k] = 0;
    if (pixel % 7 == 2 && k != pixel) values[k] = 0;
    if (pixel % 11 == 3) values[k] = -32768;
  }
  return values;
}

TEST(DirectionKernels, AreThePlainLoopsOnEveryInstructionSet) {
  using namespace direction_kernels;
  constexpr int kStride = 20;
  const auto values = odd_values(kStride, kSide_px);
  pooling_kernels::OddWindow at{{}, kStride};
  for (std::size_t i = 0; i < kOrientations; ++i) {
    at.odd[i] = &values[i * kStride * kSide_px + kBefore_px * kStride + kBefore_px];
  }
  Weights weights;
  for (std::size_t x = 0; x < kSide_px; ++x) {
    weights.across[x] = 0.07F * static_cast<float>(x);
    weights.down[x] = 1.0F / static_cast<float>(x + 1);
  }
  Shares expected;
  reference::share_directions(at, weights, expected);
  reference::on_every_target([&](const std::string& name) {
    Shares shares;
    share_directions(at, weights, shares);
    EXPECT_EQ(shares.bin, expected.bin) << name;
    EXPECT_EQ(shares.next_bin, expected.next_bin) << name;
    EXPECT_EQ(shares.share, expected.share) << name;
    EXPECT_EQ(shares.next_share, expected.next_share) << name;
  });
}

TEST(DirectionKernels, KnowTheArctangentToAHundredthOfADegree) {
  for (int k = 0; k < 3600; ++k) {
    const double angle = (k + 0.5) * std::numbers::pi / 1800.0;
    EXPECT_NEAR(reference::angle_deg(static_cast<float>(std::sin(angle)),
                                     static_cast<float>(std::cos(angle))),
                0.1 * (k + 0.5), 0.01);
  }
}

TEST(PoolingKernels, AreThePlainLoopsOnEveryInstructionSet) {
  using namespace pooling_kernels;
  constexpr int kStride = 32;
  std::vector<std::int16_t> values(kOrientations * kStride * kWindowSide_px);
  for (std::size_t k = 0; k < values.size(); ++k) {
    values[k] =
        static_cast<std::int16_t>((reference::hash_noise(static_cast<int>(k), 3, 5) - 32768) / 40);
  }
  values[100] = -1000;
  OddWindow window{{}, kStride};
  for (std::size_t i = 0; i < kOrientations; ++i) {
    window.odd[i] = values.data() + i * kStride * kWindowSide_px;
  }
  const std::vector<std::int16_t> taps = {900, 7000, 14000, 8000, 2500, 368};
  const std::array<Pool, 2> pools = {{{3 * kWindowSide_px + 5, 6, 6, taps.data(), taps.data()},
                                      {18 * kWindowSide_px + 18, 4, 3, &taps[1], &taps[2]}}};
  reference::on_every_target([&](const std::string& name) {
    EXPECT_EQ(largest_response(window), 1000) << name;
    for (const Turn& turn : {Turn{0, 0, 1}, Turn{5, 9000, 8}, Turn{15, 32767, 32}}) {
      std::vector<std::int16_t> out(kWindowValues);
      turn_window(window, turn, out.data());
      ASSERT_EQ(out, reference::turned_window(window, turn)) << name << " " << turn.steps;
      std::array<std::int16_t, 2 * kChannels> sums{};
      pool(out.data(), pools, sums.data());
      for (int c = 0; c < 2 * kChannels; ++c) {
        const auto& of = pools[static_cast<std::size_t>(c / kChannels)];
        EXPECT_EQ(sums[static_cast<std::size_t>(c)], reference::pooled(out, of, c % kChannels));
      }
    }
  });
}

TEST(StriateTable, TellsTheLineThatIsWrong) {
  auto error = [](const std::string& text) -> std::string {
    try {
      (void)parse_striate_table(text, "table.inc");
    } catch (const UserError& diagnostic) {
      return diagnostic.what();
    }
    return "none";
  };
  EXPECT_EQ(error(table_of(256)), "none");
  EXPECT_THAT(error("# one\n1 2\n"), testing::StartsWith("table.inc:2: error"));
  EXPECT_THAT(error("1 2 0\n1 400 0\n"), testing::StartsWith("table.inc:2: error"));
  EXPECT_THAT(error("3 3 0\n"), testing::StartsWith("table.inc:1: error"));
  EXPECT_THAT(error(table_of(257)), testing::StartsWith("table.inc:258: error: more"));
  EXPECT_THAT(error(table_of(255)), testing::HasSubstr("only 255 of 256 bits"));
}

TEST(StriateTable, IsReadAsItWasWritten) {
  std::vector<StriateBit> bits(256, StriateBit{7, 9, -3});
  bits[17] = {399, 0, 250};
  const StriateTable table = parse_striate_table(striate_table_text(bits, "# made\n"), "t");
  EXPECT_EQ(table[17].first, 399);
  EXPECT_EQ(table[17].threshold, 250);
  EXPECT_EQ(table[255].second, 9);
}

}  // namespace
}  // namespace striate::perception
