#include "striate/evaluation/learning/synthetic_stereo.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "striate/evaluation/learning/synthetic_images.hpp"

namespace striate::evaluation {
namespace {

/// Scenes are drawn so much larger: edges fall between pixels as in a camera
constexpr int kFiner = 4;
/// Error of the eyes' heights, at the working size: twice a rectified pair's 0.15 px
constexpr float kLower_px = 0.3F;

/// One plane, in the left image's frame; disparity = at + across x + down y.
struct Sheet {
  cv::Mat1f grey, mask;
  float at_px = 0.0F, across = 0.0F, down = 0.0F;

  [[nodiscard]] float disparity_px(float x, float y) const { return at_px + across * x + down * y; }
};

/// What one eye sees.
struct View {
  cv::Mat1f grey, disparity_px;
};

/// A part of an image, at another scale and contrast.
cv::Mat1f cut_texture(const cv::Mat1b& from, cv::Size size, cv::RNG& random) {
  const double zoom = std::exp2(random.uniform(-0.5, 2.0));
  const double angle = random.uniform(0.0, 360.0);
  cv::Matx23d turn = cv::getRotationMatrix2D({from.cols * 0.5F, from.rows * 0.5F}, angle, zoom);
  turn(0, 2) += random.uniform(-200.0, 200.0);
  turn(1, 2) += random.uniform(-200.0, 200.0);
  cv::Mat1b part;
  cv::warpAffine(from, part, turn, size, cv::INTER_LINEAR, cv::BORDER_REFLECT);
  // One surface in five is almost blank.
  const double contrast =
      random.uniform(0, 5) == 0 ? random.uniform(0.0, 0.06) : random.uniform(0.1, 1.0);
  cv::Mat1f grey;
  part.convertTo(grey, CV_32F, contrast, (1.0 - contrast) * random.uniform(30.0, 220.0));
  return grey;
}

/// A thing with straight, round or ragged sides.
cv::Mat1f outline(cv::Size size, cv::RNG& random) {
  const double radius = size.width * std::exp2(random.uniform(-5.0, -1.5));
  const cv::Point2d centre(random.uniform(0.0, 1.0 * size.width),
                           random.uniform(0.0, 1.0 * size.height));
  const int kind = random.uniform(0, 3);
  const int corners = kind == 0 ? 40 : random.uniform(3, 9);
  const double stretch = random.uniform(0.15, 1.0);
  const double turn = random.uniform(0.0, std::numbers::pi);
  std::vector<cv::Point> points;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / corners;
    const double r = radius * (kind == 2 ? random.uniform(0.5, 1.0) : 1.0);
    const double u = r * std::cos(angle), v = stretch * r * std::sin(angle);
    points.emplace_back(cvRound(centre.x + u * std::cos(turn) - v * std::sin(turn)),
                        cvRound(centre.y + u * std::sin(turn) + v * std::cos(turn)));
  }
  cv::Mat1f mask(size, 0.0F);
  cv::fillPoly(mask, std::vector{points}, cv::Scalar(1.0));
  return mask;
}

/// From the farthest to the nearest.
std::vector<Sheet> make_room(cv::Size size, cv::RNG& random) {
  const cv::Mat1b textures[] = {synthetic_image(size, random.next()),
                                synthetic_image(size, random.next())};
  const float farthest = static_cast<float>(size.width) * random.uniform(0.01F, 0.12F);
  const float nearest = static_cast<float>(size.width) * random.uniform(0.14F, 0.28F);
  const int count = random.uniform(4, 22);
  std::vector<Sheet> sheets;
  for (int k = 0; k < count; ++k) {
    Sheet sheet;
    sheet.grey = cut_texture(textures[random.uniform(0, 2)], size, random);
    sheet.mask = k == 0 ? cv::Mat1f(size, 1.0F) : outline(size, random);
    const float slant = random.uniform(0, 3) == 0 ? 0.0F : 0.04F;
    sheet.across = random.uniform(-slant, slant);
    sheet.down = random.uniform(-slant, slant);
    const float middle =
        farthest + (nearest - farthest) * static_cast<float>(k) / static_cast<float>(count);
    sheet.at_px = middle - sheet.across * static_cast<float>(size.width) * 0.5F -
                  sheet.down * static_cast<float>(size.height) * 0.5F;
    sheets.push_back(std::move(sheet));
  }
  return sheets;
}

/// Where lamps mirror in shiny things: elsewhere for each eye, and not where the thing is.
void add_highlights(cv::Mat1f& left, cv::Mat1f& right, cv::RNG& random) {
  for (int k = random.uniform(0, 6); k > 0; --k) {
    const cv::Point at(random.uniform(0, left.cols), random.uniform(0, left.rows));
    const int deeper_px = random.uniform(0, left.cols / 5);
    const cv::Size radius(random.uniform(4, left.cols / 12), random.uniform(4, left.cols / 12));
    const double strength = random.uniform(10.0, 120.0);
    for (cv::Mat1f* eye : {&left, &right}) {
      cv::Mat1f light(eye->size(), 0.0F);
      const cv::Point centre = eye == &left ? at : at - cv::Point(deeper_px, 0);
      cv::ellipse(light, centre, radius, 0.0, 0.0, 360.0, cv::Scalar(strength), cv::FILLED);
      cv::GaussianBlur(light, light, {}, 0.4 * std::min(radius.width, radius.height));
      *eye += light;
    }
  }
}

/// @param eye 0: left; 1: right. @param lower_px by which it hangs lower than the other.
View draw(const std::vector<Sheet>& sheets, cv::Size size, float eye, float lower_px) {
  View view{cv::Mat1f(size, 0.0F), cv::Mat1f(size, 0.0F)};
  cv::Mat1f from_x(size), from_y(size), grey, mask, disparity(size);
  for (const Sheet& sheet : sheets) {
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        // In the right eye x = left x - disparity of left x.
        const float row = static_cast<float>(y) + lower_px;
        const float offset = sheet.at_px + sheet.down * row;
        from_x(y, x) = (static_cast<float>(x) + eye * offset) / (1.0F - eye * sheet.across);
        from_y(y, x) = row;
        disparity(y, x) = std::max(0.0F, sheet.disparity_px(from_x(y, x), row));
      }
    }
    cv::remap(sheet.grey, grey, from_x, from_y, cv::INTER_LINEAR, cv::BORDER_REFLECT);
    cv::remap(sheet.mask, mask, from_x, from_y, cv::INTER_LINEAR, cv::BORDER_CONSTANT);
    const bool background = &sheet == sheets.data();
    const cv::Mat seen = background ? cv::Mat(size, CV_8U, cv::Scalar(255)) : cv::Mat(mask > 0.5F);
    grey.copyTo(view.grey, seen);
    disparity.copyTo(view.disparity_px, seen);
  }
  return view;
}

