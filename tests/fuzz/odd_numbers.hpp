#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <span>
#include <string>
#include <vector>

/// Bytes of an input as changes of numbers, for targets whose inputs are guarded by checksums or
/// nested in a format: the target has a good one, and the input says which numbers become what.
namespace striate::fuzz {

class OddNumbers {
 public:
  static constexpr std::size_t kChange_bytes = 11;  ///< which (2), how (1), by what (8)

  OddNumbers(const std::uint8_t* data, std::size_t size) : bytes_(data, size) {}

  /// Takes the next change; false: there is none.
  bool next() {
    if (bytes_.size() < kChange_bytes) return false;
    which_ = static_cast<std::size_t>(bytes_[0]) << 8U | bytes_[1];
    how_ = bytes_[2];
    std::memcpy(&value_, bytes_.data() + 3, sizeof(value_));
    bytes_ = bytes_.subspan(kChange_bytes);
    return true;
  }
  [[nodiscard]] std::size_t which(std::size_t count) const { return which_ % count; }
  [[nodiscard]] std::uint64_t raw() const { return value_; }

  /// What the number becomes.
  [[nodiscard]] double changed(double was) const {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    static constexpr std::array<double, 20> kOdd = {
        0.0,           -0.0,      1.0,
        -1.0,          2.0,       std::numeric_limits<double>::quiet_NaN(),
        1e300,         -1e300,    1e-300,
        5e-324,        kInfinity, -kInfinity,
        4e6,           -4e6,      2147483648.0,
        -2147483649.0, 9.3e18,    -9.3e18,
        1e6,           -1e6};
    const auto low = static_cast<std::int16_t>(value_);
    switch (how_ % 8) {
      case 0: {
        double bits = 0.0;
        std::memcpy(&bits, &value_, sizeof(bits));
        return bits;
      }
      case 1:
        return kOdd[value_ % kOdd.size()];
      case 2:
        return std::ldexp(was, low % 64);
      case 3:
        return was + low / 256.0;
      case 4:
        return -was;
      case 5:
        return static_cast<std::int32_t>(value_) / 1000.0;
      case 6:
        return low / 10'000.0;  // an angle
      default:
        return static_cast<std::uint16_t>(value_) / 100.0;  // a length
    }
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t which_ = 0;
  std::uint8_t how_ = 0;
  std::uint64_t value_ = 0;
};

/// Lists of up to five changes, the same in every run.
[[nodiscard]] inline std::vector<std::string> lists_of_changes() {
  std::mt19937 random(7);
  std::vector<std::string> lists;
  for (std::size_t list = 0; list < 200; ++list) {
    std::string bytes((1 + list % 5) * OddNumbers::kChange_bytes, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random());
    lists.push_back(bytes);
  }
  return lists;
}

}  // namespace striate::fuzz
