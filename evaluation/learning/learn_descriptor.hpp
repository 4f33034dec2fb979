#pragma once

#include <cstdint>
#include <string>

namespace striate::evaluation {

struct LearnOptions {
  int pictures = 80;       ///< made; the table that ships took 60, two minutes
  std::uint64_t seed = 1;  ///< any; the same one gives the same table
  std::string out = "striate_256.inc";
};

/// Makes images and second views of them, takes true and false patch pairs at their SIFT frames,
/// learns 256 bits and returns the table's text. No photograph is used.
/// @throws UserError where too few frames were found again.
[[nodiscard]] std::string learn_descriptor(const LearnOptions& options);

}  // namespace striate::evaluation
