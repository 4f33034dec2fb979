#include "striate/evaluation/calibration/board_images.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "striate/base/user_error.hpp"
#include "tests/reference/temporary_folder.hpp"

namespace striate::evaluation {
namespace {

void touch(const std::filesystem::path& file) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file) << "x";
}

std::string board_images_error(const std::string& folder) {
  try {
    (void)find_board_images(folder, false);
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

TEST(BoardImages, ArePairedByNameWhateverTheSuffixAndWhoHasNoPartnerIsNamed) {
  const reference::TemporaryFolder folder;
  EXPECT_THAT(board_images_error(folder.path()), testing::HasSubstr("left: No such file"));
  for (const char* name : {"left/a.PNG", "right/a.PNG", "left/b.JPG", "right/b.jpeg", "left/c.Tiff",
                           "right/c.tif", "left/d.png", "right/e.pgm", "left/notes.txt"}) {
    touch(folder / name);
  }
  const BoardFolder found = find_board_images(folder.path(), false);
  std::vector<std::string> names;
  for (const BoardFiles& look : found.looks) {
    names.push_back(look.name);
    EXPECT_EQ(look.left.stem(), look.right.stem());
  }
  EXPECT_THAT(names, testing::ElementsAre("a.PNG", "b.JPG", "c.Tiff"));
  EXPECT_THAT(found.unpaired, testing::ElementsAre("left/d.png", "right/e.pgm"));
  EXPECT_EQ(find_board_images(folder / "left", true).looks.size(), 4U);
  touch(folder / "left/a.jpg");
  EXPECT_THAT(board_images_error(folder.path()), testing::HasSubstr("is there beside"));
}

TEST(BoardImages, FoldersWithoutAPairSayWhatIsThere) {
  const reference::TemporaryFolder folder;
  touch(folder / "left/1.png");
  touch(folder / "right/2.png");
  EXPECT_THAT(board_images_error(folder.path()),
              testing::AllOf(testing::HasSubstr("left/1.png"), testing::HasSubstr("right/2.png")));
}

}  // namespace
}  // namespace striate::evaluation
