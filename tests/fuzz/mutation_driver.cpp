#include <sys/time.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "tests/fuzz/fuzz_target.hpp"

/// fuzz_<name> [SECONDS]: mutates the target's seeds, always in the same order, for so long; for
/// STRIATE_FUZZ_SECONDS where that is set.
namespace {

/// Of the processor's time, of which a busy machine gives little. An input that takes longer hangs;
/// under the sanitizers a whole mission of some cycles takes two
constexpr unsigned kHangs_s = 60;

void mutate(std::string& input, std::mt19937& random) {
  const int changes = 1 + static_cast<int>(random() % 6);
  for (int k = 0; k < changes && !input.empty(); ++k) {
    // Headers stand first: half of the changes go there.
    const std::size_t reach =
        random() % 2 == 0 ? std::min<std::size_t>(64, input.size()) : input.size();
    const std::size_t at = random() % reach;
    switch (random() % 4) {
      case 0:
        input[at] = static_cast<char>(random());
        break;
      case 1:
        input[at] = static_cast<char>(input[at] ^ (1U << (random() % 8)));
        break;
      case 2:
        input.insert(at, 1 + random() % 8, static_cast<char>(random() % 2 == 0 ? '9' : '\xff'));
        break;
      default:
        input.resize(random() % 8 == 0 ? at : input.size());
    }
  }
}

/// SIGPROF ends the program then; 0: never.
void limit_cpu(unsigned seconds) {
  itimerval limit{};
  limit.it_value.tv_sec = seconds;
  setitimer(ITIMER_PROF, &limit, nullptr);
}

}  // namespace

int main(int argc, char** argv) {
  const char* everywhere = std::getenv("STRIATE_FUZZ_SECONDS");
  const double seconds = everywhere != nullptr ? std::atof(everywhere)
                         : argc > 1            ? std::atof(argv[1])
                                               : 3.0;
  const std::vector<std::string> seeds = striate::fuzz::seeds();
  std::mt19937 random(1);
  const auto begin = std::chrono::steady_clock::now();
  long runs = 0;
  while (std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() <
         seconds) {
    std::string input = seeds[random() % seeds.size()];
    mutate(input, random);
    limit_cpu(kHangs_s);
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
    ++runs;
  }
  limit_cpu(0);
  std::printf("%ld inputs\n", runs);
  return 0;
}
