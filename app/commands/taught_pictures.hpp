#pragma once

#include <string>
#include <vector>

#include "striate/memory/long_term/long_term_settings.hpp"
#include "striate/memory/long_term/records.hpp"

namespace striate::app {

/// The pictures that show a thing, as `striate teach` is given them.
struct TaughtPictures {
  std::vector<std::string> images;  ///< files, or folders of them
  std::vector<std::string> crop;    ///< "x,y,w,h": of one picture each, or one of all
  bool whole = false;               ///< they are kept as they are
};

/// What pictures show of a thing.
struct PictureViews {
  std::vector<memory::StoredView> views;
  std::vector<std::string> shares;  ///< how much of each picture, in words, for when it is kept
};

/// A view of the thing from each picture: the part that was said, or the thing where it clearly
/// stands out from its background, or all of it.
/// @throws UserError for a file that cannot be read, or a part that is none
[[nodiscard]] PictureViews views_of_pictures(const TaughtPictures& given,
                                             const memory::LongTermSettings& settings);

}  // namespace striate::app
