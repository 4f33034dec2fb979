#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

/// Rooms with boxes and balls, seen by two eyes, with the true disparity of every pixel. Made by
/// rule: rays against shapes whose grain is noise in space, so that both eyes see the same grain
/// wherever they see the same place. Beside vivid surfaces there are nearly blank ones; every
/// image has noise of its own, and the right eye is exposed differently.
namespace striate::reference {

struct Vec {
  double x = 0.0, y = 0.0, z = 0.0;  ///< m: right, down, away from the left eye
};

/// A box or a ball; the room is a box that is seen from within.
struct Shape {
  enum class Kind { room, box, ball } kind;
  Vec low, high;  ///< corners; of a ball its middle, and its radius in high.x
  std::array<double, 3> bgr;
  double vividness;  ///< standard deviation of the grain, in grey levels, about
  double grain_m;    ///< the coarsest; finer ones are on top of it
};

struct PaintedPair {
  cv::Mat3b left, right;
  cv::Mat1f left_px, right_px;  ///< true disparities
};

/// A number in 0 .. 1 that depends on all that goes in.
inline double dice(std::uint64_t a, std::uint64_t b, std::uint64_t c, std::uint64_t seed) {
  std::uint64_t h = seed * 0x9e3779b97f4a7c15U;
  for (const std::uint64_t part : {a, b, c}) {
    h = (h ^ part) * 0xbf58476d1ce4e5b9U;
    h ^= h >> 29U;
  }
  h *= 0x94d049bb133111ebU;
  return static_cast<double>((h ^ h >> 32U) >> 11U) * 0x1.0p-53;
}

class PaintedRoom {
 public:
  static constexpr int kWidth = 320, kHeight = 240;
  static constexpr double kFocal_px = 403.0;  ///< 43.3 degrees across, as the robot's eyes
  static constexpr double kBaseline_m = 0.12;

  explicit PaintedRoom(std::uint64_t seed) : seed_(seed) {
    shapes_.push_back(
        {Shape::Kind::room, {-1.6, -1.4, -1.0}, {1.6, 0.9, 6.0}, {150, 160, 165}, 18.0, 0.5});
    for (std::uint64_t k = 0; k < 9; ++k) shapes_.push_back(thing(k));
  }

  [[nodiscard]] PaintedPair paint() const {
    PaintedPair pair;
    look(0.0, 1.0, 1, pair.left, pair.left_px);
    look(kBaseline_m, 1.06, 2, pair.right, pair.right_px);
    return pair;
  }

 private:
  /// Every third thing is nearly blank.
  [[nodiscard]] Shape thing(std::uint64_t k) const {
    const auto draw = [&](std::uint64_t what, double from, double to) {
      return from + (to - from) * dice(k, what, 0, seed_);
    };
    const Vec at{draw(1, -0.9, 0.9), draw(2, -0.5, 0.7), draw(3, 1.4, 4.5)};
    Shape shape{Shape::Kind::ball,
                at,
                {draw(4, 0.15, 0.4), 0, 0},
                {draw(5, 40, 220), draw(6, 40, 220), draw(7, 40, 220)},
                k % 3 == 2 ? 4.0 : draw(8, 15, 35),
                draw(9, 0.05, 0.2)};
    if (k % 2 == 0) {
      shape.kind = Shape::Kind::box;
      shape.high = {at.x + draw(10, 0.2, 0.7), at.y + draw(11, 0.2, 0.7),
                    at.z + draw(12, 0.2, 0.8)};
    }
    return shape;
  }

  void look(double eye_x_m, double gain, std::uint64_t eye, cv::Mat3b& image,
            cv::Mat1f& disparity_px) const {
    constexpr double kNoise = 2.0;  // grey levels
    image.create(kHeight, kWidth);
    disparity_px.create(kHeight, kWidth);
    for (int v = 0; v < kHeight; ++v) {
      for (int u = 0; u < kWidth; ++u) {
        const Vec eye_m{eye_x_m, 0, 0};
        const Vec ray{(u - kWidth / 2) / kFocal_px, (v - kHeight / 2) / kFocal_px, 1.0};
        double depth_m = std::numeric_limits<double>::infinity();
        const Shape* seen = nullptr;
        for (const Shape& shape : shapes_) {
          const double hit_m = meets(shape, eye_m, ray);
          if (hit_m < depth_m) depth_m = hit_m, seen = &shape;
        }
        const Vec place{eye_m.x + ray.x * depth_m, ray.y * depth_m, depth_m};
        const double grain = seen->vividness * grain_at(place, seen->grain_m, depth_m);
        for (int c = 0; c < 3; ++c) {
          const auto at = static_cast<std::uint64_t>((v * kWidth + u) * 3 + c);
          const double noise = kNoise * std::sqrt(12.0) * (dice(at, eye, 77, seed_) - 0.5);
          image(v, u)[c] = cv::saturate_cast<uchar>(
              gain * (seen->bgr[static_cast<std::size_t>(c)] + grain) + noise);
        }
        disparity_px(v, u) = static_cast<float>(kFocal_px * kBaseline_m / depth_m);
      }
    }
  }

