#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace striate::evaluation {

/// The two files of one look at the board; one file where it shows both eyes.
struct BoardFiles {
  std::string name;
  std::filesystem::path left;
  std::filesystem::path right;  ///< empty: `left` shows both eyes side by side
};

struct BoardFolder {
  std::vector<BoardFiles> looks;      ///< by name
  std::vector<std::string> unpaired;  ///< "left/07.png": there is no right/07
};

/// The pictures below FOLDER/left and FOLDER/right that belong together by their names, whatever
/// their suffixes and the case of these; of one folder with both eyes all pictures in it.
/// @throws UserError where there is no folder, no picture in it, or none that has a partner; it
/// says what is there.
[[nodiscard]] BoardFolder find_board_images(const std::filesystem::path& folder, bool side_by_side);

}  // namespace striate::evaluation
