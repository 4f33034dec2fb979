#include "striate/platform/datasets/sequences/picture_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "striate/base/user_error.hpp"

namespace striate::datasets {
namespace {

namespace fs = std::filesystem;

/// Median of the steps from stamp to stamp that go forward; 0: fewer than two.
std::int64_t usual_step_ns(const std::vector<PictureEntry>& entries) {
  std::vector<std::int64_t> steps;
  for (std::size_t k = 1; k < entries.size(); ++k) {
    if (!entries[k].stamp_ns || !entries[k - 1].stamp_ns) return 0;
    const std::int64_t step = *entries[k].stamp_ns - *entries[k - 1].stamp_ns;
    if (step > 0) steps.push_back(step);
  }
  if (steps.empty()) return 0;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

bool all_stamped(const std::vector<PictureEntry>& entries) {
  return !entries.empty() &&
         std::ranges::all_of(entries, [](const PictureEntry& e) { return e.stamp_ns.has_value(); });
}

void sort_by_stamp(std::vector<PictureEntry>& entries) {
  std::ranges::stable_sort(entries, {}, [](const PictureEntry& e) { return *e.stamp_ns; });
}

/// Both sorted by stamp; each right picture is used once.
void pair_by_stamp(std::vector<PictureEntry> left, std::vector<PictureEntry> right,
                   PictureList& list) {
  sort_by_stamp(left);
  sort_by_stamp(right);
  const std::int64_t step_ns = std::max(usual_step_ns(left), usual_step_ns(right));
  std::int64_t worst_ns = 0;
  std::size_t alone = 0;
  std::size_t at = 0;
  const auto off_ns = [&](const PictureEntry& entry, std::size_t k) {
    return std::abs(*right[k].stamp_ns - *entry.stamp_ns);
  };
  for (PictureEntry& entry : left) {
    while (at + 1 < right.size() && off_ns(entry, at + 1) <= off_ns(entry, at)) ++at;
    if (at >= right.size() || off_ns(entry, at) > step_ns / 2) {
      ++alone;
      continue;
    }
    worst_ns = std::max(worst_ns, off_ns(entry, at));
    entry.right = right[at++].left;
    list.entries.push_back(entry);
  }
  if (alone > 0) {
    list.remarks.push_back(
        fmt::format("{} left pictures have no right one of their time: left out", alone));
  }
  if (worst_ns > 0) {
    list.remarks.push_back(fmt::format(
        "the eyes are out of step by up to {:.1f} ms: what moves is seen at a wrong distance",
        1e-6 * static_cast<double>(worst_ns)));
  }
}

}  // namespace

std::vector<PictureEntry> entries_of(const std::vector<fs::path>& pictures) {
  std::vector<PictureEntry> entries;
  for (const fs::path& picture : pictures) {
    const std::string stem = picture.stem().string();
    entries.push_back({stem, picture, {}, stamp_in_name(stem)});
  }
  return entries;
}

fs::path folder_of_pictures(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) return {};
  if (!pictures_in(folder).empty()) return folder;
  for (const char* usual : {"data", "rgb", "images", "image"}) {
    if (!pictures_in(folder / usual).empty()) return folder / usual;
  }
  fs::path only;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (!entry.is_directory(error) || pictures_in(entry.path()).empty()) continue;
    if (!only.empty()) return {};
    only = entry.path();
  }
  return only;
}

void pair_eyes(const std::vector<PictureEntry>& left, const std::vector<PictureEntry>& right,
               PictureList& list) {
  std::map<std::string, fs::path> by_name;
  for (const PictureEntry& entry : right) by_name.emplace(entry.name, entry.left);
  std::vector<PictureEntry> paired;
  for (PictureEntry entry : left) {
    const auto partner = by_name.find(entry.name);
    if (partner == by_name.end()) continue;
    entry.right = partner->second;
    paired.push_back(entry);
  }
  const std::size_t most = std::min(left.size(), right.size());
  if (paired.size() * 2 < most && all_stamped(left) && all_stamped(right)) {
    pair_by_stamp(left, right, list);
    return;
  }
  list.entries = paired;
  for (const auto& [eye, count] :
       {std::pair("left", left.size()), std::pair("right", right.size())}) {
    if (count == paired.size()) continue;
    list.remarks.push_back(fmt::format("{} {} pictures have no partner of their name: left out",
                                       count - paired.size(), eye));
  }
}

void judge_stamps(PictureList& list) {
  if (!all_stamped(list.entries)) return;
  const auto earlier = [](const PictureEntry& a, const PictureEntry& b) {
    return *a.stamp_ns < *b.stamp_ns;
  };
  if (!std::ranges::is_sorted(list.entries, earlier)) {
    sort_by_stamp(list.entries);
    list.remarks.emplace_back("its times go back: taken in the order of their times");
  }
  const std::int64_t step_ns = usual_step_ns(list.entries);
  std::size_t gaps = 0;
  std::size_t same = 0;
  std::int64_t longest_ns = 0;
  std::string after;
  for (std::size_t k = 1; k < list.entries.size(); ++k) {
    const std::int64_t step = *list.entries[k].stamp_ns - *list.entries[k - 1].stamp_ns;
    if (step == 0) ++same;
    if (2 * step <= 3 * step_ns) continue;  // one and a half: one picture is missing
    ++gaps;
    if (step > longest_ns) after = list.entries[k - 1].name;
    longest_ns = std::max(longest_ns, step);
  }
  if (same > 0) list.remarks.push_back(fmt::format("{} pictures have the time of another", same));
  if (gaps == 0) return;
  list.remarks.push_back(
      fmt::format("{} gap{} in time, the longest {:.2f} s after {}; usual are {:.3f} s", gaps,
                  gaps == 1 ? "" : "s", 1e-9 * static_cast<double>(longest_ns), after,
                  1e-9 * static_cast<double>(step_ns)));
}

}  // namespace striate::datasets
