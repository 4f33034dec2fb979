#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "striate/base/user_error.hpp"
#include "striate/perception/lines/lines.hpp"
#include "tests/reference/every_target.hpp"
#include "tests/reference/test_images.hpp"

namespace striate::perception {
namespace {

/// A straight contour through (40, 40); `profile` of the distance across it gives the grey value,
/// averaged over each pixel.
template <class Profile>
cv::Mat1b contour(double across_rad, Profile profile) {
  cv::Mat1b image(81, 81);
  for (int v = 0; v < 81; ++v) {
    for (int u = 0; u < 81; ++u) {
      double sum = 0.0;
      for (int k = 0; k < 64; ++k) {
        const double x = u + (k % 8 + 0.5) / 8.0 - 0.5 - 40.0;
        const double y = v + (k / 8 + 0.5) / 8.0 - 0.5 - 40.0;
        sum += profile(x * std::cos(across_rad) + y * std::sin(across_rad));
      }
      image(v, u) = cv::saturate_cast<std::uint8_t>(sum / 64.0);
    }
  }
  return image;
}

/// All events away from the border are of this kind, on the contour and along all of it.
void expect_contour(const cv::Mat1b& image, EventKind kind, double across_rad) {
  int count = 0;
  for (const ContourEvent& event : find_lines_and_edges(image, {}).events) {
    if (event.u_px < 15 || event.u_px > 65 || event.v_px < 15 || event.v_px > 65) continue;
    ++count;
    EXPECT_EQ(static_cast<int>(event.kind), static_cast<int>(kind));
    EXPECT_NEAR(event.across_rad, across_rad, 1e-9);
    const double off_px =
        (event.u_px - 40) * std::cos(across_rad) + (event.v_px - 40) * std::sin(across_rad);
    EXPECT_LT(std::abs(off_px), 0.2);
    EXPECT_GT(event.strength, 0.0);
  }
  const double along_px =
      50.0 * std::max(std::abs(std::cos(across_rad)), std::abs(std::sin(across_rad)));
  EXPECT_GE(count, 0.8 * std::min(50.0, along_px));
  EXPECT_LE(count, 52) << "one event a row or column";
}

TEST(LineFinder, ABrightBarIsAPositiveLineAndADarkOneANegative) {
  for (int i = 0; i < kOrientations; ++i) {
    const double across_rad = i * std::numbers::pi / kOrientations;
    for (const int sign : {-1, 1}) {
      SCOPED_TRACE(testing::Message() << "orientation " << i << ", sign " << sign);
      const cv::Mat1b bar =
          contour(across_rad, [&](double t) { return 128 + (std::abs(t) < 1.0 ? sign * 90 : 0); });
      expect_contour(bar, sign > 0 ? EventKind::line_positive : EventKind::line_negative,
                     across_rad);
    }
  }
}

TEST(LineFinder, AStepIsAnEdgePositiveWhereItBrightensAcross) {
  for (int i = 0; i < kOrientations; ++i) {
    const double across_rad = i * std::numbers::pi / kOrientations;
    for (const int sign : {-1, 1}) {
      SCOPED_TRACE(testing::Message() << "orientation " << i << ", sign " << sign);
      const cv::Mat1b step =
          contour(across_rad, [&](double t) { return 128 + (t > 0.0 ? sign : -sign) * 60; });
      expect_contour(step, sign > 0 ? EventKind::edge_positive : EventKind::edge_negative,
                     across_rad);
    }
  }
}

TEST(LineFinder, FindsNothingInBlankImagesOfAnySize) {
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(2, 2), cv::Size(3, 40), cv::Size(60, 50)}) {
    for (const int grey : {0, 130, 255}) {
      EXPECT_TRUE(find_lines_and_edges(cv::Mat1b(size, std::uint8_t(grey)), {}).events.empty());
    }
  }
  EXPECT_THROW(find_lines_and_edges(cv::Mat1b(), {}), std::invalid_argument);
}

TEST(LineFinder, GivesTheSameOnEveryInstructionSet) {
  const cv::Mat1b image = reference::texture({70, 50}, 6);
  std::vector<ContourEvent> first;
  reference::on_every_target([&](const std::string& name) {
    const auto found = find_lines_and_edges(image, {}).events;
    if (first.empty()) first = found;
    ASSERT_EQ(found.size(), first.size()) << name;
    for (std::size_t k = 0; k < found.size(); ++k) {
      ASSERT_EQ(found[k].u_px, first[k].u_px) << name;
      ASSERT_EQ(found[k].strength, first[k].strength) << name;
    }
  });
  EXPECT_GT(first.size(), 100U);
}

TEST(LineFinder, RefusesAWavelengthThatTheFiltersCannotHave) {
  EXPECT_THROW(LineFinder({.wavelength_px = 2.0}), UserError);
}

}  // namespace
}  // namespace striate::perception
