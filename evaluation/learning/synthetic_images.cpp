#include "striate/evaluation/learning/synthetic_images.hpp"

#include <cmath>
#include <numbers>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace striate::evaluation {
namespace {

/// Noise of many grain sizes; `roughness` is each finer grain's weight against the next coarser
/// (about 0.5: 1/f^2 in power; 1: white). Mean 0, deviation about 1.
cv::Mat1f cloud(cv::Size size, double roughness, cv::RNG& random) {
  cv::Mat1f sum(size, 0.0F), grains, layer;
  double weight = 1.0, power = 0.0;
  for (int grain = 128; grain >= 1; grain /= 2, weight *= roughness) {
    grains.create(size.height / grain + 3, size.width / grain + 3);
    random.fill(grains, cv::RNG::NORMAL, 0.0, 1.0);
    cv::resize(grains, layer, {}, grain, grain, cv::INTER_CUBIC);
    sum += layer({random.uniform(0, grain), random.uniform(0, grain), size.width, size.height}) *
           weight;
    power += weight * weight;
  }
  return sum / std::sqrt(power);
}

/// Stretched clouds: wood, brushed metal, grass.
cv::Mat1f grain(cv::Size size, cv::RNG& random) {
  const double stretch = random.uniform(2.0, 8.0);
  const int side = static_cast<int>(std::hypot(size.width, size.height)) + 2;
  const cv::Mat1f straight = cloud({side, side}, random.uniform(0.6, 0.9), random);
  cv::Matx23d turn =
      cv::getRotationMatrix2D({side * 0.5F, side * 0.5F}, random.uniform(0.0, 180.0), 1.0);
  for (int k = 0; k < 2; ++k) turn(0, k) *= stretch;
  turn(0, 2) = turn(0, 2) * stretch + random.uniform(0.0, side * 1.0);
  cv::Mat1f result;
  cv::warpAffine(straight, result, turn, size, cv::INTER_LINEAR | cv::WARP_INVERSE_MAP,
                 cv::BORDER_REFLECT);
  return result;
}

/// Bricks, tiles or window fronts: a raster of unlike cells with joints.
cv::Mat1f raster(cv::Size size, cv::RNG& random) {
  cv::Mat1f result(size, random.uniform(-2.0F, 2.0F));
  const int width = random.uniform(10, 70), height = random.uniform(8, 50);
  const int joint = random.uniform(1, 2 + height / 6);
  const float unlike = random.uniform(0.1F, 1.2F);
  const int shift = random.uniform(0, 2) * width / 2;
  for (int row = 0; row * height < size.height; ++row) {
    for (int column = -1; column * width < size.width; ++column) {
      const cv::Rect cell(column * width + row % 2 * shift, row * height, width - joint,
                          height - joint);
      result(cell & cv::Rect({}, size)) = static_cast<float>(random.gaussian(unlike));
    }
  }
  return result;
}

cv::Mat1f bars(cv::Size size, cv::RNG& random) {
  const double angle = random.uniform(0.0, std::numbers::pi);
  const double omega = 2.0 * std::numbers::pi / random.uniform(5.0, 40.0);
  const float sharp = random.uniform(0.5F, 6.0F);
  cv::Mat1f result(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const double wave = std::sin(omega * (x * std::cos(angle) + y * std::sin(angle)));
      result(y, x) = static_cast<float>(std::tanh(sharp * wave));
    }
  }
  return result;
}

cv::Mat1f surface(cv::Size size, cv::RNG& random) {
  const int kind = random.uniform(0, 10);
  if (kind == 0) return bars(size, random);
  if (kind <= 2) return raster(size, random);
  if (kind <= 4) return grain(size, random);
  return cloud(size, random.uniform(0.5, 0.95), random);
}

/// The outline of a leaf: an ellipse, a polygon with straight or with wobbling sides.
std::vector<cv::Point> outline(cv::Point2d centre, double radius_px, cv::RNG& random) {
  const int kind = random.uniform(0, 3);
  const int corners = kind == 0 ? 40 : random.uniform(3, 8);
  const double stretch = random.uniform(0.3, 1.0),
               turn = random.uniform(0.0, 2.0 * std::numbers::pi);
  std::vector<cv::Point> points;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / corners;
    const double r = radius_px * (kind == 2 ? random.uniform(0.4, 1.0) : 1.0);
    const double x = r * std::cos(angle), y = r * stretch * std::sin(angle);
    points.emplace_back(cvRound(16.0 * (centre.x + x * std::cos(turn) - y * std::sin(turn))),
                        cvRound(16.0 * (centre.y + x * std::sin(turn) + y * std::cos(turn))));
  }
  return points;
}

void write_words(cv::Mat1f& image, cv::RNG& random) {
  std::string word;
  for (int k = random.uniform(2, 12); k > 0; --k)
    word += static_cast<char>(random.uniform(33, 126));
  const cv::Point at(random.uniform(0, image.cols), random.uniform(0, image.rows));
  cv::putText(image, word, at, random.uniform(0, 8), random.uniform(0.3, 2.5),
              cv::Scalar(random.uniform(0.0, 255.0)), random.uniform(1, 4), cv::LINE_AA);
}

void draw_line(cv::Mat1f& image, cv::RNG& random) {
  const cv::Point a(random.uniform(0, image.cols), random.uniform(0, image.rows));
  const cv::Point b(random.uniform(0, image.cols), random.uniform(0, image.rows));
  cv::line(image, a, b, cv::Scalar(random.uniform(0.0, 255.0)), random.uniform(1, 6), cv::LINE_AA);
}

