#include <gtest/gtest.h>

#include "striate/perception/stereo/match_kernels.hpp"
#include "striate/perception/stereo/median_kernel.hpp"
#include "striate/perception/stereo/phase_costs.hpp"
#include "striate/perception/stereo/semi_global.hpp"
#include "striate/perception/stereo/winner_kernels.hpp"
#include "tests/reference/every_target.hpp"
#include "tests/reference/semi_global_reference.hpp"
#include "tests/reference/stereo_reference.hpp"
#include "tests/reference/test_images.hpp"

namespace striate::perception {
namespace {

using reference::hash_noise;

Plane<std::uint8_t> outside_plane(int width, int margin) {
  Plane<std::uint8_t> outside;
  outside.resize(width, 1, margin, 0);
  std::fill(outside.row(0) - outside.margin(), outside.row(0), std::uint8_t{255});
  return outside;
}

struct DescriptorRows {
  Plane<std::uint8_t> left, right;
};

/// Bits by chance; where `agreeing`, only one plane has any, so that many distances are equal.
DescriptorRows random_rows(int width, bool agreeing) {
  DescriptorRows rows;
  rows.left.resize(width, kDescriptorPoints, 0, 0);
  rows.right.resize(width, kDescriptorPoints, stereo_kernels::kReachBack, 0);
  for (int p = 0; p < kDescriptorPoints; ++p) {
    for (int x = 0; x < width; ++x) {
      const bool blank = agreeing && p > 0;
      rows.left.row(p)[x] = blank ? 0 : static_cast<std::uint8_t>(hash_noise(x, p, 1));
      rows.right.row(p)[x] = blank ? 0 : static_cast<std::uint8_t>(hash_noise(x, p, 2));
    }
  }
  return rows;
}

void expect_best_matches(const DescriptorRows& rows, int candidates, const std::string& what) {
  const int width = rows.left.width();
  const Plane<std::uint8_t> outside = outside_plane(width, stereo_kernels::kReachBack);
  Plane<std::uint8_t> found, nibbles;
  found.resize(width, 2, 0, 0);
  nibbles.resize(width, stereo_kernels::kNibbleRows, 0, 0);
  stereo_kernels::best_matches({{const_cast<std::uint8_t*>(rows.left.row(0)), rows.left.stride()},
                                {const_cast<std::uint8_t*>(rows.right.row(0)), rows.right.stride()},
                                outside.row(0),
                                width,
                                candidates,
                                found.row(0),
                                found.row(1),
                                nibbles.row(0)});
  for (int x = 0; x < width; ++x) {
    int smallest = 255, best = 0;
    for (int d = 0; d < std::min(candidates, x + 1); ++d) {
      int bits = 0;
      for (int p = 0; p < kDescriptorPoints; ++p) {
        bits +=
            std::popcount(static_cast<unsigned>(rows.left.row(p)[x] ^ rows.right.row(p)[x - d]));
      }
      if (bits < smallest) smallest = bits, best = d;
    }
    ASSERT_EQ(found.row(1)[x], best) << what << " at " << x << " of " << width;
    ASSERT_EQ(found.row(0)[x], smallest) << what << " at " << x << " of " << width;
  }
}

TEST(BestMatches, HaveTheFewestBitsThatDifferOnEveryInstructionSet) {
  reference::on_every_target([&](const std::string& name) {
    for (const int width : {1, 7, 33, 64, 65, 97, 160, 230, 401}) {
      for (const int candidates : {1, 5, 24, 64, 150, 256}) {
        expect_best_matches(random_rows(width, false), candidates, name);
      }
    }
  });
}

TEST(BestMatches, OfEqualOnesTheSmallestDisparityWinsOnEveryInstructionSet) {
  reference::on_every_target([&](const std::string& name) {
    for (const int width : {40, 200}) expect_best_matches(random_rows(width, true), 150, name);
  });
}

TEST(BestMatches, CountAllBitsDifferingAs255) {
  DescriptorRows rows = random_rows(70, false);
  for (int p = 0; p < kDescriptorPoints; ++p) {
    std::fill(rows.left.row(p), rows.left.row(p) + 70, std::uint8_t{0});
    std::fill(rows.right.row(p), rows.right.row(p) + 70, std::uint8_t{255});
  }
  reference::on_every_target([&](const std::string& name) { expect_best_matches(rows, 20, name); });
}

TEST(Median, IsThatOf25PixelsOnEveryInstructionSet) {
  for (const cv::Size size : {cv::Size(160, 12), cv::Size(67, 5), cv::Size(3, 2), cv::Size(1, 1)}) {
    for (const int levels : {2, 5, 256}) {
      cv::Mat1b image(size);
      Plane<std::uint8_t> values, median;
      values.resize(size.width, size.height, 2, 0);
      for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
          image(y, x) = static_cast<std::uint8_t>((hash_noise(x, y, 1) & 255) * levels / 256);
          values.row(y)[x] = image(y, x);
        }
      }
      const cv::Mat1b expected = reference::median5(image);
      reference::on_every_target([&](const std::string& name) {
        stereo_kernels::median_5x5(values, median);
        for (int y = 0; y < size.height; ++y) {
          for (int x = 0; x < size.width; ++x) {
            ASSERT_EQ(median.row(y)[x], expected(y, x)) << name << " at " << x << ", " << y;
          }
        }
      });
    }
  }
}

