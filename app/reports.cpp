#include "striate/app/reports.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace striate::app {

void Reports::note(const char* what, const char* why) noexcept {
  if (std::strlen(why) == 0 || has_failed(what)) return;
  try {
    failures_.push_back({what, why});
  } catch (...) {  // no memory for it, either: then it is tried again
  }
}

bool Reports::has_failed(const char* what) const noexcept {
  return std::ranges::any_of(
      failures_, [what](const Failure& failure) { return std::strcmp(failure.what, what) == 0; });
}

std::string Reports::text() const {
  std::string text;
  for (const auto& [what, why] : failures_) text += fmt::format("{}: {}\n", what, why);
  return text;
}

}  // namespace striate::app