  /// Where the ray, whose z is 1, meets the shape: the depth in m; infinite: nowhere.
  static double meets(const Shape& shape, const Vec& from, const Vec& ray) {
    constexpr double kNowhere = std::numeric_limits<double>::infinity();
    if (shape.kind == Shape::Kind::ball) {
      const Vec off{from.x - shape.low.x, from.y - shape.low.y, from.z - shape.low.z};
      const double a = ray.x * ray.x + ray.y * ray.y + ray.z * ray.z;
      const double b = off.x * ray.x + off.y * ray.y + off.z * ray.z;
      const double c = off.x * off.x + off.y * off.y + off.z * off.z - shape.high.x * shape.high.x;
      const double root = b * b - a * c;
      return root < 0.0 ? kNowhere : (-b - std::sqrt(root)) / a;
    }
    double enters = -kNowhere, leaves = kNowhere;
    const auto slab = [&](double at, double way, double low, double high) {
      const double one = (low - at) / way, two = (high - at) / way;
      enters = std::max(enters, std::min(one, two));
      leaves = std::min(leaves, std::max(one, two));
    };
    constexpr double kTilt = 1e-9;  // no ray is quite along a side
    slab(from.x, ray.x + kTilt, shape.low.x, shape.high.x);
    slab(from.y, ray.y + kTilt, shape.low.y, shape.high.y);
    slab(from.z, ray.z, shape.low.z, shape.high.z);
    if (shape.kind == Shape::Kind::room) return leaves;
    return enters <= leaves && enters > 0.0 ? enters : kNowhere;
  }

  /// Noise of about unit deviation; each octave half as large and 0.7 as strong. What is finer than
  /// two pixels at that depth is left out, as it would alias.
  [[nodiscard]] double grain_at(const Vec& place, double coarsest_m, double depth_m) const {
    double sum = 0.0, strength = 1.6;
    for (double size_m = coarsest_m; size_m > 2.0 * depth_m / kFocal_px; size_m /= 2.0) {
      sum += strength * smooth_noise({place.x / size_m, place.y / size_m, place.z / size_m});
      strength *= 0.7;
    }
    return sum;
  }

  /// -1 .. 1, trilinear between random numbers at whole places.
  [[nodiscard]] double smooth_noise(const Vec& at) const {
    const double x0 = std::floor(at.x), y0 = std::floor(at.y), z0 = std::floor(at.z);
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
      const int dx = corner & 1, dy = corner >> 1 & 1, dz = corner >> 2;
      const auto whole = [](double low, int step) {
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(low) + step);
      };
      const auto share = [](double part, int step) { return step != 0 ? part : 1.0 - part; };
      sum += share(at.x - x0, dx) * share(at.y - y0, dy) * share(at.z - z0, dz) *
             (2.0 * dice(whole(x0, dx), whole(y0, dy), whole(z0, dz), seed_) - 1.0);
    }
    return sum;
  }

  std::uint64_t seed_;
  std::vector<Shape> shapes_;
};

/// As a folder of Middlebury's 2014 pairs holds it: im0.png, im1.png, disp0.pfm, disp1.pfm.
inline void write_pair(const PaintedPair& pair, const std::string& folder) {
  cv::imwrite(folder + "/im0.png", pair.left);
  cv::imwrite(folder + "/im1.png", pair.right);
  const auto write_pfm = [&](const std::string& name, const cv::Mat1f& values) {
    std::ofstream file(folder + "/" + name, std::ios::binary);
    file << "Pf\n" << values.cols << " " << values.rows << "\n-1\n";
    for (int v = values.rows - 1; v >= 0; --v) {  // bottom up
      file.write(reinterpret_cast<const char*>(values.ptr(v)),
                 static_cast<std::streamsize>(values.cols * sizeof(float)));
    }
  };
  write_pfm("disp0.pfm", pair.left_px);
  write_pfm("disp1.pfm", pair.right_px);
}

}  // namespace striate::reference
