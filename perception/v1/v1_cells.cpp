#include "striate/perception/v1/v1_cells.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <opencv2/core.hpp>
#include <stdexcept>

namespace striate::perception {
namespace {

/// Taps as pairs for the multiply-add: (t0, t1), (t2, t3), ...; `late` starts with a zero.
std::vector<std::int32_t> pack(std::vector<std::int16_t> taps, bool late) {
  if (late) taps.insert(taps.begin(), 0);
  if (taps.size() % 2 == 1) taps.push_back(0);
  std::vector<std::int32_t> result;
  for (std::size_t k = 0; k + 1 < taps.size(); k += 2) {
    const auto low = static_cast<std::uint16_t>(taps[k]);
    const auto high = static_cast<std::uint32_t>(static_cast<std::uint16_t>(taps[k + 1]));
    result.push_back(static_cast<std::int32_t>(low | (high << 16)));
  }
  return result;
}

/// The right half of a row filter.
v1_kernels::RowTaps fold(const std::vector<std::int16_t>& taps) {
  const auto middle = taps.begin() + static_cast<std::ptrdiff_t>(taps.size() / 2);
  const bool even =
      *middle != 0 || std::equal(middle, taps.end(), taps.rbegin() + (middle - taps.begin()));
  return {even, pack({even ? middle : middle + 1, taps.end()}, false)};
}

/// Of all greys in sixteenths; with 128 taken away they fit what the filters take.
constexpr int kBrightest = (256 << FilterBank::kGreyShift) - 1;

std::int16_t centred(int grey) {
  return static_cast<std::int16_t>(grey - (128 << FilterBank::kGreyShift));
}

void copy_row(const cv::Mat& grey, int y, std::int16_t* row) {
  if (grey.depth() == CV_8U) {
    const std::uint8_t* from = grey.ptr<std::uint8_t>(y);
    for (int x = 0; x < grey.cols; ++x) row[x] = centred(from[x] << FilterBank::kGreyShift);
  } else {
    const std::uint16_t* from = grey.ptr<std::uint16_t>(y);
    for (int x = 0; x < grey.cols; ++x) row[x] = centred(std::min<int>(from[x], kBrightest));
  }
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
  for (const FilterBank::Pair& pair : bank_.pairs) {
    std::vector<PackedProduct> products;
    for (const FilterBank::Product& p : pair.products) {
      products.push_back({fold(p.row),
                          {pack(p.column_even, false), pack(p.column_even, true)},
                          {pack(p.column_odd, false), pack(p.column_odd, true)},
                          static_cast<std::size_t>(p.slot),
                          products_++,
                          std::ranges::any_of(p.column_odd, [](int tap) { return tap != 0; })});
    }
    packed_.push_back(std::move(products));
  }
  job_.offsets.resize(static_cast<std::size_t>(bank_.radius) + 1);
}

void V1Cells::take_image(const cv::Mat& grey) {
  const int beyond = std::max(bank_.radius, bank_.box_radius) + 1;
  image_.resize(grey.cols, grey.rows, beyond, 0);
  beyond_left_.clear();
  beyond_right_.clear();
  for (int k = 1; k <= beyond; ++k) {
    beyond_left_.push_back(mirror(-k, grey.cols));
    beyond_right_.push_back(mirror(grey.cols - 1 + k, grey.cols));
  }
  for (int y = 0; y < grey.rows; ++y) {
    std::int16_t* row = image_.row(y);
    copy_row(grey, y, row);
    for (int k = 1; k <= beyond; ++k) {
      row[-k] = row[beyond_left_[static_cast<std::size_t>(k - 1)]];
      row[grey.cols - 1 + k] = row[beyond_right_[static_cast<std::size_t>(k - 1)]];
    }
  }
}

/// Sums of the greys over the kernel's support, by moving windows along rows, then columns.
void V1Cells::sum_boxes(int height) {
  const int radius = bank_.box_radius, width = image_.width();
  box_rows_.resize(width, height, 0, 0);
  box_.resize(width, height, 0, 0);
  for (int y = 0; y < height; ++y) {
    const std::int16_t* row = image_.row(y);
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

bool V1Cells::is_needed(const PackedProduct& p) const {
  return p.feeds_odd || wanted_.even || wanted_.complex;
}

/// All row filters on rows 2j - radius and 2j + 1 - radius.
void V1Cells::filter_row_pair(int j) {
  const int radius = bank_.radius, width = image_.width();
  std::array<v1_kernels::FoldedRow, 2> rows;
  for (int k = 0; k < 2; ++k) {
    Plane<std::int32_t>& plane = folded_[static_cast<std::size_t>(k)];
    rows[static_cast<std::size_t>(k)] = {plane.row(0), plane.row(v1_kernels::even_pairs(radius)),
                                         plane.stride()};
    const int y = mirror(2 * j + k - radius, image_.height());
    v1_kernels::fold_row(image_.row(y), radius, width, rows[static_cast<std::size_t>(k)]);
  }
  const int place = j % (radius + 1);
  for (const std::vector<PackedProduct>& products : packed_) {
    for (const PackedProduct& p : products) {
      if (!is_needed(p)) continue;
      v1_kernels::filter_rows(rows[0], rows[1], p.row, width,
                              row_sums_.row(p.index * (radius + 1) + place));
    }
  }
}

/// Output rows y (even) and y + 1.
void V1Cells::respond_rows(int y, V1Responses& out) {
  const int pairs = bank_.radius + 1;
  for (int k = 0; k < pairs; ++k) {
    job_.offsets[static_cast<std::size_t>(k)] =
        static_cast<std::ptrdiff_t>((y / 2 + k) % pairs) * row_sums_.stride();
  }
  job_.rows = std::min(v1_kernels::kRowsAtOnce, out.height - y);
  job_.odd_only = !wanted_.even && !wanted_.complex;
  auto responses = [&](int orientation, int row) -> v1_kernels::Responses {
    if (orientation < 0 || row >= out.height) return {};
    const auto i = static_cast<std::size_t>(orientation);
    return {wanted_.complex ? out.code[i].row(row) : nullptr,
            wanted_.even ? out.even[i].row(row) : nullptr,
            wanted_.odd ? out.odd[i].row(row) : nullptr};
  };
  for (std::size_t index = 0; index < packed_.size(); ++index) {
    const FilterBank::Pair& pair = bank_.pairs[index];
    job_.box_factor = pair.box_factor;
    job_.offset = pair.offset;
    job_.slots[0].clear();
    job_.slots[1].clear();
    for (const PackedProduct& p : packed_[index]) {
      if (!is_needed(p)) continue;
      job_.slots[p.slot].push_back({row_sums_.row(p.index * pairs),
                                    {p.even[0].data(), p.even[1].data()},
                                    {p.odd[0].data(), p.odd[1].data()}});
    }
    for (int r = 0; r < job_.rows; ++r) {
      const auto row = static_cast<std::size_t>(r);
      job_.box[row] = pair.box_factor == 0 ? nullptr : box_.row(y + r);
      job_.direct[row] = responses(pair.orientation, y + r);
      job_.mirrored[row] = responses(pair.mirrored, y + r);
    }
    v1_kernels::filter_columns(job_, out.width);
  }
}

void V1Cells::respond(const cv::Mat& grey, int margin, bool simple_cells, V1Responses& out) {
  wanted_ = {true, simple_cells, simple_cells};
  for (Plane<std::int16_t>& plane : out.code) plane.resize(grey.cols, grey.rows, margin, margin);
  respond(grey, out);
  for (Plane<std::int16_t>& plane : out.code) continue_beyond_border(plane);
}

void V1Cells::respond_simple(const cv::Mat& grey, SimpleCells which, V1Responses& out) {
  wanted_ = {false, which == SimpleCells::even_and_odd, true};
  respond(grey, out);
}

/// What is wanted; the codes' planes have the image's size.
void V1Cells::respond(const cv::Mat& grey, V1Responses& out) {
  if (grey.empty()) throw std::invalid_argument("V1Cells: the image is empty");
  if (grey.type() != CV_8UC1 && grey.type() != CV_16UC1) {
    throw std::invalid_argument("V1Cells: wants grey of 8 bits, or of 16 bits in sixteenths");
  }
  out.width = grey.cols;
  out.height = grey.rows;
  out.wavelength_px = settings_.wavelength_px;
  out.gain = bank_.gain;
  for (std::size_t i = 0; i < kOrientations; ++i) {
    if (wanted_.even) out.even[i].resize(grey.cols, grey.rows, 0, 0);
    if (wanted_.odd) out.odd[i].resize(grey.cols, grey.rows, 0, 0);
  }
  take_image(grey);
  if (settings_.even_mean != EvenMean::envelope) sum_boxes(grey.rows);
  const int radius = bank_.radius;
  row_sums_.resize(grey.cols, products_ * (radius + 1), 0, 0);
  for (Plane<std::int32_t>& plane : folded_) {
    plane.resize(grey.cols, v1_kernels::even_pairs(radius) + v1_kernels::odd_pairs(radius), 0, 0);
  }
  for (int j = 0; j < radius; ++j) filter_row_pair(j);
  for (int y = 0; y < grey.rows; y += v1_kernels::kRowsAtOnce) {
    filter_row_pair(y / 2 + radius);
    respond_rows(y, out);
  }
}

}  // namespace striate::perception
