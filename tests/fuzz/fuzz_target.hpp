#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// What a fuzz target defines. Any input must end in a value or a UserError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace striate::fuzz {

/// Well-formed inputs that mutations start from.
[[nodiscard]] std::vector<std::string> seeds();

}  // namespace striate::fuzz
