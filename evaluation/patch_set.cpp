#include "striate/evaluation/patch_set.hpp"

#include <opencv2/core.hpp>
#include <stdexcept>

namespace striate::evaluation {
namespace {

constexpr int kPatchesPerMosaic = kMosaicPatches * kMosaicPatches;  // in one mosaic

cv::Rect place(int number) {
  const int within = number % kPatchesPerMosaic;
  return {within % kMosaicPatches * kPatchSide_px, within / kMosaicPatches * kPatchSide_px,
          kPatchSide_px, kPatchSide_px};
}

}  // namespace

int PatchSet::add(const cv::Mat1b& patch) {
  if (patch.size() != cv::Size(kPatchSide_px, kPatchSide_px)) {
    throw std::invalid_argument("PatchSet: a patch must have 64x64 px");
  }
  const int number = count++;
  if (number % kPatchesPerMosaic == 0) {
    const int side_px = kMosaicPatches * kPatchSide_px;
    mosaics.emplace_back(side_px, side_px, std::uint8_t{128});
  }
  patch.copyTo(this->patch(number));
  return number;
}

cv::Mat1b PatchSet::patch(int number) const {
  return mosaics.at(static_cast<std::size_t>(number / kPatchesPerMosaic))(place(number));
}

cv::Point2f patch_centre_px(int number) {
  const cv::Rect at = place(number);
  return {static_cast<float>(at.x) + 0.5F * (kPatchSide_px - 1),
          static_cast<float>(at.y) + 0.5F * (kPatchSide_px - 1)};
}

}  // namespace striate::evaluation