/// Lens, exposure, sensor.
cv::Mat1w photograph(const cv::Mat1f& grey, cv::Size size, bool poor, cv::RNG& random) {
  cv::Mat1f soft, small, noise(size);
  cv::GaussianBlur(grey, soft, {}, random.uniform(0.6, poor ? 3.0 : 2.0));
  cv::resize(soft, small, size, 0, 0, cv::INTER_AREA);
  const double gain = poor ? random.uniform(0.8, 1.5) : random.uniform(0.97, 1.03);
  const double sigma = poor ? random.uniform(1.0, 9.0) : random.uniform(0.1, 1.0);
  random.fill(noise, cv::RNG::NORMAL, 0.0, sigma);
  small = small * gain + noise;
  small = cv::min(cv::max(small, 0.0F), 255.0F);
  cv::Mat1w result;
  small.convertTo(result, CV_16U, 16.0);
  return result;
}

}  // namespace

SyntheticPair synthetic_stereo(cv::Size size, std::uint64_t seed) {
  cv::RNG random(seed * 2654435761U + 5U);
  const cv::Size fine = size * kFiner;
  const std::vector<Sheet> sheets = make_room(fine, random);
  View left = draw(sheets, fine, 0.0F, 0.0F);
  View right = draw(sheets, fine, 1.0F, kFiner * random.uniform(-kLower_px, kLower_px));
  add_highlights(left.grey, right.grey, random);
  const bool poor = seed % 2 == 1;
  SyntheticPair pair{photograph(left.grey, size, false, random),
                     photograph(right.grey, size, poor, random), cv::Mat1f(size)};
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const int u = kFiner * x + kFiner / 2, v = kFiner * y + kFiner / 2;
      const float disparity = left.disparity_px(v, u);
      const int at = cvRound(static_cast<float>(u) - disparity);
      const bool both = at >= 0 && std::abs(right.disparity_px(v, at) - disparity) <= kFiner;
      pair.truth_px(y, x) = both ? disparity / kFiner : std::numeric_limits<float>::quiet_NaN();
    }
  }
  return pair;
}

}  // namespace striate::evaluation
