#include "striate/evaluation/striate_patch_methods.hpp"

#include <algorithm>
#include <functional>
#include <memory>
#include <opencv2/imgproc.hpp>

#include "striate/perception/descriptor/dense_descriptor.hpp"
#include "striate/perception/descriptor/striate_descriptor.hpp"

namespace striate::evaluation {
namespace {

constexpr int kBytes = 32;  // of a descriptor of 256 bits

void write_row(const perception::Descriptor& descriptor, std::uint8_t* row) {
  for (std::size_t b = 0; b < kBytes; ++b) {
    row[b] = static_cast<std::uint8_t>(descriptor.words[b / 8] >> (b % 8 * 8));
  }
}

/// What describes one frame, into a row of one or more descriptors.
using DescribeFrame = std::function<void(const perception::DescribedFrame&, std::uint8_t* row)>;

/// Every patch by itself, so that nothing beyond it is seen.
cv::Mat describe_patches(const cv::Mat1b& mosaic, int patches, double size_px, int descriptions,
                         perception::StriateDescriber& describer, const DescribeFrame& describe) {
  cv::Mat1b rows(patches, descriptions * kBytes);
  for (int k = 0; k < patches; ++k) {
    const cv::Point2f at = patch_centre_px(k);
    const cv::Point corner(static_cast<int>(at.x) - kPatchSide_px / 2 + 1,
                           static_cast<int>(at.y) - kPatchSide_px / 2 + 1);
    describer.prepare(mosaic(cv::Rect(corner, cv::Size(kPatchSide_px, kPatchSide_px))));
    describe({at.x - corner.x, at.y - corner.y, size_px, 0.0}, rows.ptr(k));
  }
  return rows;
}

/// A frame's diameter in a patch of 8 diameters, 64 px, and 10 % to either side
const std::vector<double> kSizes_px = {7.2, 8.0, 9.0};

PatchMethod with_given_angle() {
  auto describer = std::make_shared<perception::StriateDescriber>(perception::StriateSettings{});
  return {"Striate", kSizes_px, [describer](const cv::Mat1b& mosaic, int patches, double size_px) {
            std::vector<perception::Descriptor> one;
            return describe_patches(
                mosaic, patches, size_px, 1, *describer,
                [&](const perception::DescribedFrame& frame, std::uint8_t* row) {
                  describer->describe({&frame, 1}, one);
                  write_row(one.front(), row);
                });
          }};
}

/// One that has a single angle says the same twice.
PatchMethod with_its_own_angles() {
  auto describer = std::make_shared<perception::StriateDescriber>(perception::StriateSettings{});
  return {"Striate, own angles", kSizes_px,
          [describer](const cv::Mat1b& mosaic, int patches, double size_px) {
            std::vector<perception::DescribedFrame> turned;
            std::vector<perception::Descriptor> one;
            return describe_patches(
                mosaic, patches, size_px, 2, *describer,
                [&](const perception::DescribedFrame& frame, std::uint8_t* row) {
                  describer->describe_oriented({&frame, 1}, true, turned, one);
                  write_row(one.front(), row);
                  write_row(one.back(), row + kBytes);
                });
          },
          2};
}

/// At lambda = size, on the mosaic at half its size.
cv::Mat describe_as_the_paper(const cv::Mat1b& mosaic, int patches, double wavelength_px) {
  cv::Mat1b half, rows(patches, kBytes);
  cv::resize(mosaic, half, {}, 0.5, 0.5, cv::INTER_AREA);
  perception::V1Settings settings;
  settings.wavelength_px = wavelength_px / 2.0;
  perception::V1Cells cells(settings);
  perception::V1Responses responses;
  cells.respond(half, perception::descriptor_reach(settings.wavelength_px, 1.0), false, responses);
  const auto points = perception::descriptor_points(settings.wavelength_px, 1.0);
  for (int k = 0; k < patches; ++k) {
    const cv::Point2f at = patch_centre_px(k);
    write_row(perception::describe_pixel(responses, points, static_cast<int>(at.x / 2.0F),
                                         static_cast<int>(at.y / 2.0F)),
              rows.ptr(k));
  }
  return rows;
}

}  // namespace

std::vector<PatchMethod> striate_patch_methods() {
  return {with_given_angle(),
          with_its_own_angles(),
          {"the paper's", {8.0, 16.0, 20.0}, describe_as_the_paper, 1}};
}

}  // namespace striate::evaluation
