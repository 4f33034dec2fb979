#include "striate/perception/stereo/shrink_by_four.hpp"

#include <cstdint>
#include <vector>

namespace striate::perception {
namespace {

/// Adds up four rows.
void add_rows(const cv::Mat& image, int first, std::vector<std::uint16_t>& sums) {
  const uchar* a = image.ptr(first);
  const uchar* b = image.ptr(first + 1);
  const uchar* c = image.ptr(first + 2);
  const uchar* d = image.ptr(first + 3);
  for (std::size_t i = 0; i < sums.size(); ++i) {
    sums[i] = static_cast<std::uint16_t>(a[i] + b[i] + c[i] + d[i]);
  }
}

/// Adds up four neighbours of the same channel.
template <int kChannels>
void add_columns(const std::uint16_t* columns, int width, std::uint16_t* to) {
  for (int u = 0; u < width; ++u, columns += 4 * kChannels, to += kChannels) {
    for (int c = 0; c < kChannels; ++c) {
      to[c] = static_cast<std::uint16_t>(columns[c] + columns[c + kChannels] +
                                         columns[c + 2 * kChannels] + columns[c + 3 * kChannels]);
    }
  }
}

}  // namespace

bool is_four_times(const cv::Mat& image, int width) {
  return image.cols == 4 * width && image.rows % 4 == 0;
}

cv::Mat sums_of_fours(const cv::Mat& image) {
  CV_Assert(image.depth() == CV_8U && (image.channels() == 1 || image.channels() == 3));
  CV_Assert(image.cols % 4 == 0 && image.rows % 4 == 0);
  cv::Mat sums(image.rows / 4, image.cols / 4, CV_16UC(image.channels()));
  std::vector<std::uint16_t> rows(static_cast<std::size_t>(image.cols) * image.channels());
  for (int v = 0; v < sums.rows; ++v) {
    add_rows(image, 4 * v, rows);
    const auto add = image.channels() == 1 ? add_columns<1> : add_columns<3>;
    add(rows.data(), sums.cols, sums.ptr<std::uint16_t>(v));
  }
  return sums;
}

cv::Mat means_of_fours(const cv::Mat& image) {
  const cv::Mat sums = sums_of_fours(image);
  cv::Mat means(sums.size(), CV_8UC(image.channels()));
  const int length = means.cols * means.channels();
  for (int v = 0; v < means.rows; ++v) {
    const auto* sum = sums.ptr<std::uint16_t>(v);
    uchar* mean = means.ptr(v);
    for (int i = 0; i < length; ++i) {
      const int odd = (sum[i] >> 4) & 1;
      mean[i] = static_cast<uchar>((sum[i] + 7 + odd) >> 4);
    }
  }
  return means;
}

}  // namespace striate::perception
