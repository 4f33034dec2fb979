#pragma once

#include <cstdlib>

#include "striate/evaluation/stereo_pairs.hpp"
#include "striate/evaluation/stereo_score.hpp"
#include "tests/reference/painted_rooms.hpp"
#include "tests/reference/temporary_folder.hpp"

/// Stereo pairs with true disparities, for tests; read as `striate eval stereo` reads them.
namespace striate::reference {

using striate::evaluation::judge;
using striate::evaluation::StereoPair;
using striate::evaluation::StereoScore;

/// The public data: what the environment says, else what the build was told.
inline std::string shared_data(const std::string& built_with) {
  const char* folder = std::getenv("STRIATE_SHARED_DATA");
  return folder != nullptr ? folder : built_with;
}

/// All pairs with ground truth below `folder`; empty where there are none.
inline std::vector<evaluation::StereoPair> load_stereo_pairs(const std::filesystem::path& folder,
                                                             cv::Size size) {
  std::vector<evaluation::StereoPair> pairs;
  if (!std::filesystem::is_directory(folder)) return pairs;
  for (const evaluation::StereoFolder& one : evaluation::find_stereo_folders(folder).pairs) {
    pairs.push_back(evaluation::read_stereo_pair(one, size));
  }
  return pairs;
}

/// Painted rooms, one for each seed from 1 on; at hand everywhere.
inline std::vector<evaluation::StereoPair> painted_stereo_pairs(int count, cv::Size size) {
  const TemporaryFolder folder;
  for (int seed = 1; seed <= count; ++seed) {
    const std::string room = folder / ("room " + std::to_string(seed));
    std::filesystem::create_directory(room);
    write_pair(PaintedRoom(static_cast<std::uint64_t>(seed)).paint(), room);
  }
  return load_stereo_pairs(folder.path(), size);
}

}  // namespace striate::reference
