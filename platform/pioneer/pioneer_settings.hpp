#pragma once

#include <string>

#include "striate/platform/pioneer/base_driver_settings.hpp"
#include "striate/platform/pioneer/camera/stereo_camera_settings.hpp"
#include "striate/platform/pioneer/laser/laser_settings.hpp"
#include "striate/platform/pioneer/turret/turret_driver.hpp"

namespace striate::pioneer {

/// Where the devices of a robot are; empty: it has none.
struct DevicePlaces {
  std::string base;
  std::string turret;
  std::string laser;
  std::string camera;
};

template <class V>
void visit(V& v, DevicePlaces& s) {
  v.text("base", s.base, "tcp://host:8101, serial:/dev/ttyUSB0?baud=38400 or pty:/dev/pts/3");
  v.text("turret", s.turret, "two AX-12A on a Dynamixel bus; the same kinds of place");
  v.text("laser", s.laser, "on a line of its own; the same kinds of place");
  v.text("camera", s.camera,
         "tcp://host:8104 (an image stream), video:/dev/video0 (both eyes side by side), "
         "video:/dev/video0,/dev/video2, video:FILE or bumblebee:");
}

/// Everything that can be set about a real Pioneer and its devices.
struct PioneerSettings {
  DevicePlaces devices;
  BaseDriverSettings base;
  TurretSettings turret;
  LaserSettings laser;
  StereoCameraSettings camera;
};

template <class V>
void visit(V& v, PioneerSettings& s) {
  v.section("devices", s.devices);
  visit(v, s.base);
  v.section("turret", s.turret);
  v.section("laser", s.laser);
  v.section("camera", s.camera);
}

}  // namespace striate::pioneer
