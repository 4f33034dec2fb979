#include "striate/app/commands/taught_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <opencv2/core.hpp>
#include <optional>

#include "striate/agent/teaching/image_view.hpp"
#include "striate/agent/teaching/thing_in_picture.hpp"
#include "striate/base/user_error.hpp"
#include "striate/platform/datasets/images/read_image.hpp"

namespace striate::app {
namespace {

/// Files as they are; of a folder all images, by name.
std::vector<std::string> image_files(const std::vector<std::string>& given) {
  std::vector<std::string> files;
  for (const std::string& one : given) {
    if (!std::filesystem::is_directory(one)) {
      files.push_back(one);
      continue;
    }
    std::vector<std::string> inside;
    for (const auto& entry : std::filesystem::directory_iterator(one)) {
      if (datasets::is_image(entry.path())) inside.push_back(entry.path());
    }
    if (inside.empty()) {
      throw UserError(fmt::format("{}: no image in it (png, jpg, bmp, ppm, pgm, tif, webp)", one));
    }
    std::sort(inside.begin(), inside.end());
    files.insert(files.end(), inside.begin(), inside.end());
  }
  return files;
}

/// "x,y,w,h" in pixels of the upright picture.
cv::Rect read_crop(const std::string& text) {
  std::array<int, 4> numbers{};
  const char* at = text.data();
  const char* const end = at + text.size();
  std::size_t read = 0;
  while (read < numbers.size()) {
    const auto [after, error] = std::from_chars(at, end, numbers[read]);
    if (error != std::errc() || (after != end && *after != ',')) break;
    ++read;
    if (after == end) {
      at = after;
      break;
    }
    at = after + 1;
  }
  const cv::Rect crop(numbers[0], numbers[1], numbers[2], numbers[3]);
  const bool all = read == numbers.size() && at == end && text.back() != ',';
  if (all && crop.width > 0 && crop.height > 0) return crop;
  throw UserError(fmt::format(
      "--crop {}: four whole numbers in pixels are needed, of the part's left upper corner, its "
      "width and its height\n    striate teach NAME --image PICTURE --crop 120,80,300,200",
      text));
}

/// One for each picture; empty where nothing was said.
std::vector<cv::Rect> crops_for(const TaughtPictures& given, std::size_t pictures) {
  std::vector<cv::Rect> crops;
  for (const std::string& text : given.crop) crops.push_back(read_crop(text));
  if (crops.size() == 1) crops.resize(pictures, crops.front());
  if (crops.empty() || crops.size() == pictures) return crops;
  throw UserError(fmt::format("{} --crop for {} pictures: give one for all, or one for each",
                              crops.size(), pictures));
}

std::string share_text(const std::string& file, double share, const char* why) {
  return fmt::format("{}: kept {:.0f} % of the picture{}", file, 100.0 * share, why);
}

/// One of them, upright.
struct Picture {
  std::string file;
  cv::Mat3b image;
};

void add_part(const Picture& picture, const cv::Rect& part,
              const memory::LongTermSettings& settings, PictureViews& seen) {
  const cv::Mat3b& image = picture.image;
  const cv::Rect whole(0, 0, image.cols, image.rows);
  if ((part & whole) != part) {
    throw UserError(fmt::format("--crop {},{},{},{}: goes beyond {}, which is {} x {} px", part.x,
                                part.y, part.width, part.height, picture.file, image.cols,
                                image.rows));
  }
  seen.views.push_back(agent::view_of_image(image(part), settings));
  const double share = static_cast<double>(part.area()) / whole.area();
  seen.shares.push_back(share_text(picture.file, share, ""));
}

void add_thing(const Picture& picture, bool whole, const memory::LongTermSettings& settings,
               PictureViews& seen) {
  const cv::Mat3b& image = picture.image;
  const auto thing = whole ? std::optional<agent::ThingInPicture>() : agent::find_thing(image);
  if (!thing) {
    seen.views.push_back(agent::view_of_image(image, settings));
    seen.shares.push_back(share_text(picture.file, 1.0, ""));
    return;
  }
  seen.views.push_back(agent::view_of_image(image(thing->box), settings, thing->inside));
  seen.shares.push_back(
      share_text(picture.file, thing->share,
                 ", the thing before its background (--whole keeps all of it, --crop a part)"));
}

}  // namespace

PictureViews views_of_pictures(const TaughtPictures& given,
                               const memory::LongTermSettings& settings) {
  const std::vector<std::string> files = image_files(given.images);
  const std::vector<cv::Rect> crops = crops_for(given, files.size());
  PictureViews seen;
  for (std::size_t k = 0; k < files.size(); ++k) {
    const Picture picture{files[k], datasets::read_any_image(files[k])};
    if (crops.empty()) {
      add_thing(picture, given.whole, settings, seen);
    } else {
      add_part(picture, crops[k], settings, seen);
    }
  }
  return seen;
}

}  // namespace striate::app
