#include "striate/agent/map_server_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "striate/base/user_error.hpp"

namespace striate::agent {
namespace {

using testing::HasSubstr;

TEST(MapServerFiles, HoldEveryCellAtItsPlaceWithTheTopRowFirst) {
  const MapServerFiles files = map_server_files(
      {{-2, 5, 3.0, 0.0}, {0, 5, -3.0, 0.0}, {0, 4, 0.2, 0.0}, {1, 6, 6.0, 0.0}}, "home.pgm");
  const std::string header = "P5\n4 3\n255\n";
  ASSERT_EQ(files.pgm.substr(0, header.size()), header);
  const std::string unknown(1, '\xcd'), free(1, '\xfe'), stands(1, '\0');
  EXPECT_EQ(files.pgm.substr(header.size()),
            unknown + unknown + unknown + stands +   // y 0.6 m
                stands + unknown + free + unknown +  // y 0.5 m: x -0.2 m .. 0.1 m
                unknown + unknown + unknown + unknown);
  EXPECT_THAT(files.yaml, HasSubstr("image: home.pgm\n"));
  EXPECT_THAT(files.yaml, HasSubstr("resolution: 0.100\n"));
  EXPECT_THAT(files.yaml, HasSubstr("origin: [-0.200, 0.400, 0.0]\n"));
}

TEST(MapServerFiles, AreRefusedWhereThereIsNoMapOrNoPictureCouldHoldIt) {
  EXPECT_THROW((void)map_server_files({}, "a.pgm"), UserError);
  EXPECT_THROW((void)map_server_files({{0, 0, 1.0, 0.0}, {2000000000, 0, 1.0, 0.0}}, "a.pgm"),
               UserError);
  EXPECT_THROW(
      (void)map_server_files({{-2000000000, 0, 1.0, 0.0}, {2000000000, 0, 1.0, 0.0}}, "a.pgm"),
      UserError);
}

}  // namespace
}  // namespace striate::agent
