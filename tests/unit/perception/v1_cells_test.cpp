#include "striate/perception/v1/v1_cells.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/reference/every_target.hpp"
#include "tests/reference/test_images.hpp"
#include "tests/reference/v1_integer_reference.hpp"
#include "tests/reference/v1_reference.hpp"

namespace striate::perception {
namespace {

std::vector<V1Settings> all_settings() {
  return {V1Settings{},
          {4.0, 0.56, 0.5, EvenMean::kept},
          {4.0, 0.30, 1.0, EvenMean::envelope},
          {3.0, 0.30, 1.0, EvenMean::envelope},
          {8.0, 0.56, 0.5, EvenMean::flat}};
}

void expect_same(const V1Responses& fast, const reference::V1Integers& plain,
                 const std::string& what) {
  for (std::size_t i = 0; i < kOrientations; ++i) {
    int wrong = 0;
    for (int y = 0; y < fast.height; ++y) {
      for (int x = 0; x < fast.width; ++x) {
        wrong += fast.even[i].row(y)[x] != plain.even[i](y, x);
        wrong += fast.odd[i].row(y)[x] != plain.odd[i](y, x);
        wrong += fast.code[i].row(y)[x] != plain.code[i](y, x);
      }
    }
    EXPECT_EQ(wrong, 0) << what << ", orientation " << i;
  }
}

TEST(V1Cells, EveryInstructionSetGivesTheBitsOfTheScalarReference) {
  for (const V1Settings& settings : all_settings()) {
    V1Cells cells(settings);
    for (const cv::Size size :
         {cv::Size(67, 21), cv::Size(33, 34), cv::Size(1, 1), cv::Size(3, 40)}) {
      const cv::Mat1b image = reference::texture(size, 5, 0, 127);
      const reference::V1Integers plain = reference::integer_responses(image, cells.bank());
      int targets = 0;
      reference::on_every_target([&](const std::string& name) {
        V1Responses fast;
        cells.respond(image, 3, true, fast);
        expect_same(fast, plain, name + " " + std::to_string(settings.wavelength_px));
        ++targets;
      });
      EXPECT_GE(targets, 1);
    }
  }
}

void expect_rows(const Plane<std::int16_t>& a, const Plane<std::int16_t>& b, int width,
                 const std::string& what) {
  for (int y = 0; y < b.height(); ++y) {
    EXPECT_TRUE(std::equal(b.row(y), b.row(y) + width, a.row(y))) << what << " row " << y;
  }
}

TEST(V1Cells, SimpleCellsAloneAreTheSameOnEveryInstructionSet) {
  const cv::Size size(67, 21);
  const cv::Mat1b image = reference::texture(size, 5, 0, 127);
  for (const V1Settings& settings : all_settings()) {
    V1Cells cells(settings);
    V1Responses all;
    cells.respond(image, 3, true, all);
    reference::on_every_target([&](const std::string& name) {
      V1Responses both, odd;
      cells.respond_simple(image, SimpleCells::even_and_odd, both);
      cells.respond_simple(image, SimpleCells::odd, odd);
      EXPECT_EQ(odd.even[0].height(), 0) << name;
      for (std::size_t i = 0; i < kOrientations; ++i) {
        expect_rows(both.even[i], all.even[i], size.width, name + ", even");
        expect_rows(both.odd[i], all.odd[i], size.width, name + ", odd");
        expect_rows(odd.odd[i], all.odd[i], size.width, name + ", odd only");
      }
    });
  }
}

/// Greys with sixteenths of a level.
cv::Mat1w fine_texture(cv::Size size) {
  cv::Mat1w fine;
  reference::texture(size, 7).convertTo(fine, CV_16U, 16.0);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) fine(y, x) += static_cast<ushort>((5 * x + 3 * y) % 16);
  }
  return fine;
}

TEST(V1Cells, SixteenthsOfAGreyLevelCountOnEveryInstructionSet) {
  const cv::Mat1w image = fine_texture({67, 21});
  for (const V1Settings& settings : all_settings()) {
    V1Cells cells(settings);
    const reference::V1Integers plain = reference::integer_responses(image, cells.bank());
    reference::on_every_target([&](const std::string& name) {
      V1Responses fast;
      cells.respond(image, 3, true, fast);
      expect_same(fast, plain, name);
    });
    const reference::V1Reference exact = reference::respond(image, settings);
    V1Responses fast;
    cells.respond(image, 3, true, fast);
    EXPECT_NEAR(fast.even[2].row(9)[30] / fast.gain, exact.even[2](9, 30),
                0.02 * std::sqrt(exact.energy[2](9, 30)) + 2.0 / fast.gain);
  }
}

TEST(V1Cells, WholeGreysInSixteenthsGiveTheBitsOfEightBits) {
  const cv::Mat1b whole = reference::texture({50, 40}, 3);
  cv::Mat1w sixteenths;
  whole.convertTo(sixteenths, CV_16U, 16.0);
  for (const V1Settings& settings : all_settings()) {
    V1Cells cells(settings);
    V1Responses a;
    cells.respond(sixteenths, 3, true, a);
    expect_same(a, reference::integer_responses(whole, cells.bank()), "sixteenths");
  }
  V1Responses nothing;
  EXPECT_THROW(V1Cells(V1Settings{}).respond(cv::Mat1f(4, 4), 0, false, nothing),
               std::invalid_argument);
}

