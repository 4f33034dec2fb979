#pragma once

#include <string_view>

namespace striate {

/// The instruction set that the vector code runs on here, as it says itself: "AVX3_DL", "AVX2",
/// "NEON", ...; "SCALAR" or "EMU128": none. It is what the dispatch arrives at, which need not be
/// what the processor could do best: Striate is not built for all that Highway knows.
[[nodiscard]] std::string_view instruction_set();

}  // namespace striate
