#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "config/user_error.hpp"
#include "perception/descriptor/dense_descriptor.hpp"
#include "perception/keypoints/keypoints.hpp"
#include "tests/reference/every_target.hpp"
#include "tests/reference/test_pictures.hpp"

namespace striate {
namespace {

double nearest_px(const std::vector<Keypoint>& found, double u, double v) {
  double nearest = 1e9;
  for (const Keypoint& point : found) {
    nearest = std::min(nearest, std::hypot(point.u_px - u, point.v_px - v));
  }
  return nearest;
}

TEST(KeypointFinder, FindsTheCornersOfASquareAndNothingOnItsSides) {
  for (const bool halve : {false, true}) {
    KeypointSettings settings;
    settings.halve = halve;
    cv::Mat1b picture(160, 200, std::uint8_t{60});
    picture(cv::Rect(60, 40, 80, 80)).setTo(180);
    const std::vector<Keypoint> found = find_keypoints(picture, settings);
    for (const auto& [u, v] :
         {std::pair{59.5, 39.5}, {139.5, 39.5}, {59.5, 119.5}, {139.5, 119.5}}) {
      EXPECT_LT(nearest_px(found, u, v), 5.0) << "halved: " << halve;
    }
    EXPECT_GT(nearest_px(found, 99.5, 39.5), 15.0) << "the middle of the upper side";
    EXPECT_GT(nearest_px(found, 100.0, 80.0), 15.0) << "the inside";
  }
}

TEST(KeypointFinder, FindsTheSameThingsInAShiftedPicture) {
  const cv::Mat1b wide = reference::texture({240, 160}, 3);
  const auto here = find_keypoints(wide(cv::Rect(0, 0, 200, 160)).clone(), {});
  const auto there = find_keypoints(wide(cv::Rect(12, 0, 200, 160)).clone(), {});
  ASSERT_GT(here.size(), 30U);
  int inside = 0, again = 0, same = 0;
  for (const Keypoint& point : here) {
    if (point.u_px < 50 || point.u_px > 180 || point.v_px < 30 || point.v_px > 130) continue;
    ++inside;
    for (const Keypoint& other : there) {
      if (std::hypot(other.u_px + 12 - point.u_px, other.v_px - point.v_px) > 0.1) continue;
      ++again;
      same += hamming_distance(point.descriptor, other.descriptor) <= 4;
    }
  }
  ASSERT_GT(inside, 15);
  EXPECT_GE(again, 0.9 * inside);
  EXPECT_GE(same, 0.9 * inside);
}

TEST(KeypointFinder, ComesStrongestFirstAndKeepsOnlyTheMost) {
  KeypointSettings settings;
  const cv::Mat1b picture = reference::texture({200, 160}, 5);
  const auto all = find_keypoints(picture, settings);
  settings.most = 10;
  const auto few = find_keypoints(picture, settings);
  ASSERT_GT(all.size(), 10U);
  ASSERT_EQ(few.size(), 10U);
  for (std::size_t k = 0; k < few.size(); ++k) {
    EXPECT_EQ(few[k].descriptor, all[k].descriptor);
    if (k > 0) {
      EXPECT_LE(few[k].response, few[k - 1].response);
    }
  }
}

/// K by the formula, in double precision, with the samples' own weights.
double plain_response(const ComplexPlanes& complex, double wavelength_px, int u, int v) {
  auto at = [&](std::size_t i, double x, double y) {
    const int left = static_cast<int>(std::floor(x)), top = static_cast<int>(std::floor(y));
    const double a = x - left, b = y - top;
    return (1 - b) * ((1 - a) * complex[i].row(top)[left] + a * complex[i].row(top)[left + 1]) +
           b * ((1 - a) * complex[i].row(top + 1)[left] + a * complex[i].row(top + 1)[left + 1]);
  };
  auto positive = [](double value) { return std::max(0.0, value); };
  const double d = 0.6 * wavelength_px;
  double single = 0.0, twice = 0.0, inhibition = 0.0;
  for (std::size_t i = 0; i < 8; ++i) {
    const double c = std::cos(static_cast<double>(i) * std::numbers::pi / 8.0);
    const double s = std::sin(static_cast<double>(i) * std::numbers::pi / 8.0);
    const double here = at(i, u, v);
    single += positive(at(i, u + d * s, v - d * c) - at(i, u - d * s, v + d * c));
    twice += positive(here - 0.5 * at(i, u + 2 * d * s, v - 2 * d * c) -
                      0.5 * at(i, u - 2 * d * s, v + 2 * d * c));
    for (const double sign : {-1.0, 1.0}) {
      inhibition += positive(at(i, u + sign * d * c, v + sign * d * s) - here);
      inhibition +=
          positive(here - 4.0 * at((i + 4) % 8, u + sign * d / 2 * c, v + sign * d / 2 * s));
    }
  }
  return std::max(single, twice) - inhibition;
}

TEST(EndStopped, AreTheFormulaAndTheSameBitsOnEveryInstructionSet) {
  V1Cells cells({});
  const EndStoppedGeometry geometry = end_stopped_geometry(4.0, 1.0, 4.0);
  V1Responses responses;
  cells.respond(reference::texture({61, 23}, 3), geometry.reach, false, responses);
  ComplexPlanes complex;
  complex_planes(responses, complex);
  Plane<float> first;
  bool is_first = true;
  reference::on_every_target([&](const std::string& name) {
    Plane<float> out;
    end_stopped_response(complex, geometry, out);
    for (int y = 0; y < 23; ++y) {
      for (int x = 0; x < 61; ++x) {
        if (is_first) {
          const double exact = plain_response(complex, 4.0, x, y);
          ASSERT_NEAR(out.row(y)[x], exact, 0.002 * std::abs(exact) + 20.0);
        } else {
          ASSERT_EQ(out.row(y)[x], first.row(y)[x]) << name;
        }
      }
    }
    if (is_first) first = std::move(out);
    is_first = false;
  });
}

TEST(KeypointFinder, TakesPicturesOfAnySizeAndFindsNothingInBlankOnes) {
  for (const bool halve : {false, true}) {
    KeypointSettings settings;
    settings.halve = halve;
    for (const cv::Size size : {cv::Size(1, 1), cv::Size(3, 50), cv::Size(97, 61)}) {
      EXPECT_TRUE(find_keypoints(cv::Mat1b(size, std::uint8_t{0}), settings).empty());
      EXPECT_TRUE(find_keypoints(cv::Mat1b(size, std::uint8_t{255}), settings).empty());
      for (const Keypoint& point : find_keypoints(reference::texture(size, 1), settings)) {
        EXPECT_GE(point.u_px, 0.0);
        EXPECT_LT(point.u_px, size.width);
      }
    }
  }
  EXPECT_THROW(find_keypoints(cv::Mat1b(), {}), std::invalid_argument);
}

TEST(KeypointFinder, RefusesAWavelengthThatTheFiltersCannotHave) {
  KeypointSettings settings;
  settings.wavelength_px = 4.0;  // 2 px on the halved picture
  EXPECT_THROW(KeypointFinder{settings}, UserError);
}

}  // namespace
}  // namespace striate
