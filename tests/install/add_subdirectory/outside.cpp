#include <array>
#include <cstdint>

#include "striate/base/crc32c.hpp"

/// The check value of CRC-32C in the catalogues: of the digits 1 to 9.
int main() {
  constexpr std::array<std::uint8_t, 9> kDigits = {'1', '2', '3', '4', '5', '6', '7', '8', '9'};
  return striate::crc32c(kDigits) == 0xE3069283U ? 0 : 1;
}
