#include "striate/platform/datasets/calibration/eye_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "striate/base/plain_text.hpp"
#include "striate/platform/datasets/calibration/text_tree.hpp"

namespace striate::datasets {

template <int Rows, int Cols>
std::optional<cv::Matx<double, Rows, Cols>> matrix_of(const config::Node& node,
                                                      const std::string& what,
                                                      config::Diagnostics& diagnostics) {
  const std::size_t before = diagnostics.count();
  const std::vector<double> numbers = numbers_of(node, what, diagnostics);
  if (diagnostics.count() != before) return {};
  if (numbers.size() != static_cast<std::size_t>(Rows) * Cols) {
    diagnostics.add(config::fault::wrong_kind, node.place,
                    fmt::format("{} has {} numbers", what, numbers.size()),
                    fmt::format("{} are needed: {} rows of {}", Rows * Cols, Rows, Cols));
    return {};
  }
  return cv::Matx<double, Rows, Cols>(numbers.data());
}

template std::optional<cv::Matx33d> matrix_of<3, 3>(const config::Node&, const std::string&,
                                                    config::Diagnostics&);
template std::optional<cv::Matx34d> matrix_of<3, 4>(const config::Node&, const std::string&,
                                                    config::Diagnostics&);
template std::optional<cv::Matx44d> matrix_of<4, 4>(const config::Node&, const std::string&,
                                                    config::Diagnostics&);
template std::optional<cv::Matx31d> matrix_of<3, 1>(const config::Node&, const std::string&,
                                                    config::Diagnostics&);
template std::optional<cv::Matx41d> matrix_of<4, 1>(const config::Node&, const std::string&,
                                                    config::Diagnostics&);

cv::Matx33d camera_matrix(double fx_px, double fy_px, double cx_px, double cy_px) {
  return {fx_px, 0.0, cx_px, 0.0, fy_px, cy_px, 0.0, 0.0, 1.0};
}

std::optional<cv::Matx33d> matrix_of_four(const config::Node& node,
                                          config::Diagnostics& diagnostics) {
  const auto four = matrix_of<4, 1>(node, "intrinsics (fu, fv, cu, cv)", diagnostics);
  if (!four) return {};
  return camera_matrix(four->val[0], four->val[1], four->val[2], four->val[3]);
}

std::optional<double> number_in(const config::Node* node, const std::string& what,
                                config::Diagnostics& diagnostics) {
  if (node == nullptr) return {};
  const std::optional<double> number = number_of(node->text);
  if (!number) {
    diagnostics.add(config::fault::no_number, node->place,
                    fmt::format("{}: '{}' is no number", plain_text(what),
                                plain_text(node->text.substr(0, 30))));
  }
  return number;
}

std::string lower_letters(const std::string& text) {
  std::string letters;
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  return letters;
}

namespace {

/// Nothing where the name is one of a lens that is not known here.
std::optional<Lens> lens_named(const std::string& name) {
  const std::string lens = lower_letters(name);
  for (const char* bent : {"plumbbob", "rationalpolynomial", "rational", "radtan",
                           "radialtangential", "brown", "brownconrady", "thinprism", "pinhole"}) {
    if (lens == bent) return Lens::radial_tangential;
  }
  for (const char* wide : {"equidistant", "fisheye", "kannalabrandt", "kannalabrandt4", "kb4"}) {
    if (lens == wide) return Lens::equidistant;
  }
  if (lens.empty() || lens == "none" || lens == "null") return Lens::straight;
  return {};
}

}  // namespace

void set_distortion(const config::Node* coefficients, const config::Node* model, EyeModel& eye,
                    config::Diagnostics& diagnostics) {
  const bool named = model != nullptr && !lower_letters(model->text).empty();
  std::optional<Lens> lens = Lens::radial_tangential;
  if (named) lens = lens_named(model->text);
  if (!lens) {
    diagnostics.add(config::fault::unknown_choice, model->place,
                    fmt::format("the lens model '{}' is not known", plain_text(model->text)),
                    "known are plumb_bob, radtan, rational_polynomial, equidistant (fisheye) and "
                    "none");
    return;
  }
  if (coefficients == nullptr || *lens == Lens::straight) return;
  const std::size_t before = diagnostics.count();
  std::vector<double> given = numbers_of(*coefficients, "the lens's coefficients", diagnostics);
  if (diagnostics.count() != before) return;
  if (std::ranges::all_of(given, [](double k) { return k == 0.0; }) &&
      *lens == Lens::radial_tangential) {
    return;
  }
  if (*lens == Lens::radial_tangential && given.size() == 2) given.resize(4, 0.0);  // k1 k2
  const std::vector<std::size_t> counts = *lens == Lens::equidistant
                                              ? std::vector<std::size_t>{4}
                                              : std::vector<std::size_t>{4, 5, 8, 12, 14};
  if (std::ranges::find(counts, given.size()) == counts.end()) {
    diagnostics.add(config::fault::wrong_kind, coefficients->place,
                    fmt::format("the lens has {} coefficients", given.size()),
                    *lens == Lens::equidistant ? "an equidistant lens has 4"
                                               : "OpenCV's order has 4, 5, 8, 12 or 14: k1 k2 p1 "
                                                 "p2 [k3 [k4 k5 k6 ...]]");
    return;
  }
  eye.lens = *lens;
  eye.distortion = given;
}

cv::Size size_of(const config::Node* width, const config::Node* height,
                 config::Diagnostics& diagnostics) {
  if (width == nullptr || height == nullptr) return {};
  constexpr double kWidest_px = 65536.0;  // px: no camera here has more, and an int holds it
  cv::Size size;
  for (const config::Node* side : {width, height}) {
    const auto px = number_of(side->text);
    if (!px || *px < 0.0 || *px > kWidest_px || *px != std::floor(*px)) {
      diagnostics.add(config::fault::out_of_range, side->place,
                      "the size of the pictures must be a whole number of px");
      return {};
    }
    (side == width ? size.width : size.height) = static_cast<int>(*px);
  }
  return size.width > 0 && size.height > 0 ? size : cv::Size{};  // a driver that says 0 knows none
}

std::optional<cv::Matx44d> motion_of(const config::Node& node, const std::string& what,
                                     config::Diagnostics& diagnostics) {
  const auto motion = matrix_of<4, 4>(node, what, diagnostics);
  if (!motion) return {};
  const cv::Matx14d last = motion->row(3);
  if (cv::norm(last - cv::Matx14d(0.0, 0.0, 0.0, 1.0)) > 1e-6) {
    diagnostics.add(config::fault::out_of_range, node.place,
                    what + " is no rigid motion: its last row is not 0, 0, 0, 1");
    return {};
  }
  return motion;
}

cv::Matx44d inverse_motion(const cv::Matx44d& motion) {
  const cv::Matx33d turn = motion.get_minor<3, 3>(0, 0).t();
  const cv::Matx31d way = turn * motion.get_minor<3, 1>(0, 3);
  return {turn(0, 0), turn(0, 1), turn(0, 2), -way(0), turn(1, 0), turn(1, 1), turn(1, 2), -way(1),
          turn(2, 0), turn(2, 1), turn(2, 2), -way(2), 0.0,        0.0,        0.0,        1.0};
}

EyesApart apart_of(const cv::Matx44d& right_from_left) {
  return {right_from_left.get_minor<3, 3>(0, 0),
          {right_from_left(0, 3), right_from_left(1, 3), right_from_left(2, 3)}};
}

}  // namespace striate::datasets
