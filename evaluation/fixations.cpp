#include "striate/evaluation/fixations.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "striate/base/user_error.hpp"

namespace striate::evaluation {

void refuse_fixations(const std::string& where, const std::string& why) {
  throw UserError(
      fmt::format("{}: {}; expected in the folder: fixations.csv with the first line\n"
                  "  image,subject,order,x,y,duration_ms\n"
                  "(x, y in px of the image), and the images beside it or in stimuli/",
                  where, why));
}

Fixations read_fixations(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line;
  if (!in || !std::getline(in, line)) refuse_fixations(file.string(), "is missing or empty");
  if (line.rfind("image,subject,order,x,y", 0) != 0) {
    refuse_fixations(file.string() + ":1", "is not the heading of such a file");
  }
  Fixations fixations;
  for (int number = 2; std::getline(in, line); ++number) {
    if (line.empty() || line == "\r") continue;
    std::stringstream row(line);
    std::array<std::string, 5> cells;
    for (std::string& cell : cells) std::getline(row, cell, ',');
    try {
      const cv::Point2d at(std::stod(cells[3]), std::stod(cells[4]));
      if (!std::isfinite(at.x) || !std::isfinite(at.y)) throw std::out_of_range("not finite");
      fixations[cells[0]].push_back(at);
    } catch (const std::logic_error&) {
      refuse_fixations(fmt::format("{}:{}", file.string(), number), "x and y are no numbers");
    }
  }
  if (fixations.empty()) refuse_fixations(file.string(), "holds no fixation");
  return fixations;
}

}  // namespace striate::evaluation
