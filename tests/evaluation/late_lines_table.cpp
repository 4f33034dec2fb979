#include <fmt/format.h>

#include <cstdio>

#include "tests/reference/late_lines.hpp"

/// Seconds from the moment a line gets late until the robot stands for good, as a Markdown table.
///   late_lines_table [STRIATE]
namespace {

using striate::reference::kLateLines;
using striate::reference::LateLine;
using striate::reference::LateMission;

/// @returns what to write into the table.
std::string stands_after(const std::string& striate, LateLine line, double late_s) {
  LateMission mission(striate, STRIATE_SOURCE_DIR);
  mission.start();
  if (!mission.drives(0.3, 40.0)) return "did not start";
  mission.late(line, late_s);
  const LateMission::Watched seen = mission.watch(8.0 + late_s);
  std::string text = seen.moves_at_the_end ? fmt::format("drives ({:.2f} m/s)", seen.fastest_m_s)
                                           : fmt::format("{:.2f}", seen.last_moved_s);
  if (mission.state().collisions > 0) text += " **touched**";
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string striate = argc > 1 ? argv[1] : STRIATE_SOURCE_DIR "/build/release/striate";
  constexpr std::array kDelays_s{0.3, 0.8, 1.5, 3.0};
  fmt::print("| line | 0.3 s | 0.8 s | 1.5 s | 3 s |\n| --- | --- | --- | --- | --- |\n");
  for (std::size_t line = 0; line < kLateLines.size(); ++line) {
    fmt::print("| {} |", kLateLines[line]);
    for (const double late_s : kDelays_s) {
      fmt::print(" {} |", stands_after(striate, static_cast<LateLine>(line), late_s));
      std::fflush(stdout);
    }
    fmt::print("\n");
  }
  return 0;
}
