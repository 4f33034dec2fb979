#pragma once

#include <pybind11/numpy.h>

#include <memory>
#include <opencv2/core/mat.hpp>
#include <utility>
#include <vector>

/// Between numpy and what Striate computes with, without copies: an array that is handed out looks
/// into the C++ value and keeps it alive; an image that is handed in is looked at where it lies.
namespace striate::python {

namespace py = pybind11;

/// What keeps the memory of an array alive.
using Owner = std::shared_ptr<const void>;

/// A read-only array that looks into memory of `owner`.
[[nodiscard]] py::array array_view(const py::dtype& type, std::vector<py::ssize_t> shape,
                                   std::vector<py::ssize_t> strides, const void* data,
                                   const Owner& owner);

/// The same of a matrix: (h, w), or (h, w, channels). It shares the matrix's pixels, so they must
/// be written to no more. Of an empty matrix (0, 0).
[[nodiscard]] py::array array_of(const cv::Mat& matrix);

/// The records of a vector that `owner` holds, as a structured array (n,).
template <class Record>
[[nodiscard]] py::array records_view(const std::vector<Record>& records, const Owner& owner) {
  return array_view(py::dtype::of<Record>(), {static_cast<py::ssize_t>(records.size())},
                    {static_cast<py::ssize_t>(sizeof(Record))}, records.data(), owner);
}

/// The same of a vector that nobody else needs.
template <class Record>
[[nodiscard]] py::array records_array(std::vector<Record> records) {
  auto kept = std::make_shared<const std::vector<Record>>(std::move(records));
  return records_view(*kept, kept);
}

/// How the channels of a colour image follow one another.
enum class Channels { bgr, rgb };

/// @throws UserError for anything but "bgr" and "rgb"
[[nodiscard]] Channels channels_named(const std::string& name);

/// An array as the BGR image that Striate sees: (h, w) or (h, w, 3) of uint8. A colour image in
/// BGR is looked at where it lies, so the array must outlive what comes back; all others are
/// copied.
/// @param name of the argument, for messages
/// @throws py::type_error for what is no array of uint8, UserError for its shape and its strides
[[nodiscard]] cv::Mat3b bgr_image(const py::handle& given, const char* name,
                                  Channels channels = Channels::bgr);
/// The same in grey.
[[nodiscard]] cv::Mat1b grey_image(const py::handle& given, const char* name,
                                   Channels channels = Channels::bgr);

}  // namespace striate::python
