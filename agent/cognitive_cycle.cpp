#include "striate/agent/cognitive_cycle.hpp"

#include <fmt/format.h>

#include <utility>

#include "striate/agent/plausible_senses.hpp"

namespace striate::agent {
namespace {

perception::PerceptionExtras extras_for(const CycleExtras& extras, const Robot& robot) {
  perception::PerceptionExtras perception{
      {}, &robot.clock(), extras.disparities, &perception::stage_registry()};
  if (extras.knowledge) perception.views = memory::views_of(extras.knowledge->landmarks);
  return perception;
}

memory::FamiliarLandmarks landmarks_for(const CycleExtras& extras,
                                        const memory::LongTermSettings& settings,
                                        const tasks::Task& task) {
  if (!extras.knowledge) return {};
  // One at a time can be sought: the first that the task needs.
  const std::string sought = task.landmarks.empty() ? std::string() : task.landmarks.front();
  return {extras.knowledge->landmarks, settings, sought};
}

}  // namespace

std::vector<std::string> MissionKnowledge::names() const {
  std::vector<std::string> names;
  for (const memory::LandmarkModel& model : landmarks.landmarks) names.push_back(model.record.name);
  return names;
}

std::string doing_text(const behaviours::ShortText& why, behaviours::LimitReason limited_by) {
  std::string doing(why.view());
  if (limited_by != behaviours::LimitReason::none &&
      limited_by != behaviours::LimitReason::acceleration) {
    doing += fmt::format(" [limited: {}]", name_of(limited_by));
  }
  return doing;
}

CognitiveCycle::CognitiveCycle(Robot& robot, const RobotSettings& settings,
                               tasks::Executive& executive, const CycleExtras& extras)
    : robot_(robot),
      executive_(executive),
      perception_(settings.perception, robot.description(), extras_for(extras, robot)),
      memory_(settings.memory, robot.description()),
      landmarks_(landmarks_for(extras, settings.long_term_memory, executive.task())),
      limiter_(settings.safety, robot.description()) {
  if (extras.knowledge && extras.knowledge->places) memory_.know_map(*extras.knowledge->places);
}

CognitiveCycle::~CognitiveCycle() {
  robot_.stop();
}

/// One cycle of the robot, from light to motion. Each step takes what the steps above it made.
bool CognitiveCycle::step() {
  const StereoFrame seen_before = trace_.senses.stereo;
  if (!robot_.sense(trace_.senses)) return false;
  trace_.refused = refuse_implausible(trace_.senses, seen_before);
  const Senses& senses = trace_.senses;
  const StereoFrame& image = senses.stereo;

  // See: V1 -> stereo -> obstacles, motion, corridor, saliency, keypoints, recognition of
  // landmarks, where memory guides the eye. A image belongs to the place where it was taken; it
  // is looked at once, and until the next one comes what was seen in it stands.
  const Pose2 taken_at = odometry_.add(senses.odometry.stamp, senses.odometry.pose).at(image.stamp);
  const bool is_new = !image.left.empty() && image.stamp != trace_.percept.stamp;
  perception::Percept percept =
      is_new ? perception_.see(image, taken_at, landmarks_.expectations(memory_, taken_at))
             : std::move(trace_.percept);

  // Recognise: landmarks get their names, and teach something to long-term memory.
  static const memory::Recognised kNothingNew;
  const memory::Recognised& recognised =
      is_new ? landmarks_.recognised(percept, senses, memory_) : kNothingNew;

  // Remember: what was seen is put where it was seen, moved by odometry; what is old fades.
  const memory::ShortTermMemory& memory = memory_.update(senses, percept, recognised.sightings);

  // Want: the task script picks the behaviour, the behaviour says what it wants. A pilot goes
  // before it, a guard before both.
  const tasks::TaskDecision task = executive_.tick(memory, senses.now);
  const behaviours::Claim chosen =
      arbiter_.decide({task.claim, claim_of_pilot(senses.now)}, senses.now);

  // Move: one gate to the motors; what was really sent is remembered, and what held it back.
  const behaviours::Limited sent = limiter_.limit(chosen.wish, senses, memory);
  robot_.send(sent.command);
  memory_.remember(sent.command, task.doing, sent.held_by);

  trace_.percept = std::move(percept);
  trace_.sightings = recognised.sightings;
  trace_.lessons = recognised.lessons;
  trace_.wish = task.claim.wish;
  trace_.driver = chosen.owner;
  trace_.sent = sent.command;
  trace_.limited_by = sent.reason;
  return !task.ended;
}

behaviours::Claim CognitiveCycle::claim_of_pilot(TimePoint now) const {
  const std::optional<behaviours::Wish> wish = pilot_ ? pilot_(now) : std::nullopt;
  return wish ? behaviours::Claim{behaviours::MotorOwner::pilot, *wish} : behaviours::Claim{};
}

}  // namespace striate::agent
