#include "striate/platform/datasets/maps/read_map.hpp"

#include <fmt/format.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <vector>

#include "striate/base/files.hpp"
#include "striate/config/quantity.hpp"
#include "striate/platform/datasets/calibration/text_tree.hpp"
#include "striate/platform/datasets/images/read_image.hpp"

namespace striate::datasets {
namespace {

using config::Diagnostics;
using config::Node;

/// What the YAML says beside the picture's name; defaults are those of Nav2's map_server.
struct MapHeader {
  std::string image;
  double cell_m = 0.0;
  std::vector<double> origin{0.0, 0.0, 0.0};
  bool negate = false;
  double occupied = 0.65;  // probability above which a cell stands
  double free = 0.25;      // probability below which a cell is free
};

/// The value of a key that must be so many numbers; false where it is not there or none.
bool read_numbers(const Node& root, const char* key, std::size_t least, bool required,
                  Diagnostics& diagnostics, std::vector<double>& numbers) {
  const Node* node = first_of(root, {key});
  if (node == nullptr) {
    if (required) {
      diagnostics.add(config::fault::missing_key, root.place, fmt::format("'{}' is missing", key),
                      "a map of map_server has image, resolution and origin");
    }
    return false;
  }
  const std::size_t before = diagnostics.count();
  numbers = numbers_of(*node, key, diagnostics);
  if (diagnostics.count() == before && numbers.size() < least) {
    diagnostics.add(config::fault::wrong_kind, node->place,
                    fmt::format("'{}' must be {} numbers, but is {}", key, least, numbers.size()));
  }
  return diagnostics.count() == before;
}

void read_number(const Node& root, const char* key, bool required, config::Range range,
                 Diagnostics& diagnostics, double& target) {
  std::vector<double> numbers;
  if (!read_numbers(root, key, 1, required, diagnostics, numbers)) return;
  if (numbers[0] < range.low || numbers[0] > range.high) {
    diagnostics.add(config::fault::out_of_range, first_of(root, {key})->place,
                    fmt::format("'{}' is {:g}; it must lie between {:g} and {:g}", key, numbers[0],
                                range.low, range.high));
    return;
  }
  target = numbers[0];
}

/// Not by read_number(): some write `negate: false`.
bool read_negate(const Node& root) {
  const Node* node = first_of(root, {"negate"});
  return node != nullptr && (node->text == "1" || node->text == "true" || node->text == "True");
}

MapHeader read_header(const Node& root, Diagnostics& diagnostics) {
  constexpr config::Range kCell_m{0.005, 1.0};  // from a desk to a field (ours)
  constexpr double kStraight_rad = 1e-4;        // turned less than a cell in 1000 (ours)
  MapHeader header;
  if (const Node* image = first_of(root, {"image"}); image != nullptr && !image->text.empty()) {
    header.image = image->text;
  } else {
    diagnostics.add(config::fault::missing_key, root.place, "'image' is missing",
                    "a map of map_server has image, resolution and origin");
  }
  read_number(root, "resolution", true, kCell_m, diagnostics, header.cell_m);
  read_number(root, "occupied_thresh", false, {0.0, 1.0}, diagnostics, header.occupied);
  read_number(root, "free_thresh", false, {0.0, 1.0}, diagnostics, header.free);
  header.negate = read_negate(root);
  std::vector<double> origin;
  if (read_numbers(root, "origin", 2, false, diagnostics, origin)) {
    header.origin = origin;
    if (origin.size() > 2 && std::abs(origin[2]) > kStraight_rad) {
      diagnostics.add(config::fault::out_of_range, first_of(root, {"origin"})->place,
                      fmt::format("the map is turned by {:g} rad", origin[2]),
                      "turn the picture instead and write 0 as the third number of 'origin'");
    }
  }
  return header;
}

MapCell cell_of(std::uint8_t grey, const MapHeader& header) {
  constexpr double kWhite = 255.0;  // grey levels of 8 bits
  const double stands = (header.negate ? grey : kWhite - grey) / kWhite;
  if (stands > header.occupied) return MapCell::stands;
  return stands < header.free ? MapCell::free : MapCell::unknown;
}

}  // namespace

OccupancyMap read_map(const std::filesystem::path& file) {
  Diagnostics diagnostics(file.string());
  const Node root = read_tree(read_file(file.string()), diagnostics);
  diagnostics.throw_if_any();
  const MapHeader header = read_header(root, diagnostics);
  diagnostics.throw_if_any();
  const cv::Mat1b picture = read_any_grey(file.parent_path() / header.image);
  OccupancyMap map;
  map.cell_m = header.cell_m;
  map.origin = {header.origin[0], header.origin[1]};
  map.cells.create(picture.size());
  for (int row = 0; row < picture.rows; ++row) {
    for (int column = 0; column < picture.cols; ++column) {
      map.cells(picture.rows - 1 - row, column) =
          static_cast<std::uint8_t>(cell_of(picture(row, column), header));
    }
  }
  return map;
}

}  // namespace striate::datasets
