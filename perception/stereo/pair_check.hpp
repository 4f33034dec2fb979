#pragma once

#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

namespace striate::perception {

/// What corners that both images show say about a pair: whether its eyes stand side by side, the
/// left one left, with rows that agree. Stereo takes all of it for granted and answers something
/// for any two pictures.
struct PairCheck {
  struct Shift {
    double left_px = 0.0;  ///< how far left of its place in the left image the right one shows it
    double down_px = 0.0;  ///< how far below it
  };
  std::vector<Shift> shifts;  ///< of every corner that was found again, px of the working width
  double width_px = 0.0;      ///< that they are measured at

  /// Those of another pair of the same camera are counted with them.
  void add(const PairCheck& other);
};

/// Corners of the left image, found again anywhere in the right one. Some ten milliseconds.
/// @param left, right grey, of one size; others give no shifts
[[nodiscard]] PairCheck check_pair(const cv::Mat1b& left, const cv::Mat1b& right);

enum class PairFault {
  none,
  unknown,    ///< too few corners: nothing can be said
  same,       ///< one picture twice, to the pixel
  flat,       ///< nothing is nearer than infinity: most likely one picture twice
  exchanged,  ///< the left eye's image is given as the right one's
  rows,       ///< rows lie at different heights
  unrectified,
  behind  ///< much is farther than infinity: the principal points differ
};

[[nodiscard]] PairFault fault_of(const PairCheck& check);

/// The fault in a sentence for a person, without the way to mend it, which depends on who asks;
/// "": there is none, or nothing can be said. @param width_px of the images that it speaks of
[[nodiscard]] std::string fault_text(const PairCheck& check, double width_px);

/// What to do about it: "" as above.
[[nodiscard]] std::string fault_hint(PairFault fault);

}  // namespace striate::perception
