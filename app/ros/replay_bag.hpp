#pragma once

#include <string>

namespace striate::app {

/// What `striate ros replay` is asked for.
struct ReplayBagOptions {
  std::string bag;
  std::string robot;      ///< settings; the section `ros` names topics
  std::string camera;     ///< what its topics begin with, where the bag has several stereo cameras
  std::string out;        ///< folder for percepts.jsonl and images; empty: none
  int picture_every = 0;  ///< an overview image every so many image pairs; 0: none
};

/// Lets the whole cycle look at a bag's images, without a ROS master; its commands go nowhere.
/// percepts.jsonl has one line an image pair. @returns 0
/// @throws UserError for a bag without usable stereo images.
int replay_bag(const ReplayBagOptions& options);

}  // namespace striate::app
