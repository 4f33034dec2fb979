#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>

namespace striate::perception {

/// A 2-D array for SIMD: rows start on 64-byte boundaries and may be read and written from
/// `margin` elements before column 0 to at least `margin` elements behind the last column, and on
/// `margin_rows` rows above and below. Growing only: resizing to what fits does not allocate.
template <class T>
class Plane {
 public:
  /// Contents are undefined after a change of shape.
  void resize(int width, int height, int margin, int margin_rows) {
    /// Elements in a line of the cache, 64 bytes
    constexpr int kLine = static_cast<int>(64 / sizeof(T));
    // Vector loops run over the end of a row by up to one step: 64 bytes, 128 for wider elements.
    constexpr int kStep = sizeof(T) == 1 ? kLine : 2 * kLine;
    auto round_up = [](int value, int unit) { return (value + unit - 1) / unit * unit; };
    const int left = round_up(margin, kLine);
    const int right = round_up(std::max(width + margin, round_up(width, kStep)), kLine);
    width_ = width;
    height_ = height;
    margin_ = left;
    margin_rows_ = margin_rows;
    stride_ = left + right;
    const std::size_t rows = static_cast<std::size_t>(height) + 2U * margin_rows;
    const std::size_t count = rows * static_cast<std::size_t>(stride_);
    if (count <= capacity_) return;
    const std::size_t bytes = (count * sizeof(T) + 63) / 64 * 64 + kSlackBytes;
    data_.reset(static_cast<T*>(std::aligned_alloc(64, bytes)));
    if (!data_) throw std::bad_alloc();
    std::memset(data_.get(), 0, bytes);
    capacity_ = count;
  }

  [[nodiscard]] T* row(int y) {
    return data_.get() + static_cast<std::ptrdiff_t>(y + margin_rows_) * stride_ + margin_;
  }
  [[nodiscard]] const T* row(int y) const {
    return data_.get() + static_cast<std::ptrdiff_t>(y + margin_rows_) * stride_ + margin_;
  }
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] int stride() const { return stride_; }
  /// Elements before column 0; behind the last column it is at least what was asked for.
  [[nodiscard]] int margin() const { return margin_; }
  [[nodiscard]] int margin_rows() const { return margin_rows_; }

 private:
  static constexpr std::size_t kSlackBytes = 256;  ///< behind the last row, for vector loads
  struct Free {
    void operator()(T* data) const { std::free(data); }
  };
  std::unique_ptr<T[], Free> data_;
  std::size_t capacity_ = 0;
  int width_ = 0;
  int height_ = 0;
  int margin_ = 0;
  int margin_rows_ = 0;
  int stride_ = 0;
};

}  // namespace striate::perception
