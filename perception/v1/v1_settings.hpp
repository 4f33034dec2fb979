#pragma once

#include <cmath>

#include "striate/config/settings.hpp"

namespace striate::perception {

inline constexpr int kOrientations = 8;  ///< theta_i = i * pi / 8

/// What is done about the even kernel's response to a uniform surface.
enum class EvenMean {
  kept,      ///< nothing
  flat,      ///< the kernel's mean is subtracted everywhere on its support (the paper's model)
  envelope,  ///< what is subtracted has the envelope's shape (a Morlet wavelet): nothing far away
             ///< leaks into the response, which matters for narrow envelopes. Ours.
};

/// The Gabor model of V1 simple cells (Rodrigues and du Buf 2006):
///   x' = x cos theta + y sin theta, y' = y cos theta - x sin theta
///   G(x, y) = exp(-(x'^2 + gamma y'^2) / (2 sigma^2)) cos(2 pi x' / lambda + phi)
/// with phi = 0 (even) and -pi/2 (odd), on a square support of side 5 lambda, made odd.
/// The defaults are the paper's.
struct V1Settings {
  double wavelength_px = 4.0;  ///< lambda of the paper's stereo
  /// Sigma = sigma_factor * lambda; V1 model (Rodrigues and du Buf 2006)
  double sigma_factor = 0.56;
  double gamma = 0.5;  ///< multiplies y'^2 directly: sigma_y = sigma / sqrt(gamma); same model
  EvenMean even_mean = EvenMean::flat;
};

template <class V>
void visit(V& v, V1Settings& s) {
  using config::Unit;
  v.number("wavelength", s.wavelength_px, Unit::pixels, {3.0, 12.0}, "of the Gabor carrier");
  v.number("sigma_factor", s.sigma_factor, Unit::none, {0.2, 1.0}, "envelope sigma / wavelength");
  v.number("gamma", s.gamma, Unit::none, {0.25, 2.0}, "shape of the envelope: factor of y'^2");
  v.choice("even_mean", s.even_mean, {"kept", "flat", "envelope"},
           "how the even kernel's mean is subtracted");
}

/// Side of the square support of a kernel: 5 lambda, made odd; radius = side / 2.
[[nodiscard]] inline int gabor_side(double wavelength_px) {
  const int side = static_cast<int>(std::lround(5.0 * wavelength_px));
  return side % 2 == 1 ? side : side + 1;
}

}  // namespace striate::perception
