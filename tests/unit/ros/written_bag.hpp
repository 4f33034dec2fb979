#pragma once

#include <rosbag/bag.h>

#include <functional>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "striate/platform/ros/messages.hpp"

/// Bags that tests write.
namespace striate::ros {

struct WrittenBag {
  int pairs = 5;
  bool compressed = false;
  bool with_info = true;
  bool append = false;  ///< to a bag that is there
  std::string root = "/stereo";
  std::string image = "/image_rect_color";
  std::function<void(int pair, StereoFrame&)> paint;  ///< over the even grey, where given
};

/// One image pair every 100 ms, the right stamp 3 ms after the left; odometry each 50 ms on
/// /odom, from (2, 1) heading left at 0.3 m/s. Pair `i` has left images of grey level 10 i.
inline void write_bag(const std::string& file, const WrittenBag& given) {
  rosbag::Bag bag(file, given.append ? rosbag::bagmode::Append : rosbag::bagmode::Write);
  const ::ros::Time begin(1700000000, 0);
  StereoFrame frame;
  frame.focal_px = 203.0;
  frame.centre_u_px = 79.5;
  frame.centre_v_px = 59.5;
  frame.baseline_m = 0.12;
  for (int i = 0; i < given.pairs; ++i) {
    const ::ros::Time now = begin + ::ros::Duration(0.1 * i);
    frame.left = cv::Mat3b(120, 160, cv::Vec3b::all(static_cast<std::uint8_t>(10 * i)));
    frame.right = cv::Mat3b(120, 160, cv::Vec3b::all(200));
    if (given.paint) given.paint(i, frame);
    for (const bool right : {false, true}) {
      const std::string eye = given.root + (right ? "/right" : "/left");
      const ::ros::Time stamp = now + ::ros::Duration(right ? 0.003 : 0.0);
      const ::ros::Time arrived = stamp + ::ros::Duration(0.02);
      const cv::Mat3b& image = right ? frame.right : frame.left;
      if (given.compressed) {
        sensor_msgs::CompressedImage message;
        message.header.stamp = stamp;
        message.format = "png";
        cv::imencode(".png", image, message.data);
        bag.write(eye + given.image + "/compressed", arrived, message);
      } else {
        sensor_msgs::Image message;
        message.header.stamp = stamp;
        write(image, message);
        bag.write(eye + given.image, arrived, message);
      }
      if (given.with_info) {
        sensor_msgs::CameraInfo info;
        info.header.stamp = stamp;
        write(frame, right, info);
        bag.write(eye + "/camera_info", arrived, info);
      }
    }
    for (int half = 0; half < 2; ++half) {
      Odometry odometry;
      odometry.pose = {2.0, 1.0 + 0.03 * i + 0.015 * half, kPi / 2.0};
      odometry.forward_m_s = 0.3;
      nav_msgs::Odometry message;
      write(odometry, message);
      message.header.stamp = now + ::ros::Duration(0.05 * half);
      bag.write("/odom", message.header.stamp + ::ros::Duration(0.001), message);
    }
  }
}

}  // namespace striate::ros
