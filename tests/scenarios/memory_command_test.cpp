#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "tests/scenarios/taught_memory.hpp"

namespace striate::scenarios {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

void execute(const std::string& file, const std::string& sql) {
  SQLite::Database(file, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE).exec(sql);
}

TEST(Teach, FromImagesAndAFolderThenLookedInto) {
  const TemporaryFolder folder;
  const std::string file = folder / "home.db";
  teach(file, "book", image_of_a_thing(folder, 1));
  std::filesystem::create_directory(folder / "cup");
  for (const int seed : {2, 3}) {
    const std::string image = image_of_a_thing(folder, seed);
    std::filesystem::rename(image, (folder / "cup") + "/" + std::to_string(seed) + ".png");
  }
  const Ended cup = striate_here({"teach", "cup", "--image", folder / "cup", "--memory", file});
  EXPECT_EQ(cup.exit_code, 0) << cup.err;
  EXPECT_THAT(cup.out, AllOf(HasSubstr("cup: new, 2 views added"), Not(HasSubstr("looks like"))));

  const nlohmann::json list = memory_json(file, {"list"});
  ASSERT_EQ(list.size(), 2U);
  EXPECT_THAT(memory(file, {"list"}).out, AllOf(HasSubstr("book"), HasSubstr("taught")));
  EXPECT_THAT(memory(file, {"why", "book"}).out,
              AllOf(HasSubstr("'book' has activation"), HasSubstr("a person taught it")));
  EXPECT_EQ(memory_json(file, {"why", "book", "--goal", "book"}).at("goal"), 2.0);
  const std::string robot = folder.write("robot.yaml", "long_term_memory: {goal_spread: 3}\n");
  EXPECT_EQ(memory_json(file, {"why", "book", "--goal", "book", "--robot", robot}).at("goal"), 3.0);
  EXPECT_EQ(memory_json(file, {"show", "cup"}).at("looks").size(), 2U);
  const std::string image = folder / "cup.png";
  EXPECT_THAT(memory(file, {"show", "cup", "--picture", image}).out, HasSubstr("320 px"));
  EXPECT_FALSE(cv::imread(image).empty());
  EXPECT_THAT(memory(file, {"episodes"}).out, HasSubstr("taught"));
  EXPECT_EQ(memory_json(file, {"episodes", "--most", "1"}).size(), 1U);
  EXPECT_THAT(memory(file, {"check"}).out, HasSubstr("good: 2 landmarks, 3 views"));
  EXPECT_EQ(memory(file, {"show", "bok"}).exit_code, 2);
}

TEST(Teach, SaysWhatLooksAlikeAndWhatHasNoStructureAndCanBeUndone) {
  const TemporaryFolder folder;
  const std::string file = folder / "home.db";
  const std::string image = image_of_a_thing(folder, 1);
  teach(file, "book", image);
  const Ended again = striate_here({"teach", "cover", "--image", image, "--memory", file});
  EXPECT_THAT(again.out, HasSubstr("looks like 'book'"));
  EXPECT_EQ(striate_here({"teach", "--undo", "--memory", file}).exit_code, 0);
  EXPECT_EQ(memory_json(file, {"list"}).size(), 1U);
  EXPECT_EQ(striate_here({"teach", "book", "--undo", "--memory", file}).exit_code, 2);
  EXPECT_EQ(memory_json(file, {"list"}).size(), 1U);

  const std::string wall = folder / "wall.png";
  cv::imwrite(wall, cv::Mat3b(200, 200, cv::Vec3b(180, 180, 180)));
  const Ended bare = striate_here({"teach", "wall", "--image", wall, "--memory", file});
  EXPECT_EQ(bare.exit_code, 2);
  EXPECT_THAT(bare.err, HasSubstr("too little structure"));
  EXPECT_EQ(memory_json(file, {"list"}).size(), 1U);
  EXPECT_EQ(
      striate_here({"teach", "x", "--image", folder / "none.png", "--memory", file}).exit_code, 2);
  EXPECT_EQ(striate_here({"teach", "x", "--memory", file}).exit_code, 2);
}

TEST(MemoryCommand, TablesFitTheTerminal) {
  const TemporaryFolder folder;
  const std::string file = folder / "home.db";
  teach(file, "a thing with quite a long name that goes on", image_of_a_thing(folder, 1));
  for (const char* width : {"40", "80", "200"}) {
    setenv("COLUMNS", width, 1);
    std::stringstream lines(memory(file, {"list"}).out + memory(file, {"episodes"}).out);
    std::string line;
    while (std::getline(lines, line)) {
      const auto letters = std::count_if(
          line.begin(), line.end(), [](unsigned char letter) { return (letter & 0xC0) != 0x80; });
      EXPECT_LE(letters, std::atoi(width)) << line;
    }
  }
  unsetenv("COLUMNS");
}

TEST(MemoryCommand, AMemoryIsAFileThatKeepsWhatItIsGiven) {
  const TemporaryFolder folder;
  const std::string image = image_of_a_thing(folder, 1);
  const std::string pipe = folder / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string& nowhere :
       {std::string(), std::string(":memory:"), std::string("file:x?mode=memory"), pipe,
        std::string("/dev/null"), folder / ""}) {
    for (const auto& words :
         {std::vector<std::string>{"teach", "book", "--image", image, "--memory"},
          {"run", "config/tasks/corridor.yaml", "--world", "config/worlds/empty.yaml", "--quiet",
           "--memory"},
          {"trial", "--worlds", "config/worlds/empty.yaml", "--runs", "1", "--out", folder / "out",
           "--memory"}}) {
      std::vector<std::string> all = words;
      all.push_back(nowhere);
      const Ended ended = striate_here(all);
      EXPECT_EQ(ended.exit_code, 2) << words[0] << " '" << nowhere << "': " << ended.out;
      EXPECT_EQ(ended.out, "") << words[0] << " '" << nowhere << "'";
    }
    const Ended listed = striate_here({"memory", nowhere, "list"});
    EXPECT_EQ(listed.exit_code, 2) << nowhere;
  }
}

