#include "striate/perception/descriptor/striate_descriptor.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace striate::perception {
namespace {

using pooling_kernels::kWindowSide_px;

/// A frame's diameter, px, where it is looked at; half the resolution lost nothing (patches)
constexpr double kPixelsPerSize = 2.0;
/// Window pixels before the place: 5.35 px of radius, and the taps of sigma 1.25 px
constexpr int kBeforeKeypoint_px = 11;
constexpr int kReach_px = kWindowSide_px - kBeforeKeypoint_px;  ///< more than behind it
constexpr int kPartsOfPixel = 16;    ///< of a pixel: places are rounded by at most 1/32 px
constexpr double kTapSum = 32768.0;  ///< 1 in fixed point: 16 bits hold a signed product's 15

struct CircleShape {
  int points;
  double radius_px, sigma_px, turn;
};
/// Chosen by patches of the Oxford sequences ("what was tried", tests/evaluation)
constexpr CircleShape kCircles[] = {
    {1, 0.0, 0.84, 0.0}, {6, 2.08, 0.91, 0.0}, {8, 4.05, 1.19, 0.5}, {10, 5.35, 1.25, 0.0}};

V1Settings envelope_v1() {
  return {3.0, 0.3, 1.0, EvenMean::envelope};
}

int parts_of(double at_px) {
  return static_cast<int>(at_px * kPartsOfPixel + 0.5);
}

/// Of the middle tap: beyond 2.65 sigma nothing is pooled, exp(-2.65^2 / 2) = 0.03.
constexpr double kLeastTap = 0.03;

/// Gaussian taps around a place so many parts of a pixel behind the middle left one.
std::vector<std::int16_t> gaussian_taps(int taps, double sigma_px, int part) {
  const int middle = taps / 2 - 1;
  const double behind = static_cast<double>(part) / kPartsOfPixel;
  std::vector<double> row(static_cast<std::size_t>(taps));
  double sum = 0.0;
  for (int k = 0; k < taps; ++k) {
    const double d = k - middle - behind;
    const double value = std::exp(-d * d / (2.0 * sigma_px * sigma_px));
    row[static_cast<std::size_t>(k)] = value < kLeastTap ? 0.0 : value;
    sum += row[static_cast<std::size_t>(k)];
  }
  std::vector<std::int16_t> result(row.size());
  std::ranges::transform(row, result.begin(), [sum](double value) {
    return static_cast<std::int16_t>(std::lround(kTapSum * value / sum));
  });
  return result;
}

/// Cuts zeros off at both ends. @return how many at the front.
int cut_zeros(std::vector<std::int16_t>& taps) {
  while (taps.back() == 0) taps.pop_back();
  const auto first = std::ranges::find_if(taps, [](int tap) { return tap != 0; });
  const auto cut = static_cast<int>(first - taps.begin());
  taps.erase(taps.begin(), first);
  return cut;
}

Descriptor bits_of(const PooledResponses& pooled, const StriateTable& table) {
  std::int64_t sum = 0;
  for (const std::int32_t value : pooled) sum += value;
  Descriptor descriptor;
  const StriateBit* bit = table.data();
  for (std::uint64_t& word : descriptor.words) {
    std::uint64_t bits = 0;
    for (int b = 0; b < 64; ++b, ++bit) {
      const std::int64_t difference = pooled[static_cast<std::size_t>(bit->first)] -
                                      pooled[static_cast<std::size_t>(bit->second)];
      const bool larger = difference * 1000 * kPooledValues > sum * bit->threshold;
      bits |= std::uint64_t{larger} << b;
    }
    word = bits;
  }
  return descriptor;
}

void check(const DescribedFrame& frame) {
  if (!(frame.size_px > 0.0) ||
      !std::isfinite(frame.u_px + frame.v_px + frame.size_px + frame.angle_rad)) {
    throw std::invalid_argument("StriateDescriber: a frame has no size or no finite place");
  }
}

/// Angle as steps of pi / 8 and 1/32768 of the next; responses as large as 14 bits can hold.
pooling_kernels::Turn turn_of_box(double angle_rad, std::int16_t largest) {
  const double steps = angle_rad * kOrientations / std::numbers::pi;
  const double within = steps - kPooledChannels * std::floor(steps / kPooledChannels);
  pooling_kernels::Turn turn;
  turn.steps = static_cast<int>(within) % kPooledChannels;
  turn.fraction = static_cast<std::int16_t>(
      std::min(32767L, std::lround(32768.0 * (within - std::floor(within)))));
  // Contrast does not count: weak responses are enlarged so that rounding does not tell.
  const auto used = static_cast<int>(std::bit_width(static_cast<unsigned>(largest)));
  turn.factor = static_cast<std::int16_t>(1 << std::clamp(14 - used, 0, 13));
  return turn;
}

DominantAngles angles_at(const DescribedPlace& place) {
  pooling_kernels::OddWindow at = place.window;
  const int u = static_cast<int>(place.u), v = static_cast<int>(place.v);
  for (const std::int16_t*& plane : at.odd) plane += v * at.stride + u;
  return dominant_angles(at, place.u - u, place.v - v);
}

/// The box around the frames of one level.
struct PartBox {
  double left = std::numeric_limits<double>::infinity(), top = left;
  double right = -left, bottom = -left;

  void add(const DescribedFrame& frame) {
    left = std::min(left, frame.u_px), right = std::max(right, frame.u_px);
    top = std::min(top, frame.v_px), bottom = std::max(bottom, frame.v_px);
  }
  [[nodiscard]] cv::Rect2d rect() const { return {left, top, right - left, bottom - top}; }
};

}  // namespace

