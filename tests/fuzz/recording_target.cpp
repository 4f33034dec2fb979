#include "striate/base/user_error.hpp"
#include "striate/platform/replay/recording_reader.hpp"
#include "tests/fuzz/fuzz_target.hpp"
#include "tests/reference/recorded_cycles.hpp"

using namespace striate;

/// The whole file, which checksums guard, and each payload behind them.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::span<const std::uint8_t> rest(data + 1, size - 1);
  try {
    if (data[0] == 'f') {
      replay::RecordingReader reader(
          std::make_unique<std::istringstream>(std::string(rest.begin(), rest.end())), "run.rec");
      replay::RecordedCycle cycle;
      while (reader.next(cycle)) {
      }
    } else if (data[0] == 's') {
      (void)replay::decode_setup(rest);
    } else {
      replay::RecordedCycle cycle;
      replay::decode_cycle(rest, cycle);
    }
  } catch (const UserError&) {
  } catch (const BadBytes&) {
  }
  return 0;
}

std::vector<std::string> striate::fuzz::seeds() {
  const std::vector<std::uint8_t> setup = replay::encode(reference::a_setup());
  std::vector<std::uint8_t> cycle;
  replay::encode(reference::a_cycle(3), false, cycle);
  return {"f" + reference::a_recording(2), "s" + std::string(setup.begin(), setup.end()),
          "c" + std::string(cycle.begin(), cycle.end())};
}
