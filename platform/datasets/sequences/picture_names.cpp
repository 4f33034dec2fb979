#include <algorithm>
#include <charconv>

#include "striate/base/user_error.hpp"
#include "striate/platform/datasets/images/read_image.hpp"
#include "striate/platform/datasets/sequences/picture_list.hpp"

namespace striate::datasets {
namespace {

namespace fs = std::filesystem;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

}  // namespace

bool natural_less(const std::string& a, const std::string& b) {
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.size() && j < b.size()) {
    if (!is_digit(a[i]) || !is_digit(b[j])) {
      if (a[i] != b[j]) return a[i] < b[j];
      ++i;
      ++j;
      continue;
    }
    const auto number = [](const std::string& text, std::size_t& at) {
      const std::size_t begin = at;
      while (at < text.size() && is_digit(text[at])) ++at;
      std::size_t first = begin;
      while (first + 1 < at && text[first] == '0') ++first;
      return text.substr(first, at - first);
    };
    const std::string x = number(a, i);
    const std::string y = number(b, j);
    if (x.size() != y.size()) return x.size() < y.size();
    if (x != y) return x < y;
  }
  if (i < a.size() || j < b.size()) return j < b.size();
  return a < b;
}

std::optional<std::int64_t> stamp_in_name(const std::string& stem) {
  const std::size_t dot = stem.find('.');
  const std::string whole = stem.substr(0, dot);
  const std::string rest = dot == std::string::npos ? "" : stem.substr(dot + 1);
  if (whole.empty() || !std::ranges::all_of(whole, is_digit) ||
      !std::ranges::all_of(rest, is_digit))
    return {};
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(whole.data(), whole.data() + whole.size(), number);
  if (error != std::errc() || end != whole.data() + whole.size()) return {};
  constexpr std::int64_t kNs_per_s = 1'000'000'000;
  if (dot != std::string::npos) {
    if (rest.empty() || number > 9'000'000'000) return {};
    std::int64_t fraction = 0;
    const std::string nine = (rest + "000000000").substr(0, 9);
    (void)std::from_chars(nine.data(), nine.data() + nine.size(), fraction);
    return number * kNs_per_s + fraction;
  }
  if (whole.size() == 19) return number;
  if (whole.size() == 16) return number * 1000;
  return {};
}

std::vector<fs::path> pictures_in(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with('.') && is_image(entry.path())) found.push_back(entry.path());
  }
  std::ranges::sort(found, [](const fs::path& a, const fs::path& b) {
    return natural_less(a.filename().string(), b.filename().string());
  });
  return found;
}

}  // namespace striate::datasets
