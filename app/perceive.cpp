#include "striate/app/perceive.hpp"

#include <utility>

#include "striate/app/own_camera.hpp"
#include "striate/app/perceive_frame.hpp"
#include "striate/base/files.hpp"
#include "striate/base/user_error.hpp"
#include "striate/platform/datasets/calibration/read_calibration.hpp"
#include "striate/platform/datasets/images/read_image.hpp"

namespace striate::app {
namespace {

StereoFrame read_pictures(const PerceiveOptions& o) {
  StereoFrame frame;
  if (o.right.empty()) {
    frame.left = datasets::read_any_image(o.left);
    return frame;
  }
  const auto [left, right] = datasets::read_eye_pair(o.left, o.right);
  frame.left = left;
  frame.right = right;
  if (o.exchanged) std::swap(frame.left, frame.right);
  return frame;
}

}  // namespace

JudgedPair perceive(const PerceiveOptions& given) {
  PerceiveOptions options = given;  // what the calibration tells is added
  if (options.left.empty()) throw UserError("perceive needs an image: give it with --left FILE");
  if (options.out.empty()) {
    throw UserError("perceive needs a folder for its results: --out DIR");
  }
  check_perceive(options);
  make_folder(options.out, "--out");
  JudgedPair pair;
  pair.frame = read_pictures(options);
  if (!options.calibration.empty()) {
    const datasets::StereoModel model =
        datasets::read_calibration(options.calibration, options.exchanged);
    if (model.eyes_exchanged && !pair.frame.right.empty()) {
      std::swap(pair.frame.left, pair.frame.right);
    }
    OwnCamera camera(model, pair.frame.left.size(), options.rectified);
    tell_camera(model, camera.rectifier());
    camera.look(pair.frame, options);
  }
  place_camera(options, options.left.string(), pair.frame);
  pair.judged = judge_frame(options, pair.frame);
  warn_of_the_pair(pair.frame, pair.judged.report);
  write_judged(options, pair.frame, pair.judged);
  return pair;
}

}  // namespace striate::app
