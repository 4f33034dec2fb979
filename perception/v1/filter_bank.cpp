#include "striate/perception/v1/filter_bank.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace striate::perception {
namespace {

/// One product of the decomposition in real numbers; see FilterBank::Product.
struct RealProduct {
  Eigen::VectorXd row, even, odd;
  int slot = 0;
};

struct RealPair {
  int orientation = 0;
  std::vector<RealProduct> products;
};

Eigen::MatrixXd envelope(const V1Settings& s, double theta, int radius) {
  const double sigma = s.sigma_factor * s.wavelength_px;
  const int side = 2 * radius + 1;
  Eigen::MatrixXd result(side, side);
  for (int y = -radius; y <= radius; ++y) {
    for (int x = -radius; x <= radius; ++x) {
      const double along = x * std::cos(theta) + y * std::sin(theta);
      const double across = y * std::cos(theta) - x * std::sin(theta);
      result(y + radius, x + radius) =
          std::exp(-(along * along + s.gamma * across * across) / (2.0 * sigma * sigma));
    }
  }
  return result;
}

/// Sum of the even kernel as the model has it, mean kept.
double exact_even_sum(const V1Settings& s, int orientation, int radius) {
  const double theta = orientation * std::numbers::pi / kOrientations;
  const Eigen::MatrixXd full = envelope(s, theta, radius);
  double sum = 0.0;
  for (int y = -radius; y <= radius; ++y) {
    for (int x = -radius; x <= radius; ++x) {
      const double along = x * std::cos(theta) + y * std::sin(theta);
      sum +=
          full(y + radius, x + radius) * std::cos(2.0 * std::numbers::pi * along / s.wavelength_px);
    }
  }
  return sum;
}

/// Sum of the even kernel that the products make.
double even_sum(const std::vector<RealProduct>& products) {
  double sum = 0.0;
  for (const RealProduct& p : products) sum += p.row.sum() * p.even.sum();
  return sum;
}

/// The envelope's singular vectors times the carrier's cosine and sine along x and along y.
RealPair decompose_filter(const V1Settings& s, int orientation, int radius) {
  const Eigen::Index side = 2 * radius + 1;
  const double theta = orientation * std::numbers::pi / kOrientations;
  const double omega = 2.0 * std::numbers::pi / s.wavelength_px;
  const Eigen::MatrixXd full = envelope(s, theta, radius);
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(full, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const Eigen::VectorXd index =
      Eigen::VectorXd::LinSpaced(side, -static_cast<double>(radius), radius);
  const Eigen::ArrayXd phase_x = index.array() * omega * std::cos(theta);
  const Eigen::ArrayXd phase_y = index.array() * omega * std::sin(theta);
  const Eigen::VectorXd nothing = Eigen::VectorXd::Zero(side);
  RealPair pair{orientation, {}};
  std::vector<RealProduct> envelopes;
  for (int k = 0; k < FilterBank::kRank; ++k) {
    const double size = svd.singularValues()(k);
    if (size < 1e-6 * svd.singularValues()(0)) break;
    const Eigen::ArrayXd u = svd.matrixU().col(k).array() * size;
    Eigen::ArrayXd v = svd.matrixV().col(k).array();
    // Mirroring x leaves an even singular vector as it is and changes an odd one's sign; exactly
    // so after this, but for which row filters could not be folded.
    const bool even = (v - v.reverse()).abs().maxCoeff() < v.abs().maxCoeff() * 1e-3;
    const Eigen::ArrayXd mirrored = v.reverse();
    v = (v + (even ? 1.0 : -1.0) * mirrored) / 2.0;
    const Eigen::VectorXd cos_x = v * phase_x.cos();
    const Eigen::VectorXd sin_x = v * phase_x.sin();
    const Eigen::VectorXd cos_y = u * phase_y.cos();
    const Eigen::VectorXd sin_y = u * phase_y.sin();
    // Even response: cos(a + b) = cos a cos b - sin a sin b; odd: sin a cos b + cos a sin b.
    pair.products.push_back({cos_x, cos_y, sin_y, even ? 0 : 1});
    if (orientation != kOrientations / 2) {
      pair.products.push_back({sin_x, -sin_y, cos_y, even ? 1 : 0});
    }
    envelopes.push_back({v, u, nothing, even ? 0 : 1});
  }
  if (s.even_mean == EvenMean::envelope) {
    // The share of the envelope that makes the even kernel's sum zero.
    const double share = even_sum(pair.products) / even_sum(envelopes);
    for (RealProduct& p : envelopes) {
      p.even *= -share;
      pair.products.push_back(std::move(p));
    }
  }
  return pair;
}

/// Sum of the magnitudes of the 2-D kernel: bounds the response.
double l1_norm(const RealPair& pair, bool even_kernel) {
  const Eigen::Index side = pair.products.front().row.size();
  Eigen::MatrixXd kernel = Eigen::MatrixXd::Zero(side, side);
  for (const RealProduct& p : pair.products) {
    kernel += (even_kernel ? p.even : p.odd) * p.row.transpose();
  }
  return kernel.cwiseAbs().sum();
}

/// What the row pass divides by, seen from whole grey levels.
constexpr int kRowScaleBits = FilterBank::kRowShift - FilterBank::kGreyShift;

/// Row taps use the whole 16 bits of the row's result for inputs -128..127.
double row_scale(const RealProduct& p) {
  // Times 2048 (128 levels in sixteenths), shifted by 12: 32500, which 16 bits hold
  constexpr double kLargestSum = 65000.0;
  // Just below 2^15, the largest of 16 bits, so that rounding may add one
  constexpr double kLargestTap = 32000.0;
  return std::min(kLargestSum / p.row.cwiseAbs().sum(), kLargestTap / p.row.cwiseAbs().maxCoeff());
}

/// How much a column tap must hold for gain 1.
double column_scale(const RealProduct& p) {
  return static_cast<double>(1 << (kRowScaleBits + FilterBank::kColumnShift)) / row_scale(p);
}

double common_gain(const std::vector<RealPair>& pairs) {
  double gain = 1e9;
  for (const RealPair& pair : pairs) {
    const double norm = std::max(l1_norm(pair, true), l1_norm(pair, false));
    // A third is left for the mean that is taken away and for what rank 3 leaves out.
    gain = std::min(gain, 31000.0 / (128.0 * norm * 1.02));
    for (const RealProduct& p : pair.products) {
      const double tap = std::max(p.even.cwiseAbs().maxCoeff(), p.odd.cwiseAbs().maxCoeff());
      gain = std::min(gain, 32000.0 / (tap * column_scale(p)));
    }
  }
  return gain;
}

std::vector<std::int16_t> quantise(const Eigen::VectorXd& taps, double scale) {
  std::vector<std::int16_t> result;
  for (const double tap : taps)
    result.push_back(static_cast<std::int16_t>(std::lround(tap * scale)));
  return result;
}

double sum(const std::vector<std::int16_t>& taps) {
  double total = 0.0;
  for (const std::int16_t tap : taps) total += tap;
  return total;
}

FilterBank::Pair quantise(const RealPair& real, double gain, const V1Settings& s, int side) {
  FilterBank::Pair pair;
  pair.orientation = real.orientation;
  const bool on_axis = real.orientation == 0 || real.orientation == kOrientations / 2;
  pair.mirrored = on_axis ? -1 : kOrientations - real.orientation;
  double sum_reached = 0.0;  // of the quantised even kernel, as it reaches the accumulator
  for (const RealProduct& p : real.products) {
    FilterBank::Product product{quantise(p.row, row_scale(p)),
                                quantise(p.even, gain * column_scale(p)),
                                quantise(p.odd, gain * column_scale(p)), p.slot};
    // Only slot 0 has a sum: in slot 1 one of the two filters is antisymmetric.
    sum_reached += sum(product.row) * sum(product.column_even) / (1 << kRowScaleBits);
    pair.products.push_back(std::move(product));
  }
  if (s.even_mean == EvenMean::envelope) return pair;
  double sum_wanted = 0.0;
  if (s.even_mean == EvenMean::kept) {
    sum_wanted =
        exact_even_sum(s, real.orientation, side / 2) * gain * (1 << FilterBank::kColumnShift);
    pair.offset = static_cast<std::int32_t>(std::lround(128.0 * sum_wanted));
  }
  pair.box_factor =
      static_cast<std::int32_t>(std::lround((sum_reached - sum_wanted) / (side * side)));
  return pair;
}

/// Cuts taps off that are zero at both ends of every filter.
void trim(FilterBank& bank) {
  auto edge_is_zero = [](const std::vector<std::int16_t>& taps) {
    return taps.front() == 0 && taps.back() == 0;
  };
  auto cut = [](std::vector<std::int16_t>& taps) {
    taps.pop_back();
    taps.erase(taps.begin());
  };
  auto all_zero = [&] {
    return std::ranges::all_of(bank.pairs, [&](const FilterBank::Pair& pair) {
      return std::ranges::all_of(pair.products, [&](const FilterBank::Product& p) {
        return edge_is_zero(p.row) && edge_is_zero(p.column_even) && edge_is_zero(p.column_odd);
      });
    });
  };
  while (bank.radius > 1 && all_zero()) {
    --bank.radius;
    for (FilterBank::Pair& pair : bank.pairs) {
      for (FilterBank::Product& p : pair.products) {
        cut(p.row);
        cut(p.column_even);
        cut(p.column_odd);
      }
    }
  }
}

}  // namespace

FilterBank make_filter_bank(const V1Settings& settings) {
  const int side = gabor_side(settings.wavelength_px);
  std::vector<RealPair> pairs;
  for (int i = 0; i <= kOrientations / 2; ++i) {
    pairs.push_back(decompose_filter(settings, i, side / 2));
  }
  FilterBank bank;
  bank.radius = side / 2;
  bank.box_radius = side / 2;
  bank.gain = common_gain(pairs);
  for (const RealPair& pair : pairs) {
    bank.pairs.push_back(quantise(pair, bank.gain, settings, side));
  }
  trim(bank);
  return bank;
}

}  // namespace striate::perception
