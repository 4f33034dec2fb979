#include "striate/evaluation/homography_sequence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "striate/base/user_error.hpp"
#include "striate/evaluation/images/set_files.hpp"
#include "striate/platform/datasets/images/read_image.hpp"

namespace striate::evaluation {
namespace {

namespace fs = std::filesystem;

/// How the files of a layout are named; the second image is number 2.
struct SequenceLayout {
  const char* image;
  const char* homography;
};
/// Names of images and homographies: Oxford's and HPatches'
constexpr SequenceLayout kSequenceLayouts[] = {{"img{}", "H1to{}p"}, {"{}", "H_1_{}"}};

/// The image of that number; empty where there is none.
fs::path picture_file(const fs::path& folder, const SequenceLayout& layout, int number) {
  for (const char* ending : {"ppm", "pgm", "png", "jpg", "jpeg", "bmp"}) {
    fs::path file =
        folder / (fmt::format(fmt::runtime(layout.image), number) + std::string(".") + ending);
    if (fs::is_regular_file(file)) return file;
  }
  return {};
}

fs::path homography_file(const fs::path& folder, const SequenceLayout& layout, int number) {
  return folder / fmt::format(fmt::runtime(layout.homography), number);
}

const SequenceLayout* layout_of(const fs::path& folder) {
  for (const SequenceLayout& layout : kSequenceLayouts) {
    if (!picture_file(folder, layout, 1).empty() && !picture_file(folder, layout, 2).empty() &&
        fs::is_regular_file(homography_file(folder, layout, 2))) {
      return &layout;
    }
  }
  return nullptr;
}

}  // namespace

std::vector<fs::path> find_homography_sequences(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code code;
  if (fs::is_directory(folder, code)) {
    if (layout_of(folder) != nullptr) return {folder};
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (entry.is_directory() && layout_of(entry.path()) != nullptr) found.push_back(entry.path());
    }
  }
  if (found.empty()) {
    throw UserError(fmt::format(
        "{}: no sequence of images with homographies\n"
        "    expected in the folder or its subfolders: img1.ppm, img2.ppm, H1to2p, ... (Oxford)\n"
        "    or 1.ppm, 2.ppm, H_1_2, ... (HPatches); images may be ppm, pgm, png, jpg or bmp",
        folder.string()));
  }
  std::ranges::sort(found);
  return found;
}

HomographySequence read_homography_sequence(const fs::path& folder) {
  const SequenceLayout* layout = layout_of(folder);
  if (layout == nullptr) throw UserError(folder.string() + ": not a sequence with homographies");
  HomographySequence sequence;
  sequence.name = fs::absolute(folder).lexically_normal().filename().string();
  if (sequence.name.empty()) sequence.name = folder.parent_path().filename().string();
  sequence.pictures.push_back(datasets::read_any_grey(picture_file(folder, *layout, 1)));
  for (int number = 2;; ++number) {
    const fs::path image = picture_file(folder, *layout, number);
    const fs::path homography = homography_file(folder, *layout, number);
    if (image.empty() || !fs::is_regular_file(homography)) break;
    sequence.pictures.push_back(datasets::read_any_grey(image));
    sequence.to.push_back(read_homography(homography));
  }
  return sequence;
}

cv::Point2d projected(const cv::Matx33d& h, cv::Point2d at) {
  const cv::Vec3d to = h * cv::Vec3d(at.x, at.y, 1.0);
  return {to[0] / to[2], to[1] / to[2]};
}

}  // namespace striate::evaluation
