#include "striate/viewer/channels/cycle_facts.hpp"

#include <algorithm>

#include "striate/agent/recall/memory_state.hpp"
#include "striate/tasks/nodes/task_node.hpp"
#include "striate/viewer/channels/map_facts.hpp"

namespace striate::viewer {
namespace {

/// As `striate run --inspect` renews its view
constexpr Duration kSlowEvery = std::chrono::seconds(1);
/// By hand: half the window is driven in 10 s; the map itself changes only where the window of
/// short-term memory moves on.
constexpr Duration kGlobalEvery = std::chrono::seconds(5);

void take_slow(const memory::ShortTermMemory& memory, SlowFacts& slow) {
  take_local(memory.map(), slow.local);
  slow.trajectory.clear();
  for (std::size_t k = 0; k < memory.trajectory().count(); ++k) {
    slow.trajectory.push_back(memory.trajectory().at(k));
  }
  slow.landmarks.clear();
  for (const memory::LandmarkInMind& one : memory.landmarks().all()) {
    if (one.landmark == 0 || !one.place_known) continue;
    slow.landmarks.push_back(
        {std::string(one.name.view()), one.place, one.place_sigma_m, one.sightings > 0});
  }
  take_routes(memory.place(), slow);
  slow.light_level = memory.light_level();
  slow.noise_level = memory.noise_level();
  slow.seen_share = memory.seen_share();
}

char letter_of_node(const tasks::TaskNode* node) {
  if (node == nullptr) return '-';
  switch (node->shown()) {
    case tasks::NodeState::waiting:
      break;
    case tasks::NodeState::running:
      return 'r';
    case tasks::NodeState::succeeded:
      return 's';
    case tasks::NodeState::failed:
      return 'f';
    case tasks::NodeState::skipped:
      return 'k';
    case tasks::NodeState::halted:
      return 'h';
  }
  return 'w';
}

void add_nodes(const tasks::Outline& outline, std::string& letters) {
  letters += letter_of_node(outline.node);
  for (const tasks::Outline& child : outline.children) add_nodes(child, letters);
}

/// What was recognised has its name in the sighting that was made of it, in the same order.
void take_seen(const agent::CycleTrace& trace, SeenFacts& seen) {
  const perception::Percept& percept = trace.percept;
  const StereoFrame& frame = trace.senses.stereo;
  const cv::Mat1f& map = percept.saliency.salience.empty() ? percept.disparity.disparity_px
                                                           : percept.saliency.salience;
  seen.working_px = map.size();
  seen.image_px = frame.left.size();
  seen.head = frame.head;
  seen.focal_px = percept.disparity.focal_px;
  seen.centre_u_px = percept.disparity.centre_u_px;
  seen.centre_v_px = percept.disparity.centre_v_px;
  seen.columns = percept.columns;
  seen.keypoints = percept.keypoints;
  seen.landmarks.clear();
  const std::size_t named = std::min(trace.sightings.size(), percept.recognitions.size());
  for (std::size_t k = 0; k < named; ++k) {
    seen.landmarks.push_back({std::string(trace.sightings[k].name), percept.recognitions[k]});
  }
}

void take_decision(const agent::CycleTrace& trace, const tasks::Executive& executive,
                   CycleFacts& facts) {
  facts.refused = trace.refused;
  facts.wish = trace.wish;
  facts.driver = trace.driver;
  facts.sent = trace.sent;
  facts.limited_by = trace.limited_by;
  facts.doing = executive.current_action();
  facts.state = executive.state();
  facts.reason = facts.state == tasks::MissionState::running ? std::string() : executive.reason();
  facts.nodes.clear();
  add_nodes(executive.task().outline, facts.nodes);
  facts.node_reason = executive.reason();
  facts.recognised.clear();
  for (const memory::LandmarkSighting& one : trace.sightings) {
    facts.recognised.emplace_back(one.name);
  }
  facts.lessons.clear();
  for (const memory::LandmarkLesson& one : trace.lessons) {
    facts.lessons.push_back(
        {std::string(one.name), one.kind == memory::LandmarkLesson::Kind::recognised});
  }
}

}  // namespace

bool FactsTaker::due(TimePoint now, std::optional<TimePoint>& last, Duration every) {
  if (last && now - *last < every) return false;
  last = now;
  return true;
}

/// Images are copied: body and perception may use their own again.
void FactsTaker::take_vision(const agent::CycleTrace& trace, CycleFacts& facts) {
  const StereoFrame& frame = trace.senses.stereo;
  facts.new_image = !frame.left.empty() && image_ != frame.stamp;
  cv::Mat3b left = facts.senses.stereo.left;
  cv::Mat3b right = facts.senses.stereo.right;
  if (facts.new_image) {
    image_ = frame.stamp;
    frame.left.copyTo(left);
    frame.right.copyTo(right);
  }
  facts.senses = trace.senses;
  facts.senses.stereo.left = left;
  facts.senses.stereo.right = right;

  const perception::Percept& percept = trace.percept;
  facts.new_percept = percept.valid && percept_ != percept.stamp;
  if (!facts.new_percept) return;
  percept_ = facts.percept_stamp = percept.stamp;
  percept.disparity.disparity_px.copyTo(facts.disparity.disparity_px);
  facts.disparity.focal_px = percept.disparity.focal_px;
  facts.disparity.baseline_m = percept.disparity.baseline_m;
  percept.saliency.salience.copyTo(facts.salience);
  facts.regions = percept.saliency.regions;
  facts.obstacles = percept.obstacles;
  facts.moving = percept.moving;
  take_seen(trace, facts.seen);
}

void FactsTaker::take(const agent::CognitiveCycle& cycle, const tasks::Executive& executive,
                      std::uint64_t number, CycleFacts& facts) {
  const agent::CycleTrace& trace = cycle.trace();
  const memory::ShortTermMemory& memory = cycle.memory();
  facts.number = number;
  take_vision(trace, facts);
  take_decision(trace, executive, facts);
  facts.image_age_s = memory.image_age_s();
  take_map(memory.place(), facts);
  const TimePoint now = trace.senses.now;
  facts.slow_is_new = due(now, slow_, kSlowEvery);
  if (facts.slow_is_new) {
    take_slow(memory, facts.slow);
    facts.slow.short_term = agent::memory_state(cycle, executive, number);
  }
  facts.new_global = facts.on_map && due(now, global_, kGlobalEvery);
  if (facts.new_global) take_global(memory.place(), facts.global);
}

}  // namespace striate::viewer