TEST(MemoryCommand, RenameKeepsAllThatIsKnown) {
  const TemporaryFolder folder;
  const std::string file = folder / "home.db";
  teach(file, "book", image_of_a_thing(folder, 1));
  teach(file, "cup", image_of_a_thing(folder, 2));
  EXPECT_THAT(memory(file, {"rename", "book", "red book"}).out, HasSubstr("red book: renamed"));
  const nlohmann::json list = memory_json(file, {"list"});
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(list[1].at("name"), "red book");
  EXPECT_EQ(list[1].at("views"), 1);
  EXPECT_THAT(memory(file, {"episodes"}).out, testing::Not(HasSubstr("taught    book")));
  EXPECT_EQ(memory(file, {"rename", "book", "x"}).exit_code, 2);
  EXPECT_THAT(memory(file, {"rename", "red book", "cup"}).err, HasSubstr("known already"));
  EXPECT_EQ(memory(file, {"rename", "cup", "x\x1b[2J"}).exit_code, 2);
}

TEST(MemoryCommand, NamesFromElsewhereAreShownAsPlainTextAndExportApart) {
  const TemporaryFolder folder;
  const std::string file = folder / "home.db";
  const char* raw[] = {"a\xfe", "a\xff", "\x1b[2Jx", "y\xe2\x80\xae", "z\xc2\x9b"};
  for (int k = 0; k < 5; ++k) {
    teach(file, "thing " + std::to_string(k), image_of_a_thing(folder, k));
  }
  {
    SQLite::Database database(file, SQLite::OPEN_READWRITE);
    for (int k = 0; k < 5; ++k) {
      SQLite::Statement rename(database, "UPDATE landmark SET name = ? WHERE name = ?");
      rename.bind(1, std::string(raw[k]));
      rename.bind(2, "thing " + std::to_string(k));
      rename.exec();
    }
  }
  const std::string out = memory(file, {"list"}).out + memory(file, {"list", "--json"}).out;
  for (const char* part : {"\xfe", "\xff", "\x1b", "\xe2\x80\xae", "\xc2\x9b"}) {
    EXPECT_EQ(out.find(part), std::string::npos) << part;
  }
  EXPECT_THAT(out, HasSubstr("a\\xFE"));
  const std::string exported = folder / "all.json";
  ASSERT_EQ(memory(file, {"export", exported}).exit_code, 0);
  const std::string copy = folder / "copy.db";
  const Ended imported = memory(copy, {"import", exported});
  ASSERT_EQ(imported.exit_code, 0) << imported.err;
  EXPECT_EQ(memory_json(copy, {"list"}).size(), 5U);
  EXPECT_EQ(memory(file, {"rename", "a\\xFE", "first"}).exit_code, 0);
  EXPECT_EQ(memory(file, {"forget", "first"}).exit_code, 0);
}

TEST(MemoryCommand, ForgetRestoreAndPrune) {
  const TemporaryFolder folder;
  const std::string file = folder / "home.db";
  teach(file, "book", image_of_a_thing(folder, 1));
  EXPECT_EQ(memory(file, {"forget", "book"}).exit_code, 0);
  EXPECT_EQ(memory_json(file, {"list"}).size(), 0U);
  EXPECT_EQ(memory_json(file, {"list", "--all"}).size(), 1U);
  EXPECT_THAT(memory(file, {"why", "book"}).out, HasSubstr("it is forgotten: a person asked"));
  EXPECT_EQ(memory(file, {"forget", "book"}).exit_code, 2);
  EXPECT_EQ(memory(file, {"restore", "book"}).exit_code, 0);
  EXPECT_EQ(memory_json(file, {"list"})[0].at("pinned"), true);
  EXPECT_THAT(memory(file, {"prune"}).out, HasSubstr("nothing to prune"));
  EXPECT_EQ(memory_json(file, {"prune", "--yes"}).at("done"), true);
}

