#pragma once

#include <string>

#include "striate/platform/interface/senses.hpp"

namespace striate::pioneer {

/// Two eyes that look by themselves, in a thread of their own; the newest rectified pair waits in
/// one slot.
class StereoCamera {
 public:
  virtual ~StereoCamera() = default;
  /// The newest pair, stamped with the middle of its exposure; empty until the first has come. The
  /// pixels are shared and do not change. `head` is left for the caller.
  [[nodiscard]] virtual StereoFrame newest() const = 0;
  /// Why no image comes, in plain words; empty: nothing is known to be wrong.
  [[nodiscard]] virtual std::string trouble() const = 0;
};

}  // namespace striate::pioneer
