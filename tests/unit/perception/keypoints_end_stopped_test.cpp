#include <gtest/gtest.h>

#include "striate/perception/keypoints/end_stopped.hpp"
#include "striate/perception/keypoints/maxima.hpp"
#include "tests/reference/end_stopped_reference.hpp"
#include "tests/reference/every_target.hpp"
#include "tests/reference/test_images.hpp"

namespace striate::perception {
namespace {

constexpr int kWidth = 61, kHeight = 23;

V1Responses responses_of(const cv::Mat1b& image, double wavelength_px, int reach) {
  V1Settings settings;
  settings.wavelength_px = wavelength_px;
  V1Cells cells(settings);
  V1Responses responses;
  cells.respond(image, reach, false, responses);
  return responses;
}

std::vector<KeypointSettings> kinds() {
  KeypointSettings plain, both, original, strong;
  both.response = EndStoppedResponse::largest;
  original = both;
  original.inhibition = 1.0;
  strong.inhibition = 2.5;
  strong.radial_factor = 3.0;
  return {plain, both, original, strong};
}

TEST(EndStopped, EveryInstructionSetGivesTheBitsOfTheScalarReference) {
  for (const double wavelength_px : {4.0, 5.0, 5.657}) {
    for (const KeypointSettings& settings : kinds()) {
      EndStoppedCells probe(wavelength_px, settings);
      const V1Responses responses = responses_of(reference::texture({kWidth, kHeight}, 3, 0, 250),
                                                 wavelength_px, probe.reach());
      const EndStoppedGeometry geometry = end_stopped_geometry(wavelength_px, settings);
      reference::on_every_target([&](const std::string& name) {
        EndStoppedCells cells(wavelength_px, settings);
        Plane<std::uint16_t> out;
        cells.respond(responses, out);
        for (int y = 0; y < kHeight; ++y) {
          for (int x = 0; x < kWidth; ++x) {
            ASSERT_EQ(out.row(y)[x], reference::end_stopped_integer(responses, geometry, x, y))
                << name << ", lambda " << wavelength_px << ", at " << x << ", " << y;
          }
        }
      });
    }
  }
}

TEST(EndStopped, AreTheFormula) {
  for (const KeypointSettings& settings : kinds()) {
    EndStoppedCells cells(4.0, settings);
    const V1Responses responses =
        responses_of(reference::texture({kWidth, kHeight}, 3), 4.0, cells.reach());
    Plane<std::uint16_t> out;
    cells.respond(responses, out);
    double largest = 0.0;
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const double exact = reference::end_stopped_exact(responses, settings, x, y);
        // 16 radial samples, each up to 2 off and multiplied by k, and 16 tangential ones.
        const double bound = 24.0 + settings.inhibition * 16.0 * (2.0 * settings.radial_factor + 2);
        ASSERT_NEAR(out.row(y)[x], exact, bound);
        largest = std::max(largest, exact);
      }
    }
    EXPECT_GT(largest, 1000.0) << "the bound would say nothing";
  }
}

TEST(EndStopped, StrictMaximaAreThoseOfThePlainSearchOnEveryInstructionSet) {
  Plane<std::uint16_t> plane;
  plane.resize(83, 19, 0, 0);
  for (int y = 0; y < 19; ++y) {
    for (int x = 0; x < 83; ++x) {
      // Few different values, so that there are ties, some of them beyond 32767.
      plane.row(y)[x] = static_cast<std::uint16_t>(reference::hash_noise(x, y, 1) / 4096 * 4096);
    }
  }
  auto is_maximum = [&](int x, int y) {
    for (int v = -1; v <= 1; ++v) {
      for (int u = -1; u <= 1; ++u) {
        if ((u != 0 || v != 0) && plane.row(y + v)[x + u] >= plane.row(y)[x]) return false;
      }
    }
    return plane.row(y)[x] > 40000;
  };
  reference::on_every_target([&](const std::string& name) {
    std::vector<GridPoint> found;
    find_strict_maxima(plane, 2, 40000, found);
    std::size_t at = 0;
    for (int y = 2; y < 17; ++y) {
      for (int x = 2; x < 81; ++x) {
        if (!is_maximum(x, y)) continue;
        ASSERT_LT(at, found.size()) << name;
        EXPECT_EQ(found[at].x, x) << name;
        EXPECT_EQ(found[at].y, y) << name;
        ++at;
      }
    }
    EXPECT_EQ(at, found.size()) << name;
    EXPECT_GT(at, 10U);
    EXPECT_EQ(largest_value(plane), 61440);
  });
}

}  // namespace
}  // namespace striate::perception