TEST(FilterBank, EveryRowFilterIsEvenOrOddForAnySettings) {
  for (const double wavelength_px : {3.0, 4.0, 5.7, 12.0}) {
    for (const double sigma_factor : {0.2, 0.37, 0.56, 1.0}) {
      for (const double gamma : {0.25, 0.5, 1.0, 2.0}) {
        for (const EvenMean mean : {EvenMean::flat, EvenMean::envelope}) {
          const FilterBank bank = make_filter_bank({wavelength_px, sigma_factor, gamma, mean});
          for (const FilterBank::Pair& pair : bank.pairs) {
            for (const FilterBank::Product& product : pair.products) {
              const std::vector<std::int16_t> turned(product.row.rbegin(), product.row.rend());
              std::vector<std::int16_t> negative = turned;
              for (std::int16_t& tap : negative) tap = static_cast<std::int16_t>(-tap);
              EXPECT_TRUE(product.row == turned || product.row == negative)
                  << wavelength_px << " " << sigma_factor << " " << gamma;
            }
          }
        }
      }
    }
  }
}

TEST(V1Cells, RespondsAsTheModelInDoublePrecision) {
  const cv::Mat1b image = reference::texture({80, 60}, 3);
  for (const V1Settings& settings : all_settings()) {
    V1Cells cells(settings);
    V1Responses fast;
    cells.respond(image, 0, true, fast);
    const reference::V1Reference exact = reference::respond(image, settings);
    for (std::size_t i = 0; i < kOrientations; ++i) {
      double error = 0.0, size = 0.0;
      for (int y = 0; y < image.rows; ++y) {
        for (int x = 0; x < image.cols; ++x) {
          const double even = fast.even[i].row(y)[x] / fast.gain - exact.even[i](y, x);
          const double odd = fast.odd[i].row(y)[x] / fast.gain - exact.odd[i](y, x);
          error += even * even + odd * odd;
          size += exact.energy[i](y, x);
        }
      }
      // What rank 3 leaves out of the envelope and what rounding adds.
      EXPECT_LT(std::sqrt(error / size), 0.02)
          << "lambda " << settings.wavelength_px << ", orientation " << i;
    }
  }
}

TEST(V1Cells, DoNotRespondToAUniformSurfaceOfAnyBrightness) {
  for (const EvenMean mean : {EvenMean::flat, EvenMean::envelope}) {
    V1Cells cells({4.0, 0.4, 0.5, mean});
    for (const int grey : {0, 77, 255}) {
      V1Responses fast;
      cells.respond(cv::Mat1b(30, 40, static_cast<std::uint8_t>(grey)), 0, true, fast);
      for (std::size_t i = 0; i < kOrientations; ++i) {
        // At most one grey level's worth of the largest response to a full-contrast edge.
        EXPECT_LE(std::abs(fast.even[i].row(15)[20]), fast.gain) << grey;
        EXPECT_LE(std::abs(fast.odd[i].row(15)[20]), fast.gain) << grey;
      }
    }
  }
}

TEST(V1Cells, PreferTheGratingOfTheirOrientation) {
  V1Cells cells({});
  for (int preferred = 0; preferred < kOrientations; ++preferred) {
    const double theta = preferred * std::numbers::pi / kOrientations;
    cv::Mat1b grating(40, 40);
    for (int y = 0; y < 40; ++y) {
      for (int x = 0; x < 40; ++x) {
        const double along = x * std::cos(theta) + y * std::sin(theta);
        grating(y, x) = cv::saturate_cast<std::uint8_t>(
            128.0 + 100.0 * std::cos(2.0 * std::numbers::pi * along / 4.0));
      }
    }
    V1Responses fast;
    cells.respond(grating, 0, false, fast);
    for (int i = 0; i < kOrientations; ++i) {
      if (i == preferred) continue;
      EXPECT_GT(fast.code[static_cast<std::size_t>(preferred)].row(20)[20],
                fast.code[static_cast<std::size_t>(i)].row(20)[20]);
    }
  }
}

TEST(V1Cells, CodesAreTheLogarithmOfTheEnergy) {
  V1Cells cells({});
  V1Responses fast;
  cells.respond(reference::texture({40, 30}, 9), 0, true, fast);
  for (int x = 0; x < 40; ++x) {
    const double even = fast.even[3].row(10)[x], odd = fast.odd[3].row(10)[x];
    const double exact = std::sqrt(even * even + odd * odd);
    EXPECT_NEAR(complex_response(fast.code[3].row(10)[x]), exact, 0.001 * exact + 1.0);
  }
}

TEST(V1Cells, ContinueTheCodesBeyondTheBorder) {
  V1Cells cells({});
  V1Responses fast;
  cells.respond(reference::texture({20, 10}, 2), 5, false, fast);
  EXPECT_EQ(fast.code[1].row(-5)[-5], fast.code[1].row(0)[0]);
  EXPECT_EQ(fast.code[1].row(14)[24], fast.code[1].row(9)[19]);
  EXPECT_EQ(fast.code[1].row(4)[24], fast.code[1].row(4)[19]);
}

TEST(V1Cells, RefuseAnEmptyImage) {
  V1Cells cells({});
  V1Responses fast;
  EXPECT_THROW(cells.respond(cv::Mat1b(), 0, false, fast), std::invalid_argument);
}

}  // namespace
}  // namespace striate::perception
