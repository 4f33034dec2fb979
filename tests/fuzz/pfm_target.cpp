#include <sstream>

#include "striate/base/user_error.hpp"
#include "striate/evaluation/images/pfm.hpp"
#include "tests/fuzz/fuzz_target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::istringstream in(std::string(reinterpret_cast<const char*>(data), size));
  try {
    (void)striate::evaluation::read_pfm(in, "input");
  } catch (const striate::UserError&) {
  }
  return 0;
}

std::vector<std::string> striate::fuzz::seeds() {
  return {"Pf\n2 2\n-1.0\n" + std::string(16, '\x3f'), "Pf 3 1 1e0 " + std::string(12, '\x7f')};
}
