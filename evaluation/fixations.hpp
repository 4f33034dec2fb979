#pragma once

#include <filesystem>
#include <map>
#include <opencv2/core/types.hpp>
#include <string>
#include <vector>

namespace striate::evaluation {

/// Where people looked, px of each image; the key is the image's file name.
using Fixations = std::map<std::string, std::vector<cv::Point2d>>;

/// Reads fixations.csv: the heading image,subject,order,x,y[,...], then one fixation a line. Throws
/// UserError with file and line, and what is expected in the folder.
[[nodiscard]] Fixations read_fixations(const std::filesystem::path& file);

/// Throws UserError: `where` is wrong as `why` says, and what is expected.
[[noreturn]] void refuse_fixations(const std::string& where, const std::string& why);

}  // namespace striate::evaluation
