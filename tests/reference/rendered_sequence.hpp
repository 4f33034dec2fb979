#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "tests/reference/rendered_room.hpp"
#include "tests/reference/temporary_folder.hpp"

/// A way through a rendered room as KITTI would have written it down: sequences/00 and
/// poses/00.txt.
namespace striate::reference {

/// Half a metre a second, ten pictures a second, with a slow bend.
inline perception::RigidMotion sequence_pose(int k) {
  const double t_s = 0.1 * k;
  return room_pose({0.1 * std::sin(t_s), 0.0, 0.5 * t_s}, {0.0, 0.2 * std::sin(t_s), 0.0});
}

/// @param dark the first of so many pictures without light; -1: none
/// @return the folder of the sequence
inline std::string write_rendered_sequence(const TemporaryFolder& folder, int views, int dark = -1,
                                           int dark_views = 0) {
  const std::string sequence = folder / "sequences/00";
  std::filesystem::create_directories(sequence + "/image_0");
  std::filesystem::create_directories(sequence + "/image_1");
  std::filesystem::create_directories(folder / "poses");
  std::string times, poses;
  RenderedRoom room;
  perception::StereoEyes eyes;
  for (int k = 0; k < views; ++k) {
    const perception::RigidMotion pose = sequence_pose(k);
    room.light = dark >= 0 && k >= dark && k < dark + dark_views ? 0.0 : 1.0;
    const perception::StereoView view = room.see(pose, {320, 240}, k);
    eyes = view.eyes;
    cv::imwrite(fmt::format("{}/image_0/{:06}.png", sequence, k), view.left);
    cv::imwrite(fmt::format("{}/image_1/{:06}.png", sequence, k), view.right);
    times += fmt::format("{:.6e}\n", 0.1 * k);
    for (int row = 0; row < 3; ++row) {
      poses += fmt::format("{} {} {} {}{}", pose.rotation(row, 0), pose.rotation(row, 1),
                           pose.rotation(row, 2), pose.way_m[row], row < 2 ? " " : "\n");
    }
  }
  const auto projection = [&](const char* name, double column) {
    return fmt::format("{}: {} 0 {} {} 0 {} {} 0 0 0 1 0\n", name, eyes.focal_px, eyes.centre_u_px,
                       column, eyes.focal_px, eyes.centre_v_px);
  };
  (void)folder.write("sequences/00/calib.txt",
                     projection("P0", 0.0) + projection("P1", -eyes.focal_px * eyes.baseline_m));
  (void)folder.write("sequences/00/times.txt", times);
  (void)folder.write("poses/00.txt", poses);
  return sequence;
}

}  // namespace striate::reference
