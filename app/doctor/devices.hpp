#pragma once

#include <filesystem>

#include "striate/app/doctor/finding.hpp"
#include "striate/platform/pioneer/pioneer_settings.hpp"

namespace striate::app {

/// Where the system shows its devices; tests bring folders of their own.
struct DeviceFolders {
  std::filesystem::path dev = "/dev";
  std::filesystem::path sys = "/sys";
};

/// Serial ports and cameras that the machine has, and whether this user may open them.
[[nodiscard]] Findings look_at_devices(const DeviceFolders& folders);

/// The places that a robot file names: does the device answer there that shall?
[[nodiscard]] Findings look_at_places(const pioneer::PioneerSettings& settings);

}  // namespace striate::app
