#include "behaviours/registry.hpp"

#include "behaviours/avoid.hpp"
#include "behaviours/back_up.hpp"
#include "behaviours/drive_straight.hpp"
#include "behaviours/look_around.hpp"
#include "behaviours/look_at.hpp"
#include "behaviours/say.hpp"
#include "behaviours/stop.hpp"
#include "behaviours/teach.hpp"
#include "behaviours/traverse_corridor.hpp"
#include "behaviours/turn_to.hpp"
#include "behaviours/wait.hpp"

namespace striate {

const std::vector<BehaviourEntry>& behaviour_registry() {
  static const std::vector<BehaviourEntry> entries{
      behaviour_entry<Avoid>("avoid", "goes round what stands ahead, or lets it pass"),
      behaviour_entry<BackUp>("back_up", "drives straight back"),
      behaviour_entry<DriveStraight>("drive_straight", "drives straight ahead"),
      behaviour_entry<LookAround>("look_around", "turns the head from side to side, and back"),
      behaviour_entry<LookAt>("look_at",
                              "turns the head to a direction, or to what is most salient"),
      behaviour_entry<Say>("say", "shows a text to people"),
      behaviour_entry<Stop>("stop", "stands still"),
      behaviour_entry<Teach>("teach", "looks at what stands out ahead from several places"),
      behaviour_entry<TraverseCorridor>("traverse_corridor",
                                        "drives along the corridor, round what stands in it"),
      behaviour_entry<TurnTo>("turn_to", "turns on the spot"),
      behaviour_entry<Wait>("wait", "stands for a while"),
  };
  return entries;
}

const BehaviourEntry* find_behaviour(const std::string& name) {
  for (const BehaviourEntry& entry : behaviour_registry()) {
    if (entry.name == name) return &entry;
  }
  return nullptr;
}

config::Node detail::with_main(const config::Node& arguments, const std::string& main) {
  if (arguments.kind != config::Node::Kind::scalar || main.empty()) return arguments;
  config::Node map;
  map.kind = config::Node::Kind::map;
  map.place = arguments.place;
  map.entries.push_back({main, arguments.place, arguments});
  return map;
}

}  // namespace striate
