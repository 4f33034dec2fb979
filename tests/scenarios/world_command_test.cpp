#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <opencv2/imgcodecs.hpp>

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

/// A room of 8 m x 4 m with a wall across, in cells of 10 cm, as map_server writes it.
std::string write_map(const TemporaryFolder& folder, const std::string& header) {
  cv::Mat1b picture(40, 80, std::uint8_t{254});
  picture.rowRange(0, 1).setTo(0);
  picture.rowRange(39, 40).setTo(0);
  picture.colRange(0, 1).setTo(0);
  picture.colRange(79, 80).setTo(0);
  picture(cv::Rect(40, 0, 2, 25)).setTo(0);  // from the top, where y is greatest
  cv::imwrite(folder / "room.pgm", picture);
  return folder.write("room.yaml", header);
}

TEST(WorldCommand, BuildsTheWallsOfAMapThatOthersHaveMade) {
  const TemporaryFolder folder;
  const std::string map = write_map(folder,
                                    "image: room.pgm\nresolution: 0.1\norigin: [-3.0, -2.0, 0.0]\n"
                                    "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
  const std::string world = folder / "world.yaml";
  const Ended built = striate_here({"world", "--from-map", map, "--out", world});
  EXPECT_EQ(built.exit_code, 0) << built.err;
  const Ended described = striate_here({"world", world});
  EXPECT_EQ(described.exit_code, 0) << described.err;
  EXPECT_THAT(described.out, HasSubstr("narrowest passage  1.40 m, 4.3 m along"));
  EXPECT_THAT(read_text(world), HasSubstr("# Made of the map room.yaml"));
  const Ended there = striate_here({"world", "--from-map", map, "--at", "-2 m, 0.5 m, 90 deg"});
  EXPECT_THAT(there.out, HasSubstr("start: {at: [1.3 m, 0.5 m], heading: 90 deg}"));
  const Ended in_the_wall = striate_here({"world", "--from-map", map, "--at", "1.1 m, 1 m"});
  EXPECT_EQ(in_the_wall.exit_code, 2);
  EXPECT_THAT(in_the_wall.err, HasSubstr("a Pioneer needs to start"));
}

TEST(WorldCommand, TellsWhatIsWrongWithAMapAtItsPlace) {
  const TemporaryFolder folder;
  const auto told = [&](const std::string& header) {
    const Ended ended = striate_here({"world", "--from-map", write_map(folder, header)});
    EXPECT_EQ(ended.exit_code, 2);
    return ended.err;
  };
  EXPECT_THAT(told("image: room.pgm\n"), HasSubstr("'resolution' is missing"));
  EXPECT_THAT(told("image: room.pgm\nresolution: 40\n"), HasSubstr("room.yaml:2:13: error"));
  EXPECT_THAT(told("image: room.pgm\nresolution: 0.1\norigin: [0, 0, 1.57]\n"),
              HasSubstr("the map is turned by 1.57 rad"));
  EXPECT_THAT(told("image: none.pgm\nresolution: 0.1\n"), HasSubstr("none.pgm"));
  EXPECT_THAT(told("image: room.pgm\nresolution: 0.1\nnegate: 1\n"),
              HasSubstr("has a Pioneer room to start"));
}

TEST(WorldCommand, SaysWhatItWantsWhenItIsGivenNothing) {
  const Ended nothing = striate_here({"world"});
  EXPECT_EQ(nothing.exit_code, 2);
  EXPECT_THAT(nothing.err, HasSubstr("name a world to describe, say --random"));
  EXPECT_EQ(striate_here({"world", "corridor_a", "--random"}).exit_code, 2);
  EXPECT_EQ(striate_here({"world", "--random", "--kind", "castle"}).exit_code, 2);
  EXPECT_EQ(striate_here({"world", "--random", "--count", "3"}).exit_code, 2);
}

}  // namespace
}  // namespace striate::scenarios
