#pragma once

#include <filesystem>
#include <string>

#include "striate/app/doctor/finding.hpp"
#include "striate/platform/pioneer/who_answers.hpp"

/// One line to a device, looked at.
namespace striate::app {

/// May this person read and write it; where not, of which group he has to be.
[[nodiscard]] Finding permission(const std::filesystem::path& device, const char* kind,
                                 const char* group);

/// How long a USB adapter holds bytes back, where the kernel tells.
void look_at_latency(const std::filesystem::path& port, const std::filesystem::path& sys,
                     Findings& findings);

/// Opens the line and asks who is there.
/// @param servos of the turret; none where another device is expected
[[nodiscard]] Finding look_at_line(const std::string& name, const std::string& url,
                                   pioneer::Answerer expected,
                                   const pioneer::ServoIds& servos = {});

}  // namespace striate::app
