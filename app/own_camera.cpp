#include "striate/app/own_camera.hpp"

#include <fmt/format.h>

#include "striate/base/say.hpp"

namespace striate::app {

void OwnCamera::look(StereoFrame& frame, PerceiveOptions& options) const {
  rectifier_.rectify(cv::Mat3b(frame.left), cv::Mat3b(frame.right), frame);
  options.centre_u_px = frame.centre_u_px;
  options.centre_v_px = frame.centre_v_px;
  options.right_centre_u_px.reset();
  options.doffs_px = rectifier_.doffs_px();
  const bool metric = !frame.right.empty() && frame.baseline_m > 0.0;
  options.focal_px = metric ? frame.focal_px : 0.0;
  options.baseline_m = metric ? frame.baseline_m : 0.0;
  if (!metric) {  // nothing is measured then, and the picture's middle is as good
    options.centre_u_px.reset();
    options.centre_v_px.reset();
    options.camera_height_m.reset();
  }
}

void tell_camera(const datasets::StereoModel& model, const datasets::PictureRectifier& to) {
  const char* pictures =
      to.changes_pictures() ? "pictures are rectified" : "pictures stay as they are";
  std::string lens = to.baseline_m() > 0.0 ? fmt::format("f {:.2f} px, eyes {:.4g} m apart",
                                                         to.focal_px(), to.baseline_m())
                                           : fmt::format("f {:.2f} px", to.focal_px());
  say(stderr, fmt::format("calibration: {}; {}; {}\n", model.format, pictures, lens));
  for (const std::string& remark : model.remarks) say(stderr, "  note: " + remark + "\n");
  for (const std::string& remark : to.remarks()) say(stderr, "  note: " + remark + "\n");
}

}  // namespace striate::app
