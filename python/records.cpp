#include "striate/python/records.hpp"

#include "striate/perception/recognition/landmark_view.hpp"

namespace striate::python {

using perception::Column;
using perception::Keypoint;
using perception::Match;
using perception::MovingThing;
using perception::NearestTwo;
using perception::Obstacle;
using perception::SalientRegion;
using perception::ViewKeypoint;

void describe_records() {
  PYBIND11_NUMPY_DTYPE(Column, bearing_rad, free_from_m, free_to_m, free_confidence, obstacle_m,
                       obstacle_confidence, hidden_from_m, hidden_to_m, moving);
  PYBIND11_NUMPY_DTYPE(Obstacle, bearing_rad, distance_m, width_m, height_m, confidence, from_u_px,
                       to_u_px);
  PYBIND11_NUMPY_DTYPE(MovingThing, bearing_rad, distance_m, width_m, confidence, velocity_known,
                       forward_m_s, left_m_s, from_u_px, to_u_px);
  PYBIND11_NUMPY_DTYPE(SalientRegion, u_px, v_px, width_px, height_px, salience, bearing_rad,
                       distance_m);
  // The descriptor of each is an array of its own: 32 bytes, of which a field would make words.
  PYBIND11_NUMPY_DTYPE(Keypoint, u_px, v_px, wavelength_px, angle_rad, response);
  PYBIND11_NUMPY_DTYPE(ViewKeypoint, x_px, y_px, size_px, angle_rad);
  PYBIND11_NUMPY_DTYPE(Match, query, stored, distance_bits);
  PYBIND11_NUMPY_DTYPE(NearestTwo, first, second, first_bits, second_bits);
  PYBIND11_NUMPY_DTYPE(RangeReading, bearing_rad, distance_m);
}

}  // namespace striate::python
