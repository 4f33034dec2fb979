#include "striate/app/memory/memory_diff.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "striate/memory/long_term/view_codec.hpp"

namespace striate::app {
namespace {

std::vector<std::uint32_t> contents(memory::MemoryTables& tables, std::int64_t landmark) {
  std::vector<std::uint32_t> sums;
  for (const memory::StoredView& view : tables.views.of(landmark)) {
    sums.push_back(crc32c(view.image, memory::checksum_of_view(view.width_px, view.height_px,
                                                               memory::bytes_of(view.descriptors),
                                                               memory::bytes_of(view.keypoints))));
  }
  std::sort(sums.begin(), sums.end());
  return sums;
}

bool same_place(const std::optional<memory::MapPosition>& a,
                const std::optional<memory::MapPosition>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return a->x_m == b->x_m && a->y_m == b->y_m && a->var_x_m2 == b->var_x_m2 &&
         a->cov_xy_m2 == b->cov_xy_m2 && a->var_y_m2 == b->var_y_m2;
}

std::string what_differs(const memory::Landmark& a, const memory::Landmark& b, bool same_views) {
  std::string text;
  const auto add = [&](bool differs, const std::string& what) {
    if (differs) text += (text.empty() ? "" : ", ") + what;
  };
  add(a.kind != b.kind, fmt::format("{} / {}", name_of(a.kind), name_of(b.kind)));
  add(a.views != b.views, fmt::format("views {} / {}", a.views, b.views));
  add(a.views == b.views && !same_views, "other views");
  add(a.strength != b.strength, fmt::format("strength {:.3f} / {:.3f}", a.strength, b.strength));
  add(a.history.uses != b.history.uses,
      fmt::format("uses {} / {}", a.history.uses, b.history.uses));
  add(!same_place(a.position, b.position), "place");
  add(a.pinned != b.pinned, "pinned");
  add(a.retired_s.has_value() != b.retired_s.has_value(),
      fmt::format("{} / {}", a.retired_s ? "forgotten" : "kept",
                  b.retired_s ? "forgotten" : "kept"));
  return text;
}

}  // namespace

std::vector<Difference> differences(memory::MemoryTables& a, memory::MemoryTables& b) {
  std::map<std::string, std::pair<std::optional<memory::Landmark>, std::optional<memory::Landmark>>>
      both;
  for (const memory::Landmark& landmark : a.landmarks.all(true))
    both[landmark.name].first = landmark;
  for (const memory::Landmark& landmark : b.landmarks.all(true))
    both[landmark.name].second = landmark;
  std::vector<Difference> found;
  for (const auto& [name, pair] : both) {
    const auto& [in_a, in_b] = pair;
    if (!in_a || !in_b) {
      found.push_back({name, in_a ? "only in A" : "only in B"});
      continue;
    }
    const std::string what =
        what_differs(*in_a, *in_b, contents(a, in_a->id) == contents(b, in_b->id));
    if (!what.empty()) found.push_back({name, what});
  }
  return found;
}

}  // namespace striate::app