StriateDescriber::StriateDescriber(const StriateSettings& settings)
    : settings_(settings), scales_(envelope_v1(), kReach_px) {
  turned_window_.resize(pooling_kernels::kWindowValues);
  for (const CircleShape& shape : kCircles) {
    Circle circle;
    const int taps = 2 * static_cast<int>(2.65 * shape.sigma_px) + 2;
    for (int k = 0; k < shape.points; ++k) {
      const double angle = 2.0 * std::numbers::pi * (k + shape.turn) / shape.points;
      circle.points.emplace_back(shape.radius_px * std::cos(angle),
                                 shape.radius_px * std::sin(angle));
    }
    for (int part = 0; part < kPartsOfPixel; ++part) {
      Taps& row = circle.rows.emplace_back();
      row.taps = gaussian_taps(taps, shape.sigma_px, part);
      row.first_px = 1 - taps / 2 + cut_zeros(row.taps);
    }
    circles_.push_back(std::move(circle));
  }
}

void StriateDescriber::prepare(const cv::Mat1b& grey) {
  scales_.prepare(grey);
}

/// @param see called with each frame's index and place, level by level.
template <class See>
void StriateDescriber::visit(std::span<const DescribedFrame> frames, See see) {
  levels_.clear();
  for (const DescribedFrame& frame : frames) {
    check(frame);
    levels_.push_back(scales_.level_of(frame.size_px / kPixelsPerSize));
  }
  if (frames.empty()) return;
  const auto [lowest, highest] = std::ranges::minmax(levels_);
  for (int level = lowest; level <= highest; ++level) {
    PartBox box;
    for (std::size_t k = 0; k < frames.size(); ++k) {
      if (levels_[k] == level) box.add(frames[k]);
    }
    if (box.left > box.right) continue;
    const V1Field field = scales_.respond(level, box.rect());
    for (std::size_t k = 0; k < frames.size(); ++k) {
      if (levels_[k] != level) continue;
      const double u = field.u_of(frames[k].u_px);
      const double v = field.v_of(frames[k].v_px);
      const int left = static_cast<int>(u) - kBeforeKeypoint_px,
                top = static_cast<int>(v) - kBeforeKeypoint_px;
      DescribedPlace place{{}, u - left, v - top, 0};
      place.window.stride = field.responses->odd[0].stride();
      for (std::size_t i = 0; i < kOrientations; ++i) {
        place.window.odd[i] = field.responses->odd[i].row(top) + left;
      }
      place.largest = pooling_kernels::largest_response(place.window);
      see(k, place);
    }
  }
}

void StriateDescriber::pool_place(const DescribedPlace& place, double angle_rad,
                                  PooledResponses& out) {
  pooling_kernels::turn_window(place.window, turn_of_box(angle_rad, place.largest),
                               turned_window_.data());
  std::array<pooling_kernels::Pool, kPooledPoints> pools;
  const double along = std::cos(angle_rad), across = std::sin(angle_rad);
  std::size_t at = 0;
  for (const Circle& circle : circles_) {
    for (const cv::Point2d& point : circle.points) {
      // In whole parts of a pixel; the window begins at 0.
      const int u = parts_of(place.u + along * point.x - across * point.y);
      const int v = parts_of(place.v + across * point.x + along * point.y);
      const Taps& columns = circle.rows[static_cast<std::size_t>(u % kPartsOfPixel)];
      const Taps& rows = circle.rows[static_cast<std::size_t>(v % kPartsOfPixel)];
      pools[at++] = {(v / kPartsOfPixel + rows.first_px) * kWindowSide_px + u / kPartsOfPixel +
                         columns.first_px,
                     static_cast<int>(columns.taps.size()), static_cast<int>(rows.taps.size()),
                     columns.taps.data(), rows.taps.data()};
    }
  }
  std::array<std::int16_t, kPooledValues> sums{};
  pooling_kernels::pool(turned_window_.data(), pools, sums.data());
  std::ranges::copy(sums, out.begin());
}

void StriateDescriber::pool(std::span<const DescribedFrame> frames,
                            std::vector<PooledResponses>& out) {
  out.resize(frames.size());
  visit(frames, [&](std::size_t k, const DescribedPlace& place) {
    pool_place(place, frames[k].angle_rad, out[k]);
  });
}

void StriateDescriber::describe_oriented(std::span<const DescribedFrame> frames, bool second,
                                         std::vector<DescribedFrame>& turned,
                                         std::vector<Descriptor>& out) {
  angles_.resize(frames.size());
  pairs_.resize(frames.size());
  visit(frames, [&](std::size_t k, const DescribedPlace& place) {
    DominantAngles& angles = angles_[k];
    angles = angles_at(place);
    if (!second) angles.count = 1;
    for (std::size_t a = 0; a < angles.count; ++a) {
      pool_place(place, angles.angle_rad[a], one_);
      pairs_[k][a] = bits_of(one_, settings_.table);
    }
  });
  turned.clear();
  out.clear();
  for (std::size_t k = 0; k < frames.size(); ++k) {
    for (std::size_t a = 0; a < angles_[k].count; ++a) {
      turned.push_back(frames[k]);
      turned.back().angle_rad = angles_[k].angle_rad[a];
      out.push_back(pairs_[k][a]);
    }
  }
}

void StriateDescriber::describe(std::span<const DescribedFrame> frames,
                                std::vector<Descriptor>& out) {
  if (settings_.orientation == StriateOrientation::dominant) {
    describe_oriented(frames, false, turned_, out);
    return;
  }
  const bool upright = settings_.orientation == StriateOrientation::upright;
  out.resize(frames.size());
  visit(frames, [&](std::size_t k, const DescribedPlace& place) {
    pool_place(place, upright ? 0.0 : frames[k].angle_rad, one_);
    out[k] = bits_of(one_, settings_.table);
  });
}

}  // namespace striate::perception