TEST(PhaseCosts, AreTheDistancesOf256BitDescriptorsOnEveryInstructionSet) {
  constexpr int kColumns = 70, kRows = 9, kDisparities = 16;
  V1Cells cells({3.0, 0.3, 1.0, EvenMean::envelope});
  std::array<PhaseCodes, 2> codes;
  for (int eye = 0; eye < 2; ++eye) {
    V1Responses responses;
    cells.respond(reference::texture({kColumns, kRows}, eye), 0, true, responses);
    phase_codes(responses, eye * kDisparities, codes[static_cast<std::size_t>(eye)]);
  }
  const Plane<std::uint8_t> outside = outside_plane(kColumns, kDisparities);
  reference::on_every_target([&](const std::string& name) {
    PhaseCosts phase_costs;
    Volume<std::uint8_t> costs;
    costs.resize(kRows, kDisparities, kColumns);
    for (int y = 0; y < kRows; ++y) {
      phase_costs.compute_row({codes[0], codes[1], outside, costs}, y);
      for (int x = 0; x < kColumns; ++x) {
        for (int d = 0; d < kDisparities; ++d) {
          int expected = 0;
          for (const DescriptorPoint& point : kPhasePoints) {
            for (std::size_t k = 0; k < kPhaseBytes; ++k) {
              expected += std::popcount(
                  static_cast<unsigned>(codes[0].bytes[k].row(y + point.dv)[x + point.du] ^
                                        codes[1].bytes[k].row(y + point.dv)[x - d + point.du]));
            }
          }
          expected = d > x ? 255 : std::min(255, expected);
          ASSERT_EQ(costs.line(y)[d * costs.stride() + x], expected)
              << name << " at " << x << ", " << y << ", disparity " << d;
        }
      }
    }
  });
}

reference::CostCube random_cube(int width, int height, int disparities) {
  reference::CostCube cube(width, height, disparities);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int d = 0; d < disparities; ++d) {
        cube.at(y, x, d) = d > x ? 255 : hash_noise(x * 64 + d, y, 3) % 140;
      }
    }
  }
  return cube;
}

