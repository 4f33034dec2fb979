#include "striate/app/perceive_sequence.hpp"

#include <fmt/format.h>

#include <optional>

#include "striate/app/frame_summary.hpp"
#include "striate/app/own_camera.hpp"
#include "striate/app/perceive_frame.hpp"
#include "striate/base/files.hpp"
#include "striate/base/say.hpp"
#include "striate/base/user_error.hpp"

namespace striate::app {
namespace {

/// What is kept from frame to frame.
struct SequenceState {
  std::optional<OwnCamera> camera;
  std::optional<std::int64_t> first_ns;
  SequenceSummary summary;
  bool warned = false;
};

StereoFrame frame_of(const datasets::SequenceLook& look) {
  StereoFrame frame;
  frame.left = look.left;
  frame.right = look.right;
  return frame;
}

void see(const PerceiveSequenceOptions& options, const datasets::Sequence& sequence,
         const datasets::SequenceLook& look, SequenceState& state) {
  StereoFrame frame = frame_of(look);
  PerceiveOptions one = options.frame;
  one.left = look.name;
  one.right = look.right.empty() ? "" : look.name;
  if (sequence.calibration() && one.focal_px <= 0.0) {
    if (!state.camera) {
      state.camera.emplace(*sequence.calibration(), look.left.size(), one.rectified);
      tell_camera(*sequence.calibration(), state.camera->rectifier());
    }
    state.camera->look(frame, one);
  }
  if (frame.right.empty()) one.camera_height_m.reset();
  place_camera(one, look.name, frame);
  JudgedFrame judged = judge_frame(one, frame);
  warn_of_the_pair(frame, judged.report, !state.warned);
  state.warned = state.warned || !judged.report.warnings.empty();
  if (!one.out.empty()) {
    write_judged(one, frame, judged, fmt::format("_{:06}", look.number));
  }
  FrameSummary summary = summary_of(judged);
  summary.number = look.number;
  summary.name = look.name;
  if (look.stamp_ns) {
    if (!state.first_ns) state.first_ns = look.stamp_ns;
    summary.since_s = 1e-9 * static_cast<double>(*look.stamp_ns - *state.first_ns);
  }
  state.summary.add(summary);
  fmt::print("{}", options.json ? json_of(summary).dump() + "\n" : text_of(summary));
}

}  // namespace

void tell_sequence(const datasets::Sequence& sequence) {
  say(stderr, fmt::format("{}{}\n", sequence.kind(),
                          sequence.size() == 1  ? ", 1 frame"
                          : sequence.size() > 1 ? fmt::format(", {} frames", sequence.size())
                                                : ""));
  for (const std::string& remark : sequence.remarks()) say(stderr, "  note: " + remark + "\n");
  if (!sequence.calibration_file().empty()) {
    say(stderr, fmt::format("  calibration from {}\n", sequence.calibration_file()));
  }
}

void tell_left_out(const datasets::Sequence& sequence, std::size_t told) {
  for (std::size_t k = told; k < sequence.remarks().size(); ++k) {
    say(stderr, "  note: " + sequence.remarks()[k] + "\n");
  }
  for (const std::string& why : sequence.left_out()) say(stderr, "left out: " + why + "\n");
  const std::size_t more = sequence.left_out_count() - sequence.left_out().size();
  if (more > 0) say(stderr, fmt::format("left out: {} more\n", more));
}

int perceive_sequence(const PerceiveSequenceOptions& options) {
  check_perceive(options.frame);
  if (!options.frame.out.empty()) make_folder(options.frame.out, "--out");
  const auto sequence = datasets::open_sequence(options.source, options.sequence);
  tell_sequence(*sequence);
  const std::size_t told = sequence->remarks().size();
  if (!sequence->calibration() && options.frame.focal_px <= 0.0) {
    say(stderr,
        "  note: no calibration: lengths are in baselines (--calibration FILE, or --focal-px and "
        "--baseline-m)\n");
  }
  SequenceState state;
  datasets::SequenceLook look;
  bool stopped = false;
  while (!(stopped = options.stopped && options.stopped()) && sequence->next(look)) {
    see(options, *sequence, look, state);
  }
  tell_left_out(*sequence, told);
  if (options.json) {
    nlohmann::ordered_json all = state.summary.json();
    all["kind"] = sequence->kind();
    all["left_out"] = sequence->left_out_count();
    fmt::print("{}\n", nlohmann::ordered_json{{"summary", all}}.dump());
  } else {
    fmt::print("{}", state.summary.text());
  }
  if (stopped) return 130;
  return state.summary.frames() > 0 ? 0 : 1;
}

}  // namespace striate::app
