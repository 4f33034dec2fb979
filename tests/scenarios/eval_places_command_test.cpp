#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "tests/reference/rendered_room.hpp"
#include "tests/reference/temporary_folder.hpp"
#include "tests/scenarios/striate_process.hpp"

namespace striate::scenarios {
namespace {

using testing::HasSubstr;

constexpr int kPlacesARound = 6;

/// Two rounds through a room, the second a little to the side and in other light, and one image of
/// what was never seen before. Labels beside it.
std::string write_two_rounds(const TemporaryFolder& folder) {
  const std::string sequence = folder / "rounds";
  std::filesystem::create_directories(sequence);
  std::ofstream labels(folder / "labels.csv");
  labels << "image,place\n";
  reference::RenderedRoom room;
  for (int k = 0; k <= 2 * kPlacesARound; ++k) {
    const bool again = k >= kPlacesARound, elsewhere = k == 2 * kPlacesARound;
    room.light = again ? 0.8 : 1.0;
    const cv::Vec3d place_m(again ? 0.1 : 0.0, 0.0, 1.5 * (k % kPlacesARound) - 3.0);
    const std::string name = fmt::format("{:02}.png", k);
    cv::imwrite(sequence + "/" + name,
                room.see(reference::room_pose(place_m, {0.0, elsewhere ? 3.1 : 0.0, 0.0}),
                         {320, 240}, k + 1)
                    .left);
    labels << name << "," << (elsewhere ? "" : std::to_string(k % kPlacesARound)) << "\n";
  }
  return sequence;
}

TEST(EvalPlacesCommand, FindsTheSecondRoundAndNothingElseBesideBagsOfWords) {
  const TemporaryFolder folder;
  const std::string sequence = write_two_rounds(folder);
  const std::vector<std::string> words = {
      "eval",    "places", sequence,       "--truth",     folder / "labels.csv",
      "--apart", "6",      "--neighbours", "0",           "--within-places",
      "0",       "--json", "--out",        folder / "out"};
  const Ended ended = striate(words);
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const nlohmann::json runs = nlohmann::json::parse(ended.out);
  ASSERT_EQ(runs.size(), 4U);
  EXPECT_EQ(runs[0]["method"], "Striate");
  EXPECT_EQ(runs[2]["method"], "ORB words");
  for (const nlohmann::json& run : runs) {
    EXPECT_EQ(run["asked"], 7);
    EXPECT_EQ(run["revisits"], kPlacesARound);
  }
  EXPECT_EQ(runs[0]["own_threshold"]["claimed"], kPlacesARound);
  EXPECT_EQ(runs[0]["own_threshold"]["right"], kPlacesARound);
  EXPECT_EQ(runs[0]["without_false"]["recall"], 1.0);
  EXPECT_EQ(runs[0]["guesses"][0]["image"], "06.png");
  EXPECT_EQ(runs[0]["guesses"][0]["place"], "00.png");
  for (const char* file : {"places.csv", "places_guesses.csv", "places_curves.csv", "places.svg"}) {
    EXPECT_TRUE(std::filesystem::exists(folder / "out" + "/" + file)) << file;
  }
  EXPECT_EQ(nlohmann::json::parse(striate(words).out)[0]["guesses"], runs[0]["guesses"]);
}

TEST(EvalPlacesCommand, WithoutATruthTellsWhatWouldBeClaimed) {
  const TemporaryFolder folder;
  const Ended ended = striate({"eval", "places", write_two_rounds(folder), "--apart", "6",
                               "--neighbours", "0", "--out", folder / "out"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("no ground truth was found: --truth FILE"));
  EXPECT_THAT(ended.out, HasSubstr("7 images asked, no truth"));
  EXPECT_FALSE(std::filesystem::exists(folder / "out/places_curves.csv"));
}

TEST(EvalPlacesCommand, SaysWhatIsWrongWithTruthAndSequence) {
  const TemporaryFolder folder;
  const std::string sequence = write_two_rounds(folder);
  const Ended missing = striate(
      {"eval", "places", sequence, "--truth", folder / "nowhere.csv", "--out", folder / "out"});
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_THAT(missing.err, HasSubstr("nowhere.csv"));
  const Ended too_short = striate({"eval", "places", sequence, "--out", folder / "out"});
  EXPECT_EQ(too_short.exit_code, 2);
  EXPECT_THAT(too_short.err, HasSubstr("13 images, of which none is 30 after another"));
  EXPECT_THAT(too_short.err, HasSubstr("--apart N"));
  std::ofstream(folder / "labels.csv") << "image,place\n00.png,here\n";
  const Ended label = striate({"eval", "places", sequence, "--apart", "6", "--truth",
                               folder / "labels.csv", "--out", folder / "out"});
  EXPECT_EQ(label.exit_code, 2);
  EXPECT_THAT(label.err, HasSubstr("labels.csv:2: \"here\" is no number"));
}

}  // namespace
}  // namespace striate::scenarios