void draw_leaf(cv::Mat1f& image, double radius_px, cv::RNG& random) {
  const cv::Point2d centre(random.uniform(0.0, 1.0 * image.cols),
                           random.uniform(0.0, 1.0 * image.rows));
  const int reach = static_cast<int>(radius_px) + 2;
  const cv::Point corner(static_cast<int>(centre.x) - reach, static_cast<int>(centre.y) - reach);
  const cv::Rect box =
      cv::Rect(corner, cv::Size(2 * reach + 1, 2 * reach + 1)) & cv::Rect({}, image.size());
  if (box.empty()) return;
  cv::Mat1f mask(box.size(), 0.0F), soft;
  const auto points = outline(centre - cv::Point2d(box.tl()), radius_px, random);
  cv::fillPoly(mask, std::vector{points}, cv::Scalar(1.0), cv::LINE_8, 4);
  cv::GaussianBlur(mask, soft, {}, random.uniform(0.4, 1.2));
  const float contrast = random.uniform(0.0F, 45.0F), grey = random.uniform(10.0F, 245.0F);
  const cv::Mat1f leaf = surface(box.size(), random) * contrast + grey;
  cv::Mat1f under = image(box);
  under += (leaf - under).mul(soft);
}

cv::Matx33d moved(double u, double v) {
  return {1.0, 0.0, u, 0.0, 1.0, v, 0.0, 0.0, 1.0};
}

/// A camera that turns, comes nearer and looks at the image plane aslant.
cv::Matx33d viewpoint(cv::Size size, cv::RNG& random) {
  const double angle = random.uniform(-std::numbers::pi, std::numbers::pi);
  const double turn = random.uniform(0, 2) == 0 ? angle : 0.15 * angle;
  const double zoom = std::exp2(random.uniform(-1.2, 0.4));
  const double tilt = std::exp2(random.uniform(0, 3) > 0 ? random.uniform(0.0, 1.3) : 0.0);
  const double axis = random.uniform(0.0, std::numbers::pi);
  auto rotation = [](double a) {
    return cv::Matx33d(std::cos(a), -std::sin(a), 0, std::sin(a), std::cos(a), 0, 0, 0, 1);
  };
  cv::Matx33d h = rotation(turn) * rotation(-axis) * cv::Matx33d::diag({zoom, zoom / tilt, 1.0}) *
                  rotation(axis);
  h(2, 0) = random.uniform(-0.25, 0.25) / size.width;
  h(2, 1) = random.uniform(-0.25, 0.25) / size.height;
  return moved(0.5 * size.width, 0.5 * size.height) * h *
         moved(-0.5 * size.width, -0.5 * size.height);
}

void disturb(cv::Mat1b& image, cv::RNG& random) {
  if (random.uniform(0, 2) == 0) {
    cv::GaussianBlur(image, image, {}, random.uniform(0.4, 3.0));
  }
  cv::Mat1f grey, noise(image.size());
  image.convertTo(grey, CV_32F, 1.0 / 255.0);
  cv::pow(grey, random.uniform(0.7, 1.4), grey);
  random.fill(noise, cv::RNG::NORMAL, 0.0, random.uniform(0.5, 7.0));
  grey = grey * (255.0 * random.uniform(0.5, 1.2)) + random.uniform(0.0, 40.0) + noise;
  grey.convertTo(image, CV_8U);
}

}  // namespace

cv::Mat1b synthetic_image(cv::Size size, std::uint64_t seed) {
  cv::RNG random(seed * 2654435761U + 1U);
  cv::Mat1f image = surface(size, random) * 40.0F + 128.0F;
  // Dead leaves: how many have a radius of at least r falls like 1/r^2.
  const int leaves = random.uniform(100, 700);
  for (int k = 0; k < leaves; ++k) {
    draw_leaf(image, std::min(180.0, 5.0 / std::sqrt(random.uniform(0.0005, 1.0))), random);
    if (random.uniform(0, 20) == 0) write_words(image, random);
    if (random.uniform(0, 40) == 0) draw_line(image, random);
  }
  image = image.mul(1.0F + 0.2F * cloud(size, 0.25, random));  // shading
  image += cloud(size, 1.0, random) * random.uniform(0.5, 4.0);
  cv::Mat1b grey;
  cv::GaussianBlur(image, image, {}, random.uniform(0.4, 1.0));
  image.convertTo(grey, CV_8U);
  return grey;
}

SecondView second_view(const cv::Mat1b& image, std::uint64_t seed) {
  cv::RNG random(seed * 2246822519U + 3U);
  SecondView view;
  view.homography = viewpoint(image.size(), random);
  // Before an image is made smaller it is smoothed, as a lens and pixels do.
  const double shrink = std::sqrt(1.0 / std::abs(cv::determinant(view.homography)));
  cv::Mat1b smooth = image;
  if (shrink > 1.0) cv::GaussianBlur(image, smooth, {}, 0.5 * std::sqrt(shrink * shrink - 0.9));
  cv::warpPerspective(smooth, view.image, view.homography, image.size(), cv::INTER_LINEAR,
                      cv::BORDER_REFLECT);
  disturb(view.image, random);
  return view;
}

}  // namespace striate::evaluation
