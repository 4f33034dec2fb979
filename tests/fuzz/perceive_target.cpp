#include <opencv2/imgcodecs.hpp>

#include "striate/app/perceive.hpp"
#include "striate/base/files.hpp"
#include "striate/base/user_error.hpp"
#include "tests/fuzz/fuzz_target.hpp"
#include "tests/fuzz/odd_numbers.hpp"

using namespace striate;

namespace {

/// Noise, shifted from eye to eye by more and more.
void write_pair(const ScratchFolder& folder, const std::string& name, cv::Size size) {
  cv::Mat1b wide(size.height, size.width + 24);
  cv::RNG random(3);
  random.fill(wide, cv::RNG::UNIFORM, 0, 255);
  cv::Mat1b right = wide.colRange(8, 8 + size.width).clone();
  const int half = size.height / 2;
  wide.rowRange(half, size.height)
      .colRange(20, 20 + size.width)
      .copyTo(right.rowRange(half, size.height));
  cv::imwrite(folder / (name + "_left.png"), wide.colRange(0, size.width));
  cv::imwrite(folder / (name + "_right.png"), right);
}

const ScratchFolder& folder() {
  static const ScratchFolder scratch;
  static const bool written = [] {
    write_pair(scratch, "0", {64, 48});
    write_pair(scratch, "1", {160, 120});
    write_pair(scratch, "2", {24, 96});
    return true;
  }();
  (void)written;
  return scratch;
}

}  // namespace

/// The input changes what the command line says of the camera.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  app::PerceiveOptions options;
  fuzz::OddNumbers odd(data, size);
  const bool more = odd.next();
  const std::string pair = std::to_string(more ? odd.raw() % 3 : 0);
  options.left = folder() / (pair + "_left.png");
  options.right = folder() / (pair + "_right.png");
  options.out = folder() / "out";
  options.mode = odd.which(4) == 0 ? "paper" : "robust";
  double centre_u_px = 32.0;
  double centre_v_px = 24.0;
  double height_m = 1.0;
  options.focal_px = 80.0;
  options.baseline_m = 0.12;
  options.tilt_deg = -10.0;
  const std::vector<double*> numbers = {&options.focal_px, &options.baseline_m, &height_m,
                                        &options.tilt_deg, &centre_u_px,        &centre_v_px};
  while (odd.next()) {
    double& one = *numbers[odd.which(numbers.size())];
    one = odd.changed(one);
  }
  options.centre_u_px = centre_u_px;
  options.centre_v_px = centre_v_px;
  if (size % 8 != 0) options.camera_height_m = height_m;
  try {
    (void)app::perceive(options);
  } catch (const UserError&) {
  }
  return 0;
}

std::vector<std::string> striate::fuzz::seeds() {
  (void)folder();
  return fuzz::lists_of_changes();
}
