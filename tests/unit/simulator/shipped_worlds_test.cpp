#include <gtest/gtest.h>

#include <filesystem>

#include "platform/simulator/world_reader.hpp"

namespace striate::simulator {
namespace {

TEST(ShippedWorlds, LoadWithoutAMistake) {
  int worlds = 0;
  for (const auto& file :
       std::filesystem::directory_iterator(STRIATE_SOURCE_DIR "/config/worlds")) {
    if (file.path().extension() != ".yaml") continue;
    ++worlds;
    config::Mistakes mistakes(file.path().string());
    const World world = read_world(mistakes);
    EXPECT_TRUE(mistakes.none()) << mistakes.text();
    EXPECT_EQ(world.name, file.path().stem().string());
  }
  EXPECT_GE(worlds, 5);
}

}  // namespace
}  // namespace striate::simulator
