#include "perception/v1/v1_cells.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <opencv2/core.hpp>
#include <stdexcept>

namespace striate {
namespace {

/// Taps as pairs for the multiply-add: (t0, t1), (t2, t3), ...; `late` starts with a zero.
std::vector<std::int32_t> pack(const std::vector<std::int16_t>& taps, bool late) {
  std::vector<std::int16_t> padded(taps);
  padded.insert(late ? padded.begin() : padded.end(), 0);
  std::vector<std::int32_t> result;
  for (std::size_t k = 0; k + 1 < padded.size(); k += 2) {
    const auto low = static_cast<std::uint16_t>(padded[k]);
    const auto high = static_cast<std::uint32_t>(static_cast<std::uint16_t>(padded[k + 1]));
    result.push_back(static_cast<std::int32_t>(low | (high << 16)));
  }
  return result;
}

/// Of all greys in sixteenths; with 128 taken away they fit what the filters take.
constexpr int kBrightest = (256 << FilterBank::kGreyShift) - 1;

std::int16_t centred(int grey) {
  return static_cast<std::int16_t>(grey - (128 << FilterBank::kGreyShift));
}

int mirror(int at, int size) {
  return cv::borderInterpolate(at, size, cv::BORDER_REFLECT_101);
}

void continue_beyond_border(Plane<std::int16_t>& plane) {
  const int margin = plane.margin_rows();
  for (int y = 0; y < plane.height(); ++y) {
    std::int16_t* row = plane.row(y);
    std::fill(row - margin, row, row[0]);
    std::fill(row + plane.width(), row + plane.width() + margin, row[plane.width() - 1]);
  }
  const int left = plane.margin();
  const std::size_t bytes = sizeof(std::int16_t) * static_cast<std::size_t>(plane.stride());
  for (int y = 1; y <= margin; ++y) {
    std::memcpy(plane.row(-y) - left, plane.row(0) - left, bytes);
    std::memcpy(plane.row(plane.height() - 1 + y) - left, plane.row(plane.height() - 1) - left,
                bytes);
  }
}

}  // namespace

float complex_response(std::int16_t code) {
  const std::int32_t bits = (static_cast<std::int32_t>(code) + 32768 + (127 << 11)) * 4096;
  return std::sqrt(std::max(0.0F, std::bit_cast<float>(bits) - 1.0F));
}

V1Cells::V1Cells(const V1Settings& settings)
    : settings_(settings), bank_(make_filter_bank(settings)) {
  std::size_t most_products = 0;
  for (const FilterBank::Pair& pair : bank_.pairs) {
    std::vector<PackedProduct> products;
    for (const FilterBank::Product& p : pair.products) {
      products.push_back({pack(p.row, false),
                          {pack(p.column_even, false), pack(p.column_even, true)},
                          {pack(p.column_odd, false), pack(p.column_odd, true)},
                          p.slot});
    }
    most_products = std::max(most_products, products.size());
    packed_.push_back(std::move(products));
  }
  row_sums_.resize(most_products);
}

void V1Cells::take_picture(const cv::Mat& grey) {
  const int radius = bank_.radius;
  const int reach = std::max(radius, bank_.box_radius) + 1;
  greys_.resize(grey.cols, grey.rows, reach, 0);
  pixel_pairs_.resize(grey.cols, grey.rows, radius + 1, 0);
  for (int y = 0; y < grey.rows; ++y) {
    std::int16_t* row = greys_.row(y);
    if (grey.depth() == CV_8U) {
      const std::uint8_t* from = grey.ptr<std::uint8_t>(y);
      for (int x = 0; x < grey.cols; ++x) row[x] = centred(from[x] << FilterBank::kGreyShift);
    } else {
      const std::uint16_t* from = grey.ptr<std::uint16_t>(y);
      for (int x = 0; x < grey.cols; ++x) row[x] = centred(std::min<int>(from[x], kBrightest));
    }
    for (int x = 1; x <= reach; ++x) {
      row[-x] = row[mirror(-x, grey.cols)];
      row[grey.cols - 1 + x] = row[mirror(grey.cols - 1 + x, grey.cols)];
    }
    v1_kernels::pair_up(row, radius, grey.cols, pixel_pairs_.row(y));
  }
}

/// Sums of the greys over the kernel's support, by moving windows along rows, then columns.
void V1Cells::sum_boxes() {
  const int radius = bank_.box_radius;
  const int width = greys_.width(), height = greys_.height();
  box_rows_.resize(width, height, 0, 0);
  box_.resize(width, height, 0, 0);
  for (int y = 0; y < height; ++y) {
    const std::int16_t* row = greys_.row(y);
    std::int32_t sum = 0;
    for (int x = -radius; x <= radius; ++x) sum += row[x];
    std::int32_t* to = box_rows_.row(y);
    for (int x = 0; x < width; ++x) {
      to[x] = sum;
      sum += row[x + radius + 1] - row[x - radius];
    }
  }
  std::int32_t* first = box_.row(0);
  std::fill(first, first + width, 0);
  for (int y = -radius; y <= radius; ++y) {
    const std::int32_t* from = box_rows_.row(mirror(y, height));
    for (int x = 0; x < width; ++x) first[x] += from[x];
  }
  for (int y = 1; y < height; ++y) {
    std::copy(box_.row(y - 1), box_.row(y - 1) + width, box_.row(y));
    v1_kernels::slide_box(box_rows_.row(mirror(y + radius, height)),
                          box_rows_.row(mirror(y - radius - 1, height)), width, box_.row(y));
  }
}

void V1Cells::respond_pair(std::size_t index, bool simple_cells, V1Responses& out) {
  const FilterBank::Pair& pair = bank_.pairs[index];
  const std::vector<PackedProduct>& products = packed_[index];
  const int radius = bank_.radius;
  // Row pass on pairs of rows (2j - radius, 2j + 1 - radius).
  const int row_pairs = (out.height + 2 * radius + 3) / 2;
  for (std::size_t k = 0; k < products.size(); ++k) {
    row_sums_[k].resize(out.width, row_pairs, 0, 0);
    for (int j = 0; j < row_pairs; ++j) {
      v1_kernels::filter_rows(pixel_pairs_.row(mirror(2 * j - radius, out.height)),
                              pixel_pairs_.row(mirror(2 * j + 1 - radius, out.height)),
                              products[k].row, out.width, row_sums_[k].row(j));
    }
  }
  job_.taps = radius + 1;
  job_.box_factor = pair.box_factor;
  job_.offset = pair.offset;
  auto responses = [&](int orientation, int y) -> v1_kernels::Responses {
    if (orientation < 0) return {};
    const auto i = static_cast<std::size_t>(orientation);
    if (!simple_cells) return {out.code[i].row(y), nullptr, nullptr};
    return {out.code[i].row(y), out.even[i].row(y), out.odd[i].row(y)};
  };
  for (int y = 0; y < out.height; ++y) {
    job_.slots[0].clear();
    job_.slots[1].clear();
    const auto odd_row = static_cast<std::size_t>(y % 2);
    for (std::size_t k = 0; k < products.size(); ++k) {
      job_.slots[static_cast<std::size_t>(products[k].slot)].push_back(
          {row_sums_[k].row(y / 2), row_sums_[k].stride(), products[k].even[odd_row].data(),
           products[k].odd[odd_row].data()});
    }
    job_.box = pair.box_factor == 0 ? nullptr : box_.row(y);
    job_.direct = responses(pair.orientation, y);
    job_.mirrored = responses(pair.mirrored, y);
    v1_kernels::filter_columns(job_, out.width);
  }
}

void V1Cells::respond(const cv::Mat& grey, int margin, bool simple_cells, V1Responses& out) {
  if (grey.empty()) throw std::invalid_argument("V1Cells: the picture is empty");
  if (grey.type() != CV_8UC1 && grey.type() != CV_16UC1) {
    throw std::invalid_argument("V1Cells: wants grey of 8 bits, or of 16 bits in sixteenths");
  }
  out.width = grey.cols;
  out.height = grey.rows;
  out.wavelength_px = settings_.wavelength_px;
  out.gain = bank_.gain;
  for (std::size_t i = 0; i < kOrientations; ++i) {
    out.code[i].resize(grey.cols, grey.rows, margin, margin);
    if (simple_cells) {
      out.even[i].resize(grey.cols, grey.rows, 0, 0);
      out.odd[i].resize(grey.cols, grey.rows, 0, 0);
    }
  }
  take_picture(grey);
  if (settings_.even_mean != EvenMean::envelope) sum_boxes();
  for (std::size_t k = 0; k < bank_.pairs.size(); ++k) respond_pair(k, simple_cells, out);
  for (Plane<std::int16_t>& plane : out.code) continue_beyond_border(plane);
}

}  // namespace striate
