#include "striate/agent/landmark_list.hpp"

#include <algorithm>
#include <functional>

#include "striate/agent/memory_json.hpp"

namespace striate::agent {

std::vector<ListedLandmark> list_landmarks(memory::MemoryTables& tables, bool with_retired,
                                           const memory::LongTermSettings& settings) {
  const memory::Situation now{tables.sessions.operating_now_s(), 0, {}};
  std::vector<ListedLandmark> list;
  for (const memory::Landmark& one : tables.landmarks.all(with_retired)) {
    list.push_back({memory::activation_of(one, now, {}, settings).total(), one});
  }
  std::ranges::stable_sort(list, std::ranges::greater(), &ListedLandmark::activation);
  return list;
}

nlohmann::ordered_json to_json(const std::vector<ListedLandmark>& landmarks) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const auto& [activation, landmark] : landmarks) {
    json.push_back(to_json(landmark));
    json.back()["activation"] = activation;
  }
  return json;
}

}  // namespace striate::agent
