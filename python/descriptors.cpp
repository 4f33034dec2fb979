#include "striate/python/descriptors.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <cstring>
#include <string>

#include "striate/base/user_error.hpp"

namespace striate::python {
namespace {

using perception::Descriptor;
using perception::Keypoint;

constexpr py::ssize_t kBytes = 32;  // of a descriptor: 256 bits
static_assert(sizeof(Descriptor) == kBytes);
static_assert(std::endian::native == std::endian::little);  // words as bytes: bit b in byte b / 8

}  // namespace

py::array descriptors_view(const std::vector<Keypoint>& keypoints, const Owner& owner) {
  const auto* first = reinterpret_cast<const std::byte*>(keypoints.data());
  const void* data = keypoints.empty() ? nullptr : first + offsetof(Keypoint, descriptor);
  return array_view(py::dtype::of<std::uint8_t>(),
                    {static_cast<py::ssize_t>(keypoints.size()), kBytes},
                    {static_cast<py::ssize_t>(sizeof(Keypoint)), 1}, data, owner);
}

std::vector<Descriptor> descriptors_of(const py::handle& given, const char* name) {
  if (!py::isinstance<py::array>(given)) {
    throw py::type_error(
        fmt::format("{}: descriptors are a numpy array (n, 32) of uint8, but this is {}", name,
                    std::string(py::str(py::type::handle_of(given).attr("__name__")))));
  }
  const auto array = py::reinterpret_borrow<py::array>(given);
  if (!array.dtype().equal(py::dtype::of<std::uint8_t>())) {
    throw py::type_error(fmt::format("{}: descriptors have bytes of uint8, but this array has {}",
                                     name, std::string(py::str(array.dtype()))));
  }
  if (array.ndim() != 2 || array.shape(1) != kBytes) {
    throw UserError(fmt::format("{}: descriptors have the shape (n, 32), but this array has {}",
                                name, std::string(py::str(array.attr("shape")))));
  }
  std::vector<Descriptor> descriptors(static_cast<std::size_t>(array.shape(0)));
  for (py::ssize_t row = 0; row < array.shape(0); ++row) {
    auto* to = reinterpret_cast<std::byte*>(&descriptors[static_cast<std::size_t>(row)]);
    for (py::ssize_t k = 0; k < kBytes; ++k) {
      std::memcpy(to + k, array.data(row, k), 1);
    }
  }
  return descriptors;
}

}  // namespace striate::python