TEST(SemiGlobal, SumsThePathCostsOfThePlainReferenceOnEveryInstructionSet) {
  constexpr int kP1 = 20, kP2 = 80;
  for (const cv::Size size : {cv::Size(70, 18), cv::Size(5, 3), cv::Size(1, 1)}) {
    constexpr int kDisparities = 12;
    const reference::CostCube cube = random_cube(size.width, size.height, kDisparities);
    Volume<std::uint8_t> costs;
    costs.resize(size.height, kDisparities, size.width);
    for (int y = 0; y < size.height; ++y) {
      for (int d = 0; d < kDisparities; ++d) {
        for (int x = 0; x < size.width; ++x) {
          costs.line(y)[d * costs.stride() + x] = static_cast<std::uint8_t>(cube.at(y, x, d));
        }
      }
    }
    std::vector<reference::CostCube> steep, level;
    for (const int dx : {-1, 0, 1}) {
      steep.push_back(reference::path_costs(cube, 1, dx, kP1, kP2));
      steep.push_back(reference::path_costs(cube, -1, dx, kP1, kP2));
    }
    level.push_back(reference::path_costs(cube, 0, 1, kP1, kP2));
    level.push_back(reference::path_costs(cube, 0, -1, kP1, kP2));
    reference::on_every_target([&](const std::string& name) {
      SemiGlobal semi_global(kP1, kP2);
      semi_global.begin(costs, size.height);
      for (int y = 0; y < size.height; ++y) semi_global.take_row(y);
      for (int y = size.height - 1; y >= 0; --y) {
        const SmoothedCosts smoothed = semi_global.finish_row(y);
        for (int x = 0; x < size.width; ++x) {
          for (int d = 0; d < kDisparities; ++d) {
            int sum = 0;
            for (const auto& path : steep) sum += path.at(y, x, d);
            ASSERT_EQ(smoothed.steep_sums[d * smoothed.sum_stride + x], sum)
                << name << " at " << x << ", " << y << ", disparity " << d;
            const int mean = (level[0].at(y, x, d) + level[1].at(y, x, d) + 1) / 2;
            ASSERT_EQ(smoothed.level_means[d * smoothed.mean_stride + x], mean) << name;
          }
        }
      }
    });
  }
}

TEST(FindWinners, NameWinnerRunnerUpAndTheRightImagesWinnerOnEveryInstructionSet) {
  constexpr int kColumns = 45, kDisparities = 20;
  Volume<std::uint16_t> steep;
  Volume<std::uint8_t> level, costs;
  costs.resize(1, kDisparities, kColumns);
  steep.resize(1, kDisparities, kColumns);
  level.resize(1, kDisparities, kColumns);
  auto sum = [&](int x, int d) {
    if (x >= kColumns || d > x) return 65535;
    return hash_noise(x, d, 1) % 900 + 2 * (hash_noise(x, d, 2) % 200);
  };
  for (int d = 0; d < kDisparities; ++d) {
    for (int x = 0; x < kColumns; ++x) {
      steep.line(0)[d * steep.stride() + x] = static_cast<std::uint16_t>(hash_noise(x, d, 1) % 900);
      level.line(0)[d * level.stride() + x] = static_cast<std::uint8_t>(hash_noise(x, d, 2) % 200);
      costs.line(0)[d * costs.stride() + x] = static_cast<std::uint8_t>(hash_noise(x, d, 3));
    }
  }
  const Plane<std::uint8_t> outside = outside_plane(kColumns, kDisparities + 4);
  reference::on_every_target([&](const std::string& name) {
    Plane<std::uint16_t> sums, rows;
    sums.resize(kColumns, kDisparities, kDisparities + 64, 0);
    rows.resize(kColumns, 5, 0, 0);
    for (int d = 0; d < kDisparities; ++d) {
      std::fill(sums.row(d), sums.row(d) - sums.margin() + sums.stride(), std::uint16_t{65535});
    }
    stereo_kernels::find_winners({steep.line(0), steep.stride(), level.line(0), level.stride(),
                                  costs.line(0), outside.row(0), kColumns, kDisparities},
                                 {sums.row(0), sums.stride(), rows.row(0), rows.row(1), rows.row(2),
                                  rows.row(3), rows.row(4)});
    for (int x = 0; x < kColumns; ++x) {
      int best = 0, right_best = 0, second = 65535, raw_second = 255;
      for (int d = 1; d < kDisparities; ++d) {
        if (sum(x, d) < sum(x, best)) best = d;
        if (sum(x + d, d) < sum(x + right_best, right_best)) right_best = d;
      }
      for (int d = 0; d < kDisparities; ++d) {
        if (std::abs(d - best) <= 1) continue;
        second = std::min(second, sum(x, d));
        raw_second = std::min<int>(raw_second, static_cast<std::uint8_t>(hash_noise(x, d, 3)));
      }
      ASSERT_EQ(rows.row(0)[x], best) << name;
      ASSERT_EQ(rows.row(1)[x], sum(x, best)) << name;
      ASSERT_EQ(rows.row(2)[x], second) << name;
      ASSERT_EQ(rows.row(3)[x], raw_second) << name;
      ASSERT_EQ(rows.row(4)[x], right_best) << name;
    }
  });
}

}  // namespace
}  // namespace striate::perception
