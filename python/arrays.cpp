#include "striate/python/arrays.hpp"

#include <fmt/format.h>

#include <opencv2/imgproc.hpp>
#include <string>

#include "striate/base/user_error.hpp"

namespace striate::python {
namespace {

py::capsule keeping(const Owner& owner) {
  return {new Owner(owner), [](void* kept) { delete static_cast<Owner*>(kept); }};
}

py::dtype type_of(const cv::Mat& matrix) {
  switch (matrix.depth()) {
    case CV_8U:
      return py::dtype::of<std::uint8_t>();
    case CV_16S:
      return py::dtype::of<std::int16_t>();
    case CV_32F:
      return py::dtype::of<float>();
    default:
      return py::dtype::of<double>();
  }
}

std::string words_of(const py::handle& object) {
  return py::str(object);
}

void check_strides(const py::array& array, const char* name) {
  const bool colour = array.ndim() == 3;
  const py::ssize_t pixel = colour ? 3 : 1;
  const bool pixels_follow = array.strides(1) == pixel && (!colour || array.strides(2) == 1);
  if (pixels_follow && array.strides(0) >= pixel * array.shape(1)) return;
  throw UserError(
      fmt::format("{}: the pixels of a row must follow one another in memory, row after row; this "
                  "array has shape {} and strides {}\n    numpy.ascontiguousarray({}) makes it so",
                  name, words_of(array.attr("shape")), words_of(array.attr("strides")), name));
}

/// The array where it lies, as 8 bits of one or three channels.
cv::Mat image_where_it_lies(const py::handle& given, const char* name) {
  if (!py::isinstance<py::array>(given)) {
    throw py::type_error(fmt::format("{}: an image is a numpy array of uint8, but this is {}", name,
                                     words_of(py::type::handle_of(given).attr("__name__"))));
  }
  const auto array = py::reinterpret_borrow<py::array>(given);
  if (!array.dtype().equal(py::dtype::of<std::uint8_t>())) {
    throw py::type_error(fmt::format("{}: an image has pixels of uint8, but this array has {}",
                                     name, words_of(array.dtype())));
  }
  const bool fits = array.ndim() == 2 || (array.ndim() == 3 && array.shape(2) == 3);
  if (!fits || array.size() == 0) {
    throw UserError(
        fmt::format("{}: an image has the shape (height, width) or (height, width, 3), but this "
                    "array has {}",
                    name, words_of(array.attr("shape"))));
  }
  constexpr py::ssize_t kMost_px = 1 << 20;  // a side; what OpenCV counts with int, by hand
  if (array.shape(0) > kMost_px || array.shape(1) > kMost_px) {
    throw UserError(fmt::format("{}: an image of {} x {} px is none that can be seen", name,
                                array.shape(1), array.shape(0)));
  }
  check_strides(array, name);
  // OpenCV has no matrix of constant pixels; what is made of it here is only read.
  void* pixels = const_cast<void*>(array.data());
  return {static_cast<int>(array.shape(0)), static_cast<int>(array.shape(1)),
          array.ndim() == 3 ? CV_8UC3 : CV_8UC1, pixels,
          static_cast<std::size_t>(array.strides(0))};
}

}  // namespace

py::array array_view(const py::dtype& type, std::vector<py::ssize_t> shape,
                     std::vector<py::ssize_t> strides, const void* data, const Owner& owner) {
  py::array array(type, std::move(shape), std::move(strides), data, keeping(owner));
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

py::array array_of(const cv::Mat& matrix) {
  const auto kept = std::make_shared<const cv::Mat>(matrix);
  std::vector<py::ssize_t> shape = {matrix.rows, matrix.cols};
  std::vector<py::ssize_t> strides = {static_cast<py::ssize_t>(matrix.step[0]),
                                      static_cast<py::ssize_t>(matrix.elemSize())};
  if (matrix.channels() > 1) {
    shape.push_back(matrix.channels());
    strides.push_back(static_cast<py::ssize_t>(matrix.elemSize1()));
  }
  if (matrix.empty()) {
    shape.assign(shape.size(), 0);
    strides.assign(shape.size(), 1);
  }
  return array_view(type_of(matrix), shape, strides, matrix.data, kept);
}

Channels channels_named(const std::string& name) {
  if (name == "bgr") return Channels::bgr;
  if (name == "rgb") return Channels::rgb;
  throw UserError(fmt::format("channels '{}': choose bgr or rgb", name));
}

cv::Mat3b bgr_image(const py::handle& given, const char* name, Channels channels) {
  const cv::Mat image = image_where_it_lies(given, name);
  if (image.channels() == 3 && channels == Channels::bgr) return image;
  cv::Mat3b bgr;
  cv::cvtColor(image, bgr, image.channels() == 1 ? cv::COLOR_GRAY2BGR : cv::COLOR_RGB2BGR);
  return bgr;
}

cv::Mat1b grey_image(const py::handle& given, const char* name, Channels channels) {
  const cv::Mat image = image_where_it_lies(given, name);
  if (image.channels() == 1) return image;
  cv::Mat1b grey;
  cv::cvtColor(image, grey, channels == Channels::bgr ? cv::COLOR_BGR2GRAY : cv::COLOR_RGB2GRAY);
  return grey;
}

}  // namespace striate::python
