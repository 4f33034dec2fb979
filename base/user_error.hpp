#pragma once

#include <stdexcept>

namespace striate {

/// A mistake of the user's: the program prints what() and ends with exit code 2.
class UserError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace striate
