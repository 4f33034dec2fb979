#include "striate/app/commands/run_mission.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <thread>
#include <utility>

#include "striate/agent/given_variables.hpp"
#include "striate/agent/landmark_knowledge.hpp"
#include "striate/agent/mission_memory.hpp"
#include "striate/agent/mission_pictures.hpp"
#include "striate/agent/recall/live_memory.hpp"
#include "striate/agent/recording/mission_recorder.hpp"
#include "striate/app/commands/run_report.hpp"
#include "striate/app/interrupt.hpp"
#include "striate/app/late_opencv.hpp"
#include "striate/app/operator_reset.hpp"
#include "striate/app/pace.hpp"
#include "striate/app/pair_watch.hpp"
#include "striate/app/reports.hpp"
#include "striate/app/status_line.hpp"
#include "striate/app/view/task_pages.hpp"
#include "striate/base/files.hpp"
#include "striate/base/files_apart.hpp"
#include "striate/base/say.hpp"
#include "striate/viewer/dashboard/memory_pages.hpp"
#include "striate/viewer/foxglove/mission_foxglove.hpp"
#include "striate/viewer/recording/mission_mcap.hpp"

namespace striate::app {
namespace {

agent::MissionOptions mission_options(const RunOptions& options) {
  agent::MissionOptions mission = options.mission;
  mission.given = agent::read_variables(options.given);
  mission.emergency_layer = !options.no_emergency;
  if (!options.memory.empty()) mission.knowledge = agent::read_mission_knowledge(options.memory);
  return mission;
}

/// What may fail without the mission noticing, as it is called in the message.
constexpr const char* kRecording = "the recording";
constexpr const char* kMcap = "the MCAP file";
constexpr const char* kFoxglove = "the server for viewers";
constexpr const char* kInspection = "the view of short-term memory";
constexpr const char* kPictures = "the pictures";
constexpr const char* kMemory = "the long-term memory";
constexpr const char* kOnlooker = "the onlooker";
constexpr const char* kPair = "the look at the eyes";
constexpr const char* kStatus = "the status line";
constexpr const char* kResult = "the result";

/// What is written down of a mission and shown of it. Made before it, since files copy the memory
/// as it is then; viewers may drive it to its end.
struct MissionFiles {
  explicit MissionFiles(const RunOptions& options)
      : recorder(options.record, options.memory),
        mcap(options.mcap.file, compression_of(options.mcap), options.memory) {}
  agent::MissionRecorder recorder;
  viewer::MissionMcap mcap;
  viewer::MissionFoxglove foxglove;
};

/// How much of it was kept, for the summary; "" without a file.
struct Kept {
  std::string recording;
  std::string mcap;
};

/// All who watch a mission from outside.
class Watchers {
 public:
  Watchers(const RunOptions& options, agent::Mission& mission, MissionFiles& files)
      : options_(options),
        mission_(mission),
        files_(files),
        pictures_(options.pictures, options.picture_every),
        memory_(options.memory, mission, options.mission.task),
        live_(options.inspect),
        status_(options.quiet || options.json) {
    files_.recorder.begin(mission);
    files_.mcap.begin(mission);
    show_to_foxglove();
  }

  /// After each cycle, before anything ends the task from outside.
  void take() noexcept {
    reports_.attempt(kRecording, [this] { files_.recorder.take(mission_); });
    reports_.attempt(kMcap, [this] { files_.mcap.take(mission_); });
    reports_.attempt(kFoxglove, [this] { files_.foxglove.take(mission_); });
    reports_.attempt(kInspection, [this] {
      live_.take(mission_.cycle(), mission_.executive(), mission_.cycles());
    });
    reports_.attempt(kPictures, [this] { pictures_.take(mission_); });
    reports_.attempt(kMemory, [this] { memory_.take(mission_); });
    reports_.attempt(kOnlooker, [this] {
      if (options_.each_cycle) options_.each_cycle(mission_);
    });
    reports_.attempt(kPair, [this] {
      pair_.take(mission_.cycle().trace().senses.stereo);
      if (const std::string wrong = pair_.news(); !wrong.empty()) status_.tell(wrong);
    });
    let_go_on();
    reports_.attempt(kStatus, [this] {
      if (const std::string said = speech_.news(mission_); !said.empty()) status_.tell(said);
      if (status_.due()) status_.show(status_text(mission_, status_.columns()));
    });
  }

  /// A robot that holds until it is reset waits for a person, who is told once. Not a report: it
  /// works where nothing can be written any more.
  void let_go_on() noexcept {
    const bool asked = reset_.asked();
    const bool waits = mission_.waits_for_reset();
    if (waits && !told_to_wait_) {
      reports_.attempt(kStatus, [this] {
        status_.tell(fmt::format("the robot stands until you let it go on ({}): {}",
                                 mission_.hold(), OperatorReset::hint()));
      });
    }
    told_to_wait_ = waits;
    if (!waits || !asked) return;
    mission_.reset_body();
    reports_.attempt(kStatus, [this] { status_.tell("the robot goes on"); });
  }

