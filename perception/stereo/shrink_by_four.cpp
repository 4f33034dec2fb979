#include "perception/stereo/shrink_by_four.hpp"

#include <cstdint>
#include <vector>

namespace striate {
namespace {

/// Adds up four rows.
void add_rows(const cv::Mat& picture, int first, std::vector<std::uint16_t>& sums) {
  const uchar* a = picture.ptr(first);
  const uchar* b = picture.ptr(first + 1);
  const uchar* c = picture.ptr(first + 2);
  const uchar* d = picture.ptr(first + 3);
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

bool is_four_times(const cv::Mat& picture, int width) {
  return picture.cols == 4 * width && picture.rows % 4 == 0;
}

cv::Mat sums_of_fours(const cv::Mat& picture) {
  CV_Assert(picture.depth() == CV_8U && (picture.channels() == 1 || picture.channels() == 3));
  CV_Assert(picture.cols % 4 == 0 && picture.rows % 4 == 0);
  cv::Mat sums(picture.rows / 4, picture.cols / 4, CV_16UC(picture.channels()));
  std::vector<std::uint16_t> rows(static_cast<std::size_t>(picture.cols) * picture.channels());
  for (int v = 0; v < sums.rows; ++v) {
    add_rows(picture, 4 * v, rows);
    const auto add = picture.channels() == 1 ? add_columns<1> : add_columns<3>;
    add(rows.data(), sums.cols, sums.ptr<std::uint16_t>(v));
  }
  return sums;
}

cv::Mat means_of_fours(const cv::Mat& picture) {
  const cv::Mat sums = sums_of_fours(picture);
  cv::Mat means(sums.size(), CV_8UC(picture.channels()));
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

}  // namespace striate
