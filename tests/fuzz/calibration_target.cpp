#include "striate/base/user_error.hpp"
#include "striate/platform/datasets/calibration/picture_rectifier.hpp"
#include "striate/platform/datasets/calibration/read_calibration.hpp"
#include "tests/fuzz/fuzz_target.hpp"
#include "tests/unit/datasets/calibration_texts.hpp"

using namespace striate;

/// Any text as a calibration; what passes makes maps for small pictures.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    const datasets::StereoModel model = datasets::read_calibration_text({text}, {"input"});
    const datasets::PictureRectifier rectifier(model, {32, 24}, false);
    StereoFrame frame;
    const cv::Mat3b picture(24, 32, cv::Vec3b(1, 2, 3));
    rectifier.rectify(picture, model.right ? picture : cv::Mat3b(), frame);
  } catch (const UserError&) {
  }
  return 0;
}

std::vector<std::string> striate::fuzz::seeds() {
  using namespace datasets::written;
  const cv::Matx34d p(400, 0, 320, 0, 0, 400, 240, 0, 0, 0, 1, 0);
  return {opencv("M1", "D1", "M2", "D2"),
          opencv_as_xml(),
          json(),
          kalibr(),
          boofcv(),
          euroc(kLeft, kLensLeft, cv::Matx44d::eye()),
          camera_info(kLeft, kLensLeft, kTurn, p),
          camera_info_message(kLeft, kLensLeft, kTurn, p),
          opencv_yaml("P1", p) + opencv_yaml("P2", p),
          "P0: 7 0 6 0 0 7 3 0 0 0 1 0\nP1: 7 0 6 -3 0 7 3 0 0 0 1 0\n",
          "cam0=[99 0 16; 0 99 12; 0 0 1]\ncam1=[99 0 17; 0 99 12; 0 0 1]\nbaseline=193.001\n"
          "width=32\nheight=24\n"};
}
