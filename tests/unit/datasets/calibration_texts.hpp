#pragma once

#include <fmt/format.h>

#include <opencv2/core/matx.hpp>
#include <string>

/// One pair of cameras as the programs of others write it down.
namespace striate::datasets::written {

inline const cv::Matx33d kLeft(458.5, 0, 320.25, 0, 457.5, 241.5, 0, 0, 1);
inline const cv::Matx33d kRight(460.5, 0, 318.75, 0, 459.5, 239.25, 0, 0, 1);
inline const cv::Vec4d kLensLeft(-0.28, 0.07, 0.0002, -0.0001);
inline const cv::Vec4d kLensRight(-0.27, 0.06, -0.0003, 0.0002);
/// 1 degree about y
inline const cv::Matx33d kTurn(0.99984769515639127, 0, 0.01745240643728351, 0, 1, 0,
                               -0.01745240643728351, 0, 0.99984769515639127);
inline const cv::Vec3d kWay(-0.12, 0.001, 0.0005);  // m

template <int m, int n>
std::string numbers(const cv::Matx<double, m, n>& matrix, const char* between = ", ") {
  std::string text;
  for (int k = 0; k < m * n; ++k) text += (k > 0 ? between : "") + fmt::format("{}", matrix.val[k]);
  return text;
}

template <int m, int n>
std::string opencv_yaml(const std::string& name, const cv::Matx<double, m, n>& matrix) {
  return fmt::format("{}: !!opencv-matrix\n   rows: {}\n   cols: {}\n   dt: d\n   data: [ {} ]\n",
                     name, m, n, numbers(matrix));
}

template <int m, int n>
std::string opencv_xml(const std::string& name, const cv::Matx<double, m, n>& matrix) {
  return fmt::format(
      "<{0} type_id=\"opencv-matrix\">\n  <rows>{1}</rows>\n  <cols>{2}</cols>\n  <dt>d</dt>\n  "
      "<data>\n    {3}</data></{0}>\n",
      name, m, n, numbers(matrix, " "));
}

/// OpenCV's samples: intrinsics.yml and extrinsics.yml in one, with the names that are asked for.
inline std::string opencv(const std::string& k1, const std::string& d1, const std::string& k2,
                          const std::string& d2) {
  return "%YAML:1.0\n---\nimage_width: 640\nimage_height: 480\n" + opencv_yaml(k1, kLeft) +
         opencv_yaml(d1, kLensLeft) + opencv_yaml(k2, kRight) + opencv_yaml(d2, kLensRight) +
         opencv_yaml("R", kTurn) + opencv_yaml("T", kWay);
}

inline std::string opencv_as_xml() {
  return "<?xml version=\"1.0\"?>\n<opencv_storage>\n<!-- by hand -->\n<image_size>\n  640 "
         "480</image_size>\n" +
         opencv_xml("cameraMatrix1", kLeft) + opencv_xml("distCoeffs1", kLensLeft) +
         opencv_xml("cameraMatrix2", kRight) + opencv_xml("distCoeffs2", kLensRight) +
         opencv_xml("R", kTurn) + opencv_xml("T", kWay) + "</opencv_storage>\n";
}

inline std::string json() {
  return fmt::format(
      "{{\"left\": {{\"K\": [[{}],[{}],[{}]], \"dist\": [{}]}}, \"right\": {{\"K\": [{}], "
      "\"dist\": [{}]}},\n \"R\": [{}], \"T\": [[{}], [{}], [{}]], \"image_size\": [640, 480]}}\n",
      numbers(kLeft.row(0)), numbers(kLeft.row(1)), numbers(kLeft.row(2)), numbers(kLensLeft),
      numbers(kRight), numbers(kLensRight), numbers(kTurn), kWay[0], kWay[1], kWay[2]);
}

inline cv::Matx44d motion(const cv::Matx33d& r, const cv::Vec3d& t) {
  return {r(0, 0), r(0, 1), r(0, 2), t[0], r(1, 0), r(1, 1), r(1, 2), t[1],
          r(2, 0), r(2, 1), r(2, 2), t[2], 0,       0,       0,       1};
}

inline std::string four(const cv::Matx33d& k) {
  return fmt::format("[{}, {}, {}, {}]", k(0, 0), k(1, 1), k(0, 2), k(1, 2));
}

inline std::string kalibr() {
  const cv::Matx44d t = motion(kTurn, kWay);
  return fmt::format(
      "cam0:\n  cam_overlaps: [1]\n  camera_model: pinhole\n  distortion_coeffs: [{}]\n  "
      "distortion_model: radtan\n  intrinsics: {}\n  resolution: [640, 480]\n  rostopic: "
      "/cam0/image_raw\ncam1:\n  T_cn_cnm1:\n  - [{}]\n  - [{}]\n  - [{}]\n  - [{}]\n  "
      "cam_overlaps: [0]\n  camera_model: pinhole\n  distortion_coeffs: [{}]\n  distortion_model: "
      "radtan\n  intrinsics: {}\n  resolution: [640, 480]\n  rostopic: /cam1/image_raw\n",
      numbers(kLensLeft), four(kLeft), numbers(t.row(0)), numbers(t.row(1)), numbers(t.row(2)),
      numbers(t.row(3)), numbers(kLensRight), four(kRight));
}

inline std::string euroc(const cv::Matx33d& k, const cv::Vec4d& lens, const cv::Matx44d& t_bs) {
  return fmt::format(
      "# General sensor definitions.\nsensor_type: camera\ncomment: VI-Sensor cam0 (MT9M034)\n"
      "T_BS:\n  cols: 4\n  rows: 4\n  data: [{}]\nrate_hz: 20\nresolution: [640, 480]\n"
      "camera_model: pinhole\nintrinsics: {} #fu, fv, cu, cv\ndistortion_model: "
      "radial-tangential\ndistortion_coefficients: [{}]\n",
      numbers(t_bs), four(k), numbers(lens));
}

/// A file of ROS's camera_calibration; `p` with the baseline for the right eye.
inline std::string camera_info(const cv::Matx33d& k, const cv::Vec4d& lens, const cv::Matx33d& r,
                               const cv::Matx34d& p) {
  return fmt::format(
      "image_width: 640\nimage_height: 480\ncamera_name: narrow_stereo/left\ncamera_matrix:\n  "
      "rows: 3\n  cols: 3\n  data: [{}]\ndistortion_model: plumb_bob\ndistortion_coefficients:\n  "
      "rows: 1\n  cols: 5\n  data: [{}, 0]\nrectification_matrix:\n  rows: 3\n  cols: 3\n  data: "
      "[{}]\nprojection_matrix:\n  rows: 3\n  cols: 4\n  data: [{}]\n",
      numbers(k), numbers(lens), numbers(r), numbers(p));
}

/// The same as `rostopic echo -n 1` prints it.
inline std::string camera_info_message(const cv::Matx33d& k, const cv::Vec4d& lens,
                                       const cv::Matx33d& r, const cv::Matx34d& p) {
  return fmt::format(
      "header: \n  seq: 12\n  stamp: \n    secs: 1403\n    nsecs: 5\n  frame_id: \"left\"\nheight: "
      "480\nwidth: 640\ndistortion_model: \"plumb_bob\"\nD: [{}, 0.0]\nK: [{}]\nR: [{}]\nP: "
      "[{}]\nbinning_x: 0\nbinning_y: 0\nroi: \n  x_offset: 0\n  do_rectify: False\n---\n",
      numbers(lens), numbers(k), numbers(r), numbers(p));
}

inline std::string boofcv() {
  const cv::Matx33d back = kTurn.t();
  const cv::Vec3d way = -(back * kWay);
  const auto eye = [](const char* name, const cv::Matx33d& k, const cv::Vec4d& lens) {
    return fmt::format(
        "  <{0}>\n    <cx>{1}</cx>\n    <cy>{2}</cy>\n    <flipY>false</flipY>\n    <fx>{3}</fx>\n "
        "   <fy>{4}</fy>\n    <height>480</height>\n    <radial>\n      <double>{5}</double>\n     "
        " <double>{6}</double>\n    </radial>\n    <skew>0.0</skew>\n    <t1>{7}</t1>\n    "
        "<t2>{8}</t2>\n    <width>640</width>\n  </{0}>\n",
        name, k(0, 2), k(1, 2), k(0, 0), k(1, 1), lens[0], lens[1], lens[2], lens[3]);
  };
  std::string data;
  for (const double value : back.val) data += fmt::format("        <double>{}</double>\n", value);
  return "<boofcv.struct.calib.StereoParameters>\n" + eye("left", kLeft, kLensLeft) +
         eye("right", kRight, kLensRight) + "  <rightToLeft>\n    <R>\n      <data>\n" + data +
         "      </data>\n      <numCols>3</numCols>\n      <numRows>3</numRows>\n    </R>\n    "
         "<T>\n" +
         fmt::format("      <x>{}</x>\n      <y>{}</y>\n      <z>{}</z>\n", way[0], way[1],
                     way[2]) +
         "    </T>\n  </rightToLeft>\n</boofcv.struct.calib.StereoParameters>";
}

}  // namespace striate::datasets::written
