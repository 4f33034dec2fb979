#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "striate/base/files.hpp"
#include "tests/scenarios/striate_here.hpp"

namespace striate::scenarios {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(WorldCommand, DescribesAWorld) {
  const Ended ended = striate_here({"world", "config/worlds/hard_narrow.yaml"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.out, AllOf(HasSubstr("24 m long, 2.4 m wide"), HasSubstr("2 narrowings"),
                               HasSubstr("narrowest passage"), HasSubstr("2 box"),
                               HasSubstr("lamps from 0.4 to 0.9")));
}

TEST(WorldCommand, TellsMistakesWithTheirPlacesAndAClosedWay) {
  const ScratchFolder folder;
  write_file(folder / "bad.yaml",
             "striate_world: 1\nname: bad\ncorridor: {length: 20 m}\n"
             "obstacles: [{kind: tabel, at: [9 m, 0 m]}]\n");
  const Ended bad = striate_here({"world", folder / "bad.yaml"});
  EXPECT_EQ(bad.exit_code, 2);
  EXPECT_THAT(bad.err, HasSubstr("bad.yaml:4:20: error: 'tabel' is not known as 'kind'"));
  write_file(folder / "closed.yaml",
             "striate_world: 1\nname: closed\ncorridor: {length: 20 m, width: 2 m}\n"
             "obstacles: [{kind: box, at: [9 m, 0 m], size: [1 m, 1.9 m, 1 m]}]\n");
  const Ended closed = striate_here({"world", folder / "closed.yaml"});
  EXPECT_EQ(closed.exit_code, 2);
  EXPECT_THAT(closed.err, HasSubstr("does not get from start to goal"));
  EXPECT_THAT(closed.err, HasSubstr("0.05 m wide where it is narrowest"));
}

TEST(WorldCommand, DrawsTheSameBuildingFromTheSameSeedAndWritesMany) {
  const ScratchFolder folder;
  const Ended once = striate_here({"world", "--random", "--seed", "7", "--kind", "hospital"});
  EXPECT_EQ(once.exit_code, 0) << once.err;
  EXPECT_THAT(once.out, HasSubstr("name: 'hospital_0007'"));
  EXPECT_EQ(striate_here({"world", "--random", "--seed", "7", "--kind", "hospital"}).out, once.out);
  const Ended many =
      striate_here({"world", "--random", "--seed", "7", "--count", "5", "--out", folder / "w"});
  EXPECT_EQ(many.exit_code, 0) << many.err;
  std::size_t files = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder / "w")) {
    const Ended described = striate_here({"world", file.path().string()});
    EXPECT_EQ(described.exit_code, 0) << described.err;
    EXPECT_THAT(described.err, IsEmpty()) << "a drawn way is wide enough";
    ++files;
  }
  EXPECT_EQ(files, 5U);
}

TEST(WorldCommand, SaysWhatItWantsWhenItIsGivenNothing) {
  const Ended nothing = striate_here({"world"});
  EXPECT_EQ(nothing.exit_code, 2);
  EXPECT_THAT(nothing.err, HasSubstr("name a world to describe, or say --random"));
  EXPECT_EQ(striate_here({"world", "corridor_a", "--random"}).exit_code, 2);
  EXPECT_EQ(striate_here({"world", "--random", "--kind", "castle"}).exit_code, 2);
  EXPECT_EQ(striate_here({"world", "--random", "--count", "3"}).exit_code, 2);
}

}  // namespace
}  // namespace striate::scenarios
