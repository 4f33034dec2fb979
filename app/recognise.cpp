#include "striate/app/recognise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "striate/agent/landmark_knowledge.hpp"
#include "striate/app/own_camera.hpp"
#include "striate/app/perceive_frame.hpp"
#include "striate/app/perceive_sequence.hpp"
#include "striate/app/recognised_picture.hpp"
#include "striate/app/recognised_thing.hpp"
#include "striate/base/files.hpp"
#include "striate/base/plain_text.hpp"
#include "striate/base/user_error.hpp"

namespace striate::app {
namespace {

using nlohmann::ordered_json;

constexpr int kRangeWidth_px =
    320;  // px: stereo's finer working width; small things need it (ours)

class RecogniseRun {
 public:
  RecogniseRun(const RecogniseOptions& options, agent::KnownThings& things)
      : options_(options), things_(things) {
    for (const std::string& name : things.names()) seen_in_[name] = 0;
  }

  void look(const datasets::Sequence& sequence, const datasets::SequenceLook& look) {
    StereoFrame frame;
    frame.left = look.left;
    frame.right = look.right;
    PerceiveOptions stereo = camera_for(sequence, frame);
    std::vector<PlacedThing> placed;
    for (const agent::KnownThing& thing : things_.find(frame.left)) {
      placed.push_back({thing, {}, {}});
      ++seen_in_[thing.name];
    }
    if (!placed.empty() && !frame.right.empty() && stereo.focal_px > 0.0) {
      place_camera(stereo, look.name, frame);
      const JudgedFrame judged = judge_frame(stereo, frame);
      for (PlacedThing& one : placed) {
        add_range(judged.percept.disparity, frame.left.size(), one);
      }
    }
    ++pictures_;
    with_something_ += placed.empty() ? 0 : 1;
    tell(look, placed);
    if (options_.out.empty()) return;
    write_picture(options_.out / fmt::format("recognised_{:06}.png", look.number),
                  draw_recognised(frame.left, placed));
  }

  void tell_all() const {
    if (options_.json) {
      ordered_json counts = ordered_json::object();
      for (const auto& [name, count] : seen_in_) counts[name] = count;
      fmt::print(
          "{}\n",
          ordered_json{
              {"summary",
               {{"pictures", pictures_}, {"with_something", with_something_}, {"seen_in", counts}}}}
              .dump());
      return;
    }
    std::string never;
    for (const auto& [name, count] : seen_in_) {
      if (count == 0) never += (never.empty() ? "" : ", ") + plain_text(name);
    }
    fmt::print("{} picture{}, something known in {}\n", pictures_, pictures_ == 1 ? "" : "s",
               with_something_);
    if (!never.empty()) fmt::print("not seen: {}\n", never);
  }
  [[nodiscard]] bool found_something() const { return with_something_ > 0; }

 private:
  PerceiveOptions camera_for(const datasets::Sequence& sequence, StereoFrame& frame) {
    PerceiveOptions stereo;
    stereo.width_px = kRangeWidth_px;
    stereo.focal_px = options_.focal_px;
    stereo.baseline_m = options_.baseline_m;
    if (!sequence.calibration() || stereo.focal_px > 0.0) return stereo;
    if (!camera_) {
      camera_.emplace(*sequence.calibration(), frame.left.size(), options_.rectified);
      tell_camera(*sequence.calibration(), camera_->rectifier());
    }
    camera_->look(frame, stereo);
    return stereo;
  }
  void tell(const datasets::SequenceLook& look, const std::vector<PlacedThing>& placed) const {
    if (options_.json) {
      ordered_json json = {{"frame", look.number}, {"name", look.name}};
      json["time_ns"] = look.stamp_ns ? ordered_json(*look.stamp_ns) : ordered_json(nullptr);
      json["things"] = ordered_json::array();
      for (const PlacedThing& one : placed) json["things"].push_back(thing_json(one));
      fmt::print("{}\n", json.dump());
      return;
    }
    fmt::print("{}: {}\n", plain_text(look.name), placed.empty() ? "nothing known" : "");
    for (const PlacedThing& one : placed) fmt::print("{}", thing_text(one));
  }

  const RecogniseOptions& options_;
  agent::KnownThings& things_;
  std::optional<OwnCamera> camera_;
  std::map<std::string, std::size_t> seen_in_;
  std::size_t pictures_ = 0;
  std::size_t with_something_ = 0;
};

memory::LandmarkKnowledge knowledge_of(const std::string& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) {
    throw UserError(
        fmt::format("{}: there is no such memory\n    hint: striate teach NAME --image PICTURE "
                    "--memory {} makes one",
                    file, file));
  }
  memory::LandmarkKnowledge knowledge = agent::read_landmark_knowledge(file);
  const bool any = std::ranges::any_of(
      knowledge.landmarks, [](const memory::LandmarkModel& model) { return !model.views.empty(); });
  if (any) return knowledge;
  throw UserError(
      fmt::format("{}: this memory knows no landmark by a view, so that nothing can be recognised"
                  "\n    hint: striate teach NAME --image PICTURE --memory {}",
                  file, file));
}

}  // namespace

int recognise(const RecogniseOptions& options) {
  if ((options.focal_px > 0.0) != (options.baseline_m > 0.0)) {
    throw UserError("distances need both --focal-px and --baseline-m: give both or neither");
  }
  agent::KnownThings things(knowledge_of(options.memory), options.settings, options.only);
  if (!options.out.empty()) make_folder(options.out, "--out");
  const auto sequence = datasets::open_sequence(options.source, options.sequence);
  tell_sequence(*sequence);
  const std::size_t told = sequence->remarks().size();
  RecogniseRun run(options, things);
  datasets::SequenceLook look;
  bool stopped = false;
  while (!(stopped = options.stopped && options.stopped()) && sequence->next(look)) {
    run.look(*sequence, look);
  }
  tell_left_out(*sequence, told);
  run.tell_all();
  if (stopped) return 130;
  return run.found_something() ? 0 : 1;
}

}  // namespace striate::app
