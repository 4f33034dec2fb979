#include "app/evaluation/striate_patch_methods.hpp"

#include <algorithm>
#include <memory>
#include <opencv2/imgproc.hpp>

#include "perception/descriptor/dense_descriptor.hpp"
#include "perception/descriptor/striate_descriptor.hpp"

namespace striate {
namespace {

constexpr int kBytes = 32;

void write_row(const Descriptor& descriptor, std::uint8_t* row) {
  for (std::size_t b = 0; b < kBytes; ++b) {
    row[b] = static_cast<std::uint8_t>(descriptor.words[b / 8] >> (b % 8 * 8));
  }
}

PatchMethod ours(const char* name, StriateOrientation orientation) {
  StriateSettings settings;
  settings.orientation = orientation;
  auto describer = std::make_shared<StriateDescriber>(settings);
  return {name, {7.2, 8.0, 9.0}, [describer](const cv::Mat1b& mosaic, int patches, double size_px) {
            cv::Mat1b rows(patches, kBytes);
            std::vector<Descriptor> one;
            for (int k = 0; k < patches; ++k) {
              const cv::Point2f at = patch_centre_px(k);
              const cv::Point corner(static_cast<int>(at.x) - kPatchSide_px / 2 + 1,
                                     static_cast<int>(at.y) - kPatchSide_px / 2 + 1);
              describer->prepare(mosaic(cv::Rect(corner, cv::Size(kPatchSide_px, kPatchSide_px))));
              const DescribedFrame frame{at.x - corner.x, at.y - corner.y, size_px, 0.0};
              describer->describe({&frame, 1}, one);
              write_row(one.front(), rows.ptr(k));
            }
            return cv::Mat(rows);
          }};
}

/// At lambda = size, on the mosaic at half its size.
cv::Mat describe_as_the_paper(const cv::Mat1b& mosaic, int patches, double wavelength_px) {
  cv::Mat1b half, rows(patches, kBytes);
  cv::resize(mosaic, half, {}, 0.5, 0.5, cv::INTER_AREA);
  V1Settings settings;
  settings.wavelength_px = wavelength_px / 2.0;
  V1Cells cells(settings);
  V1Responses responses;
  cells.respond(half, descriptor_reach(settings.wavelength_px, 1.0), false, responses);
  const auto points = descriptor_points(settings.wavelength_px, 1.0);
  for (int k = 0; k < patches; ++k) {
    const cv::Point2f at = patch_centre_px(k);
    write_row(describe_pixel(responses, points, static_cast<int>(at.x / 2.0F),
                             static_cast<int>(at.y / 2.0F)),
              rows.ptr(k));
  }
  return rows;
}

}  // namespace

std::vector<PatchMethod> striate_patch_methods() {
  return {ours("Striate", StriateOrientation::given),
          ours("Striate, own angle", StriateOrientation::dominant),
          {"the paper's", {8.0, 16.0, 20.0}, describe_as_the_paper}};
}

}  // namespace striate
