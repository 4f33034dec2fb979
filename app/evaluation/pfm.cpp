#include "app/evaluation/pfm.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

#include "config/user_error.hpp"

namespace striate {

cv::Mat1f read_pfm(const std::filesystem::path& path) {
  constexpr int kLargestSide = 20000;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw UserError(path.string() + ": cannot be read");
  std::string kind;
  int width = 0, height = 0;
  double scale = 0.0;
  file >> kind >> width >> height >> scale;
  if (!file || kind != "Pf" || !std::isfinite(scale) || scale == 0.0) {
    throw UserError(path.string() + ": not a grey PFM picture (Pf, width, height, scale)");
  }
  if (width < 1 || height < 1 || width > kLargestSide || height > kLargestSide) {
    throw UserError(path.string() + ": a PFM picture of " + std::to_string(width) + "x" +
                    std::to_string(height) + " pixels");
  }
  file.get();
  // Before memory is taken for it: a broken header must not ask for a gigabyte.
  const auto here = file.tellg();
  file.seekg(0, std::ios::end);
  const auto wanted = static_cast<std::streamoff>(width) * height * 4;
  if (file.tellg() - here < wanted) throw UserError(path.string() + ": the PFM picture is cut off");
  file.seekg(here);
  cv::Mat1f result(height, width);
  for (int y = height - 1; y >= 0; --y) {  // rows come bottom up
    char* row = reinterpret_cast<char*>(result.ptr(y));
    file.read(row, static_cast<std::streamsize>(width) * 4);
    if (scale > 0.0) {  // big endian
      for (int x = 0; x < width; ++x) std::reverse(row + 4 * x, row + 4 * x + 4);
    }
  }
  if (!file) throw UserError(path.string() + ": the PFM picture is cut off");
  return result;
}

}  // namespace striate
