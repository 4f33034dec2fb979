#include "striate/behaviours/registry.hpp"

#include "striate/behaviours/approach_landmark.hpp"
#include "striate/behaviours/avoid.hpp"
#include "striate/behaviours/back_up.hpp"
#include "striate/behaviours/drive_straight.hpp"
#include "striate/behaviours/explore.hpp"
#include "striate/behaviours/go_to.hpp"
#include "striate/behaviours/look_around.hpp"
#include "striate/behaviours/look_at.hpp"
#include "striate/behaviours/return_to_start.hpp"
#include "striate/behaviours/say.hpp"
#include "striate/behaviours/seek_landmark.hpp"
#include "striate/behaviours/stop.hpp"
#include "striate/behaviours/teach.hpp"
#include "striate/behaviours/traverse_corridor.hpp"
#include "striate/behaviours/turn_to.hpp"
#include "striate/behaviours/wait.hpp"

namespace striate::behaviours {
namespace {

std::vector<BehaviourEntry> our_behaviours() {
  return {
      behaviour_entry<ApproachLandmark>("approach_landmark",
                                        "drives up to a recognised landmark and faces it"),
      behaviour_entry<Avoid>("avoid", "goes round what stands ahead, or lets it pass"),
      behaviour_entry<BackUp>("back_up", "drives straight back"),
      behaviour_entry<DriveStraight>("drive_straight", "drives straight ahead"),
      behaviour_entry<Explore>("explore", "drives where memory knows least, until all is known"),
      behaviour_entry<GoTo>("go_to", "drives to the known place of a landmark"),
      behaviour_entry<LookAround>("look_around", "turns the head from side to side, and back"),
      behaviour_entry<LookAt>("look_at",
                              "turns the head to a direction, or to what is most salient"),
      behaviour_entry<ReturnToStart>("return_to_start",
                                     "drives back along its own trail to where the run began"),
      behaviour_entry<Say>("say", "shows a text to people"),
      behaviour_entry<SeekLandmark>("seek_landmark",
                                    "looks and drives about until it recognises a landmark"),
      behaviour_entry<Stop>("stop", "stands still"),
      behaviour_entry<Teach>("teach", "looks at what stands out ahead from several places"),
      behaviour_entry<TraverseCorridor>("traverse_corridor",
                                        "drives along the corridor, round what stands in it"),
      behaviour_entry<TurnTo>("turn_to", "turns on the spot"),
      behaviour_entry<Wait>("wait", "stands for a while"),
  };
}

BehaviourRegistry& table() {
  static BehaviourRegistry all(our_behaviours());
  return all;
}

}  // namespace

const BehaviourRegistry& behaviour_registry() {
  return table();
}

bool enroll(BehaviourEntry entry) {
  return table().add(std::move(entry));
}

const BehaviourEntry* find_behaviour(const std::string& name) {
  return table().find(name);
}

config::Node detail::with_main(const config::Node& arguments, const std::string& main) {
  if (arguments.kind != config::Node::Kind::scalar || main.empty()) return arguments;
  config::Node map;
  map.kind = config::Node::Kind::map;
  map.place = arguments.place;
  map.entries.push_back({main, arguments.place, arguments});
  return map;
}

}  // namespace striate::behaviours
