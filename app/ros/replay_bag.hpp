#pragma once

#include <string>

namespace striate {

/// What `striate ros replay` is asked for.
struct ReplayBagOptions {
  std::string bag;
  std::string robot;      ///< settings; the section `ros` names topics
  std::string out;        ///< folder for percepts.jsonl and pictures; empty: none
  int picture_every = 0;  ///< an overview picture every so many picture pairs; 0: none
};

/// Lets the whole cycle look at a bag's pictures, without a ROS master; its commands go nowhere.
/// percepts.jsonl has one line a picture pair. @returns 0
/// @throws UserError for a bag without usable stereo pictures.
int replay_bag(const ReplayBagOptions& options);

}  // namespace striate
