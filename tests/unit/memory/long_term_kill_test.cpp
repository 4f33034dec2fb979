// kill -9 at random moments: nothing torn, nothing lost that was acknowledged, the next start says
// what happened and goes on. STRIATE_KILLS=300 kills that often; without it 30 times.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <thread>

#include "striate/memory/long_term/damage.hpp"
#include "striate/memory/long_term/teaching.hpp"
#include "tests/unit/memory/long_term_fixtures.hpp"

namespace striate::memory::memory_tests {
namespace {

using testing::IsEmpty;

int kills() {
  const char* given = std::getenv("STRIATE_KILLS");
  return given == nullptr ? 30 : std::max(3, std::atoi(given));
}

/// Runs `work` in a child and kills it after this time. Each line of what it acknowledged is an
/// int.
template <class Work>
std::vector<int> acknowledged_until_killed(std::chrono::microseconds after, Work work) {
  std::array<int, 2> pipe_ends{};
  EXPECT_EQ(pipe(pipe_ends.data()), 0);
  const pid_t child = fork();
  if (child == 0) {
    close(pipe_ends[0]);
    try {
      work([&](int what) { return write(pipe_ends[1], &what, sizeof(what)) == sizeof(what); });
    } catch (const std::exception&) {
      _exit(3);
    }
    _exit(0);
  }
  close(pipe_ends[1]);
  std::this_thread::sleep_for(after);
  kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_FALSE(WIFEXITED(status) && WEXITSTATUS(status) == 3) << "the child failed by itself";
  std::vector<int> acknowledged;
  int what = 0;
  while (read(pipe_ends[0], &what, sizeof(what)) == sizeof(what)) acknowledged.push_back(what);
  close(pipe_ends[0]);
  return acknowledged;
}

std::chrono::microseconds moment(std::mt19937& random, int most_ms) {
  return std::chrono::microseconds(random() % (1000U * static_cast<unsigned>(most_ms)));
}

TEST(KillNine, LosesNoAcknowledgedLandmarkWhileTeachingAndDriving) {
  const Folder folder;
  const std::string file = folder / "home.db";
  std::mt19937 random(7);
  std::vector<int> all;
  std::size_t acknowledged = 0;
  int crashed = 0;
  int next = 0;
  for (int k = 0; k < (2 * kills() + 2) / 3; ++k) {
    if (k % 10 == 0) {  // some of the kills hit a memory that is being made
      std::filesystem::remove(file);
      std::filesystem::remove(file + "-wal");
      std::filesystem::remove(file + "-shm");
      all.clear();
    }
    const std::vector<int> kept =
        acknowledged_until_killed(moment(random, 120), [&](auto acknowledge) {
          MemoryWriter writer(file, options(Access::session));
          Session session;
          writer.commit([&](MemoryTables& tables) {
            session = tables.sessions.begin(SessionKind::mission, "s", "", 1);
          });
          for (int at = next;; ++at) {
            for (int e = 0; e < 5; ++e) {
              writer.post([&session, e](MemoryTables& tables) {
                Episode episode;
                episode.session = session.id;
                episode.kind = "near miss";
                episode.text = std::to_string(e);
                tables.sessions.add(episode);
                tables.sessions.note_time(session.id, e);
              });
            }
            writer.commit([&](MemoryTables& tables) {
              StoredView view = scattered_view(static_cast<unsigned>(at), 60);
              view.image.assign(40000, static_cast<std::uint8_t>(at));
              Landmark landmark;
              landmark.session = session.id;
              landmark.name = std::to_string(at);
              view.landmark = tables.landmarks.add(landmark);
              view.session = session.id;
              tables.views.add(view);
            });
            if (!acknowledge(at)) return;
          }
        });
    all.insert(all.end(), kept.begin(), kept.end());
    acknowledged += kept.size();
    Opened memory(file, Access::session);
    ASSERT_THAT(find_damage(memory.file.database()), IsEmpty()) << "kill " << k;
    for (const int at : all) {
      const std::optional<Landmark> landmark = memory.tables.landmarks.find(std::to_string(at));
      ASSERT_TRUE(landmark.has_value()) << "kill " << k << " lost landmark " << at;
      ASSERT_EQ(landmark->views, 1);
    }
    // What was not acknowledged is there whole or not at all: both are fine.
    for (const Landmark& landmark : memory.tables.landmarks.all(true)) {
      ASSERT_EQ(landmark.keypoints, 60);
      next = std::max(next, std::stoi(landmark.name) + 1);
    }
    if (!memory.file.notices().empty()) ++crashed;
  }
  std::printf("%zu landmarks acknowledged, %d starts after a crash\n", acknowledged, crashed);
  EXPECT_GT(crashed, 0);
  EXPECT_GT(acknowledged, 0U);
}

TEST(KillNine, AMigrationIsDoneOrNotBegun) {
  const schema::Step step = {2,
                             "ALTER TABLE landmark ADD COLUMN colour TEXT NOT NULL DEFAULT 'red';"
                             "UPDATE landmark_view SET range_m = 2.0"};
  MemoryOptions next_version = options(Access::session);
  next_version.version = 2;
  next_version.steps = {&step, 1};
  const Folder folder;
  {
    Opened memory(folder / "golden.db", Access::session);
    for (unsigned k = 0; k < 40; ++k) add_landmark(memory.tables, std::to_string(k), k, 150);
  }
  // Kills are spread over twice as long as it takes when nobody disturbs it.
  std::filesystem::copy_file(folder / "golden.db", folder / "timed.db");
  const auto begin = std::chrono::steady_clock::now();
  Opened(folder / "timed.db", next_version);
  const auto taken = std::chrono::duration_cast<std::chrono::milliseconds>(
      std::chrono::steady_clock::now() - begin);
  const int most_ms = std::max(10, static_cast<int>(taken.count() * 2));
  std::mt19937 random(11);
  std::array<int, 3> found{};
  for (int k = 0; k < (kills() + 2) / 3; ++k) {
    const std::string file = folder / ("run" + std::to_string(k) + ".db");
    std::filesystem::copy_file(folder / "golden.db", file);
    (void)acknowledged_until_killed(moment(random, most_ms),
                                    [&](auto) { Opened(file, next_version); });
    const bool has_backup = std::filesystem::exists(file + ".v1.backup");
    if (has_backup) {
      Opened backup(file + ".v1.backup", Access::read);
      ASSERT_EQ(backup.tables.landmarks.all(true).size(), 40U);
      ASSERT_THAT(find_damage(backup.file.database()), IsEmpty());
    }
    {
      SQLite::Database database(file, SQLite::OPEN_READWRITE);
      const int version = database.execAndGet("PRAGMA user_version").getInt();
      ASSERT_TRUE(version == 1 || (version == 2 && has_backup));
      ++found[static_cast<std::size_t>(version)];
    }
    Opened memory(file, next_version);
    ASSERT_EQ(memory.tables.landmarks.all(true).size(), 40U);
    ASSERT_THAT(find_damage(memory.file.database()), IsEmpty());
  }
  std::printf("version 1 after %d kills, version 2 after %d\n", found[1], found[2]);
}

}  // namespace
}  // namespace striate::memory::memory_tests
