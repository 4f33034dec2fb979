#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "striate/viewer/mcap/mcap_reader.hpp"
#include "tests/scenarios/striate_process.hpp"

/// A mission as an MCAP file: while it runs, and from its recording. What other people's code makes
/// of these files is tested in tests/browser.
namespace striate::scenarios {
namespace {

using testing::HasSubstr;
using viewer::mcap::Ending;
using viewer::mcap::Message;
using viewer::mcap::Reader;
namespace fs = std::filesystem;

std::vector<std::string> short_mission(const std::vector<std::string>& with) {
  std::vector<std::string> words{"run",     "config/tasks/corridor.yaml",
                                 "--world", "config/worlds/short.yaml",
                                 "--seed",  "3",
                                 "--var",   "way=2 m",
                                 "--quiet"};
  words.insert(words.end(), with.begin(), with.end());
  return words;
}

/// The messages of each topic, in their order.
std::map<std::string, std::vector<Bytes>> messages_of(const std::string& file, Ending ending) {
  std::map<std::string, std::vector<Bytes>> topics;
  Reader reader(file);
  Message message;
  while (reader.next(message)) {
    topics[reader.channel_of(message).topic].emplace_back(message.data.begin(), message.data.end());
  }
  EXPECT_EQ(reader.ending(), ending);
  return topics;
}

/// A result without what the clock on the wall says.
nlohmann::json result_in(const std::string& file) {
  nlohmann::json json = nlohmann::json::parse(read_text(file), nullptr, false);
  json.erase("mean_cycle_ms");
  json.erase("realtime_factor");
  return json;
}

class McapMission : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    ended_ = striate(short_mission(
        {"--mcap", file("run.mcap"), "--record", file("run.rec"), "--result", file("with.json")}));
  }
  static void TearDownTestSuite() { folder_.reset(); }
  static std::string file(const std::string& name) { return *folder_ / name; }

  static std::unique_ptr<TemporaryFolder> folder_;
  static Ended ended_;
};

std::unique_ptr<TemporaryFolder> McapMission::folder_;
Ended McapMission::ended_;

TEST_F(McapMission, IsTheSameBitForBitAsWithoutTheFile) {
  ASSERT_EQ(ended_.exit_code, 0) << ended_.err;
  const Ended without =
      striate(short_mission({"--record", file("without.rec"), "--result", file("without.json")}));
  ASSERT_EQ(without.exit_code, 0) << without.err;
  EXPECT_EQ(result_in(file("with.json")), result_in(file("without.json")));
  EXPECT_TRUE(read_text(file("run.rec")) == read_text(file("without.rec")));
}

TEST_F(McapMission, IsExportedFromItsRecordingMessageByMessage) {
  const Ended exported =
      striate({"export", file("run.rec"), "--mcap", file("again.mcap"), "--compression", "lz4"});
  ASSERT_EQ(exported.exit_code, 0) << exported.err;
  EXPECT_THAT(exported.out, HasSubstr("again.mcap: "));
  auto live = messages_of(file("run.mcap"), Ending::closed);
  auto again = messages_of(file("again.mcap"), Ending::closed);
  EXPECT_GT(live["/striate/cycle"].size(), 30U);
  EXPECT_GT(live.size(), 20U);
  for (auto& [topic, messages] : live) EXPECT_TRUE(messages == again[topic]) << topic;
  EXPECT_EQ(live.size(), again.size());
}

TEST_F(McapMission, OfARecordingThatIsCutOffHasWhatTheRecordingHas) {
  const std::string cut = file("cut.rec");
  fs::copy_file(file("run.rec"), cut);
  fs::resize_file(cut, fs::file_size(cut) / 2);
  const Ended exported = striate({"export", cut, "--mcap", file("cut.mcap")});
  EXPECT_EQ(exported.exit_code, 0) << exported.err;
  EXPECT_THAT(exported.out, HasSubstr("the recording is cut off"));
  auto topics = messages_of(file("cut.mcap"), Ending::closed);
  EXPECT_GT(topics["/odom"].size(), 10U);
}

TEST_F(McapMission, OfARecordingThatIsDamagedEndsBeforeTheDamage) {
  std::string bytes = read_text(file("run.rec"));
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  const TemporaryFolder folder;
  const std::string damaged = folder.write("damaged.rec", bytes);
  const Ended exported = striate({"export", damaged, "--mcap", folder / "out.mcap"});
  EXPECT_EQ(exported.exit_code, 2);
  EXPECT_THAT(exported.err, HasSubstr("damaged.rec: is damaged at byte "));
  EXPECT_GT(messages_of(folder / "out.mcap", Ending::closed)["/odom"].size(), 10U);
}

TEST_F(McapMission, IsNotExportedOntoItsRecordingOrAFullDisk) {
  const std::uintmax_t size = fs::file_size(file("run.rec"));
  const Ended onto = striate({"export", file("run.rec"), "--mcap", file("run.rec")});
  EXPECT_EQ(onto.exit_code, 2);
  EXPECT_THAT(onto.err, HasSubstr("is the recording itself"));
  EXPECT_EQ(fs::file_size(file("run.rec")), size);
  EXPECT_EQ(striate({"export", file("run.rec"), "--mcap", "/dev/full"}).exit_code, 2);

  const Ended full = bash("cd \"" STRIATE_SOURCE_DIR "\"; ulimit -f 2000; \"$striate\" export " +
                          file("run.rec") + " --mcap " + file("full.mcap"));
  EXPECT_EQ(full.exit_code, 1);
  EXPECT_THAT(full.err, HasSubstr("full.mcap: cannot be written: File too large; it ends after "));
  EXPECT_GT(messages_of(file("full.mcap"), Ending::cut_off)["/odom"].size(), 1U);
}

TEST(Mcap, OfAMissionThatIsKilledIsReadUpToItsLastChunk) {
  const TemporaryFolder folder;
  const std::string file = folder / "run.mcap";
  const pid_t child = fork();
  if (child == 0) {
    if (chdir(STRIATE_SOURCE_DIR) != 0) _exit(99);
    execl(STRIATE_BINARY, STRIATE_BINARY, "run", "config/tasks/corridor.yaml", "--world",
          "config/worlds/short.yaml", "--quiet", "--mcap", file.c_str(), nullptr);
    _exit(98);
  }
  std::error_code none;
  // Several chunks of a megabyte; the mission makes some sixty.
  for (int k = 0; k < 1000 && (!fs::exists(file) || fs::file_size(file, none) < 5'000'000); ++k) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  EXPECT_GT(messages_of(file, Ending::cut_off)["/odom"].size(), 10U);
}

TEST(Mcap, ThatCannotBeWrittenIsToldBeforeAnythingMoves) {
  const Ended ended = striate(short_mission({"--mcap", "/dev/full"}));
  EXPECT_EQ(ended.exit_code, 2);
  EXPECT_THAT(ended.err, HasSubstr("/dev/full: cannot be written"));
  const Ended word = striate(short_mission({"--mcap", "a.mcap", "--compression", "zip"}));
  EXPECT_EQ(word.exit_code, 2);
  EXPECT_EQ(striate(short_mission({"--compression", "lz4"})).exit_code, 2);
  EXPECT_EQ(striate({"export", "README.md", "--mcap", "/tmp"}).exit_code, 2);
}

}  // namespace
}  // namespace striate::scenarios