  /// The mission is over. @return what was kept of it, for the summary
  Kept finish(const agent::RunResult& result) noexcept {
    status_.clear();
    reports_.finish(kPair, [this] {
      if (const std::string wrong = pair_.finish(); !wrong.empty()) status_.tell(wrong);
    });
    Kept kept;
    finish_file(
        kRecording, [this] { return files_.recorder.finish(); }, kept.recording);
    finish_file(
        kMcap, [this] { return files_.mcap.finish(); }, kept.mcap);
    reports_.finish(kFoxglove, [this] { files_.foxglove.finish(); });
    reports_.finish(kInspection, [&] { reports_.note(kInspection, live_.finish().c_str()); });
    reports_.finish(kMemory,
                    [&] { reports_.note(kMemory, memory_.finish(mission_, result).c_str()); });
    reports_.finish(kPictures, [&] { pictures_.finish(mission_, result); });
    return kept;
  }

  [[nodiscard]] Reports& reports() { return reports_; }
  /// What could not be written, said once. @return whether nothing was lost
  [[nodiscard]] bool tell_losses() {
    const bool told = say(stderr, reports_.text());
    return told && !reports_.any_failed() && !status_.failed();
  }

 private:
  /// The address is told in any case: without it nobody finds a free port, or knows the token.
  void show_to_foxglove() {
    if (!options_.foxglove.wanted()) return;
    viewer::foxglove::ServerOptions server = options_.foxglove.for_server();
    add_pages(server);
    files_.foxglove.begin(server, mission_);
    say(stderr, options_.foxglove.addresses(files_.foxglove.url(), files_.foxglove.page_url()));
  }

  /// What the dashboard shows beside the robot: its memory, and its task as it was written.
  void add_pages(viewer::foxglove::ServerOptions& server) {
    if (!server.site) return;
    if (!options_.memory.empty()) {
      viewer::dashboard::add_memory_pages(
          *server.site, {options_.memory, mission_.settings().long_term_memory, false});
      server.pages.emplace_back("memory");
    }
    add_task_pages(*server.site, options_.mission.task);
    server.pages.emplace_back("task");
  }

  template <class Finish>
  void finish_file(const char* what, Finish finish, std::string& kept) noexcept {
    reports_.finish(what, [&] {
      agent::RecordingEnd end = finish();
      kept = std::move(end.kept);
      if (end.failed) return reports_.note(what, end.lost.c_str());
      if (!end.lost.empty()) say(stderr, end.lost + "\n");
    });
  }

  const RunOptions& options_;
  agent::Mission& mission_;
  MissionFiles& files_;
  agent::MissionPictures pictures_;
  agent::MissionMemory memory_;
  agent::LiveMemory live_;
  PairWatch pair_;
  StatusLine status_;
  Speech speech_;
  OperatorReset reset_;
  bool told_to_wait_ = false;
  Reports reports_;
};

/// Ctrl-C ends the mission safely, and so does a viewer; twice, without its `finally`.
bool asked_to_end(agent::Mission& mission, const MissionFiles& files) {
  if (Interrupt::insisted()) mission.abandon();
  return Interrupt::requested() || files.foxglove.stop_asked();
}

std::string report_text(const RunOptions& options, const agent::RunResult& result,
                        const std::string& json, const Kept& kept) {
  if (options.json) return json;
  if (options.quiet) return {};
  std::string text = summary_text(result);
  if (!options.result.empty()) text += fmt::format("  record            {}\n", options.result);
  if (!options.pictures.empty()) text += fmt::format("  images            {}\n", options.pictures);
  if (!kept.recording.empty()) text += fmt::format("  recording         {}\n", kept.recording);
  if (!kept.mcap.empty()) text += fmt::format("  MCAP file         {}\n", kept.mcap);
  return text;
}

}  // namespace

void check_outputs(const RunOptions& options) {
  check_apart({{"--memory", options.memory},
               {"--record", options.record},
               {"--mcap", options.mcap.file},
               {"--result", options.result},
               {"--inspect", options.inspect}},
              {{"the task script", options.mission.task},
               {"--robot", options.mission.robot},
               {"--world", options.world}});
  for (const std::string& file :
       {options.result, options.record, options.mcap.file, options.inspect, options.memory}) {
    check_writable(file);
  }
  make_folder(options.pictures);
}

int run_mission(const RunOptions& options, const agent::BodySource& body) {
  check_outputs(options);
  const agent::MissionOptions asked = mission_options(options);
  const Interrupt interrupt;
  MissionFiles files(options);
  agent::Mission mission(asked, body);
  if (mission.simulated() == nullptr || options.real_time) load_opencv_codecs();
  if (!options.quiet) say(stderr, mission.notices());
  Watchers watchers(options, mission, files);
  if (options.at_begin) options.at_begin(mission);
  Pace pace(options.real_time ? 1.0 : 0.0);
  const agent::RunResult result = mission.run([&](const agent::Mission&) {
    watchers.take();
    std::this_thread::sleep_until(
        pace.due(mission.cycle().trace().senses.now, Pace::Steady::now()));
    return asked_to_end(mission, files);
  });
  // First what others wait for: all the rest may take its time, or fail.
  std::string json;
  watchers.reports().finish(kResult, [&] {
    json = agent::to_json(result).dump(2) + "\n";
    if (!options.result.empty()) write_file(options.result, json);
  });
  const Kept kept = watchers.finish(result);
  say(stdout, report_text(options, result, json, kept));  // main() tells whether it was taken
  const bool all_kept = watchers.tell_losses();
  const int exit_code = agent::row_of(result.outcome).exit_code;
  return exit_code == 0 && !all_kept ? 1 : exit_code;
}

}  // namespace striate::app
