#include "striate/config/diagnostics.hpp"
#include "striate/tasks/task_reader.hpp"
#include "tests/fuzz/fuzz_target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  striate::config::Diagnostics diagnostics("fuzz/input.yaml", 'T');
  const std::string text(reinterpret_cast<const char*>(data), size);
  const striate::tasks::Task task =
      striate::tasks::read_task(text, diagnostics, striate::RobotDescription{});
  if (diagnostics.none()) {
    (void)striate::tasks::text_tree(task.outline);
    (void)striate::tasks::svg_tree(task.outline);
    (void)striate::tasks::xml_tree(task.outline);
  } else {
    (void)diagnostics.text();
  }
  return 0;
}

std::vector<std::string> striate::fuzz::seeds() {
  return {
      "striate: 1\nmission: all\nneeds: {landmarks: [book]}\nvars: {cruise: 0.4 m/s}\n"
      "always:\n  - pause_if: {image_older_than: 250 ms}\n  - fail_if: {battery_below: 20 %}\n"
      "do:\n  - traverse_corridor: {speed: $cruise, keep: middle}\n    until: {progress: 12 m}\n"
      "    within: 4 min\n    if_it_fails:\n      tries: 2\n      do:\n"
      "        - back_up: {distance: 0.3 m}\n  - try:\n      - look_around: {pan: 60 deg}\n"
      "        within: 30 s\n      - say: \"I cannot\"\nfinally:\n  - stop: {}\n",
      "striate: 1\ndo:\n  - together:\n      - drive_straight: {distance: 1 m}\n"
      "      - repeat: {times: 3, do: [look_at: {pan: 20 deg}]}\n    only_if: {after: 0 s}\n"
      "    unless: {light_below: 10 %}\n    optional: true\n  - repeat:\n      - wait: 1 s\n"
      "    until: {after: 9 s}\n  - use: other.yaml\n    with: {speed: 0.3 m/s}\n",
      "a: &a [x, x]\nb: [*a, *a]\nstriate: 010\n? [x]\n: y\ndo: - - - [{a: {b: [c, d]}}]\n",
  };
}
