#include "striate/perception/lines/lines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "striate/base/user_error.hpp"

namespace striate::perception {
namespace {

V1Settings line_v1(const LineSettings& settings) {
  if (!(settings.wavelength_px >= 3.0 && settings.wavelength_px <= 12.0)) {
    throw UserError("lines: the wavelength must be 3 .. 12 px");
  }
  V1Settings v1;
  v1.wavelength_px = settings.wavelength_px;
  return v1;
}

/// The complex response between pixels, from its codes.
double bilinear(const Plane<std::int16_t>& codes, double u, double v) {
  const int left = static_cast<int>(std::floor(u)), top = static_cast<int>(std::floor(v));
  const double a = u - left, b = v - top;
  auto pixel = [&](int du, int dv) -> double {
    return complex_response(codes.row(top + dv)[left + du]);
  };
  return (1 - b) * ((1 - a) * pixel(0, 0) + a * pixel(1, 0)) +
         b * ((1 - a) * pixel(0, 1) + a * pixel(1, 1));
}

/// Responses at the pixel before, at it and behind it, along the axis nearer to `across`.
using Three = std::array<double, 3>;

struct Crossing {
  double at_px = 0.0;  ///< from the middle pixel, -0.5 .. 0.5
  double extreme = 0.0;
};

/// Where `crossing` is zero nearest to the middle pixel, while `extreme` has a peak of its own sign
/// there. Half open: between two pixels the first one has it.
std::optional<Crossing> crossing_at(const Three& crossing, const Three& extreme) {
  for (const int side : {-1, 1}) {
    const auto beside = static_cast<std::size_t>(1 + side);
    const double here = crossing[1], there = crossing[beside];
    if ((here <= 0.0) == (there <= 0.0) && here != 0.0) continue;
    const double share = here == 0.0 ? 0.0 : here / (here - there);
    if (share > 0.5 || (share == 0.5 && side < 0)) continue;
    const double peak = (1.0 - share) * extreme[1] + share * extreme[beside];
    const double around = (extreme[0] + extreme[2]) / 2.0;
    if (peak > 0.0 ? peak <= around : peak >= around) continue;
    return Crossing{side * share, peak};
  }
  return std::nullopt;
}

}  // namespace

LineFinder::LineFinder(const LineSettings& settings)
    : settings_(settings), cells_(line_v1(settings)) {
  for (std::size_t i = 0; i < kOrientations; ++i) {
    const double theta = static_cast<double>(i) * std::numbers::pi / kOrientations;
    cos_[i] = std::cos(theta);
    sin_[i] = std::sin(theta);
  }
}

void LineFinder::look_at(int u, int v, LinesAndEdges& out) const {
  std::size_t best = 0;
  for (std::size_t i = 1; i < kOrientations; ++i) {
    if (responses_.code[i].row(v)[u] > responses_.code[best].row(v)[u]) best = i;
  }
  if (complex_response(responses_.code[best].row(v)[u]) <= least_) return;
  const bool along_u = std::abs(cos_[best]) >= std::abs(sin_[best]);
  // theta is below pi: only the cosine can be negative.
  const int du = along_u ? (cos_[best] < 0.0 ? -1 : 1) : 0, dv = along_u ? 0 : 1;
  auto three = [&](const Plane<std::int16_t>& plane) -> Three {
    return {static_cast<double>(plane.row(v - dv)[u - du]), static_cast<double>(plane.row(v)[u]),
            static_cast<double>(plane.row(v + dv)[u + du])};
  };
  const Three even = three(responses_.even[best]), odd = three(responses_.odd[best]);
  if (const auto line = crossing_at(odd, even)) {
    note({line->extreme > 0.0 ? EventKind::line_positive : EventKind::line_negative,
          u + du * line->at_px, v + dv * line->at_px},
         best, out);
  }
  if (const auto edge = crossing_at(even, odd)) {
    note({edge->extreme > 0.0 ? EventKind::edge_positive : EventKind::edge_negative,
          u + du * edge->at_px, v + dv * edge->at_px},
         best, out);
  }
}

/// Ours: the cells' side lobes make events of the other kind lambda / 4 beside a contour; the
/// complex response is larger on the contour itself.
void LineFinder::note(ContourEvent event, std::size_t orientation, LinesAndEdges& out) const {
  auto complex_at = [&](double across_px) {
    return bilinear(responses_.code[orientation], event.u_px + across_px * cos_[orientation],
                    event.v_px + across_px * sin_[orientation]);
  };
  const double strength = complex_at(0.0), side_px = 0.25 * settings_.wavelength_px;
  if (complex_at(-side_px) > strength || complex_at(side_px) > strength) return;
  event.across_rad = static_cast<double>(orientation) * std::numbers::pi / kOrientations;
  event.strength = strength / responses_.gain;
  out.events.push_back(event);
}

void LineFinder::find(const cv::Mat1b& grey, LinesAndEdges& out) {
  if (grey.empty()) throw std::invalid_argument("LineFinder: the image is empty");
  out.events.clear();
  cells_.respond(grey, 0, true, responses_);
  std::int16_t largest = std::numeric_limits<std::int16_t>::min();
  for (const auto& plane : responses_.code) {
    for (int v = 0; v < grey.rows; ++v) {
      largest = std::max(largest, *std::max_element(plane.row(v), plane.row(v) + grey.cols));
    }
  }
  // What rounding leaves on a blank image is no contour.
  // Units of strength that rounding leaves on a blank image: no contour
  constexpr double kRounding = 4.0;
  least_ = std::max(kRounding, settings_.threshold * complex_response(largest));
  // Furthest sample: lambda / 4 beyond an event 0.5 px away, and its right neighbour.
  const int border = static_cast<int>(std::ceil(0.25 * settings_.wavelength_px)) + 2;
  for (int v = border; v < grey.rows - border; ++v) {
    for (int u = border; u < grey.cols - border; ++u) look_at(u, v, out);
  }
}

LinesAndEdges find_lines_and_edges(const cv::Mat1b& grey, const LineSettings& settings) {
  LinesAndEdges found;
  LineFinder(settings).find(grey, found);
  return found;
}

}  // namespace striate::perception
