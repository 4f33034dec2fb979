#pragma once

#include <array>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "striate/config/settings.hpp"
#include "striate/perception/v1/v1_cells.hpp"

namespace striate::perception {

enum class EventKind { line_positive, line_negative, edge_positive, edge_negative };

/// A pixel's worth of a line or an edge.
struct ContourEvent {
  EventKind kind = EventKind::line_positive;
  double u_px = 0.0;  ///< sub-pixel across the contour
  double v_px = 0.0;
  double across_rad =
      0.0;                ///< 0 .. pi, from u towards v: the direction across the contour, as the
                          ///< simple cells' theta. An edge is positive where it brightens that way
  double strength = 0.0;  ///< complex response, units of the image's grey times the kernel
};

struct LinesAndEdges {
  std::vector<ContourEvent> events;  ///< row by row
};

struct LineSettings {
  double wavelength_px = 4.0;  ///< px; the finest of the V1 model's scales (lambda = 4 .. 64)
  /// Of the largest complex response in the image (ours; the 2009 model gives none)
  double threshold = 0.1;
};

template <class V>
void visit(V& v, LineSettings& s) {
  using config::Unit;
  v.number("wavelength", s.wavelength_px, Unit::pixels, {3.0, 12.0}, "of the V1 cells");
  v.number("threshold", s.threshold, Unit::fraction, {0.0, 1.0}, "of the largest response");
}

/// Lines and edges from simple cells (Rodrigues and du Buf 2009): across the orientation of the
/// largest complex response, a line is an extremum of the even cells where the odd ones cross
/// zero, an edge an extremum of the odd cells where the even ones cross zero; the extremum's sign
/// is the event's. Keeps its buffers.
class LineFinder {
 public:
  /// Throws UserError for a wavelength out of 3 .. 12 px.
  explicit LineFinder(const LineSettings& settings);

  /// @param grey any size; empty throws std::invalid_argument. Nothing is found nearer to the
  ///        border than lambda / 4 and 2 px.
  void find(const cv::Mat1b& grey, LinesAndEdges& out);

 private:
  void look_at(int u, int v, LinesAndEdges& out) const;
  void note(ContourEvent event, std::size_t orientation, LinesAndEdges& out) const;

  LineSettings settings_;
  V1Cells cells_;
  V1Responses responses_;
  std::array<double, kOrientations> cos_{}, sin_{};
  double least_ = 0.0;  ///< strength, in units of the responses
};

[[nodiscard]] LinesAndEdges find_lines_and_edges(const cv::Mat1b& grey,
                                                 const LineSettings& settings);

}  // namespace striate::perception