TEST(MemoryCommand, ExportAndImportRoundTripAndMergeJoins) {
  const TemporaryFolder folder;
  const std::string file = folder / "home.db";
  const std::string copy = folder / "copy.db";
  const std::string text = folder / "home.json";
  teach(file, "book", image_of_a_thing(folder, 1));
  teach(file, "grüne Tasse", image_of_a_thing(folder, 2));
  EXPECT_EQ(memory(file, {"export", text}).exit_code, 0);
  EXPECT_THAT(memory(copy, {"import", text}).out, HasSubstr("2 landmarks added"));
  EXPECT_EQ(memory_json(file, {"diff", file, copy}).size(), 0U);
  EXPECT_THAT(memory(file, {"diff", file, copy}).out, HasSubstr("both know the same"));

  const std::string other = folder / "other.db";
  teach(other, "book", image_of_a_thing(folder, 3));
  teach(other, "cover", image_of_a_thing(folder, 1));
  const nlohmann::json merged = memory_json(copy, {"merge", other});
  EXPECT_EQ(merged.at("joined"), 2);
  EXPECT_EQ(memory_json(copy, {"show", "book"}).at("views"), 2);
  EXPECT_EQ(memory_json(file, {"diff", file, copy}).size(), 1U);
  EXPECT_EQ(memory(copy, {"merge", copy}).exit_code, 2);
  const std::string wrong = folder.write("wrong.json", "{\"a\": 1}");
  EXPECT_THAT(memory(copy, {"import", wrong}).err, HasSubstr("no export of a memory"));
}

TEST(MemoryCommand, ExportWritesOverNoMemory) {
  const TemporaryFolder folder;
  const std::string file = folder / "home.db";
  const std::string other = folder / "other.db";
  const std::string link = folder / "link.json";
  teach(file, "book", image_of_a_thing(folder, 1));
  execute(other, "CREATE TABLE t (x)");
  std::filesystem::create_symlink(file, link);
  for (const std::string& out : {file, link, other}) {
    const std::string before = read_text(out);
    const Ended ended = memory(file, {"export", out});
    EXPECT_EQ(ended.exit_code, 2) << out;
    EXPECT_THAT(ended.err, HasSubstr("it is not written over"));
    EXPECT_EQ(read_text(out), before);
  }
  const std::string text = folder.write("home.json", "an older export");
  EXPECT_EQ(memory(file, {"export", text}).exit_code, 0);
  EXPECT_EQ(memory_json(file, {"list"}).size(), 1U);
  // A name that nobody could type is not taken in.
  std::string json = read_text(text);
  const std::string name = "\"name\": \"book\"";
  json.replace(json.find(name), name.size(), "\"name\": \"bo\\nk\"");
  EXPECT_THAT(memory(file, {"import", folder.write("bad.json", json)}).err,
              HasSubstr("is no name for a landmark"));
}

TEST(MemoryCommand, DrawsTheMapOfTheGoldenMemory) {
  const TemporaryFolder folder;
  const std::string file = folder / "home.db";
  execute(file, read_text(std::string(STRIATE_SOURCE_DIR "/tests/golden/memory_v1.sql")));
  EXPECT_THAT(memory(file, {"map"}).out,
              AllOf(HasSubstr("12.50 m"), HasSubstr("3.50 m"), HasSubstr("1 cells of 10 cm")));
  EXPECT_EQ(memory_json(file, {"map"}).at("routes").size(), 1U);
  const std::string image = folder / "map.png";
  EXPECT_EQ(memory(file, {"map", "--picture", image}).exit_code, 0);
  const std::string drawing = folder / "map.svg";
  EXPECT_EQ(memory(file, {"map", "--picture", drawing}).exit_code, 0);
  EXPECT_THAT(read_text(drawing),
              AllOf(HasSubstr("<svg"), HasSubstr(">book</text>"), HasSubstr("</svg>")));
  EXPECT_FALSE(cv::imread(image).empty());
  const std::string ros = folder / "home.yaml";
  EXPECT_EQ(memory(file, {"map", "--map-server", ros}).exit_code, 0);
  EXPECT_THAT(read_text(ros), HasSubstr("image: home.pgm\n"));
  EXPECT_EQ(cv::imread(folder / "home.pgm", cv::IMREAD_UNCHANGED).size(), cv::Size(1, 1));
  EXPECT_EQ(memory(file, {"map", "--map-server", folder / "home.pgm"}).exit_code, 2);
  // Nobody's file is hurt by a mistake: a foreign one is refused by every verb that writes.
  const std::string foreign = folder / "other.db";
  execute(foreign, "CREATE TABLE t (x)");
  EXPECT_EQ(memory(foreign, {"list"}).exit_code, 2);
  EXPECT_THAT(striate_here({"teach", "x", "--image", image, "--memory", foreign}).err,
              HasSubstr("not a memory of Striate's"));
}

}  // namespace
}  // namespace striate::scenarios
