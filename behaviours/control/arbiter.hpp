#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>

#include "striate/base/limits.hpp"
#include "striate/behaviours/control/wish.hpp"

namespace striate::behaviours {

/// Who may want the motors; later names go first.
enum class MotorOwner : std::uint8_t { nobody, behaviour, pilot, guard, emergency };

/// Somebody wants the motors, and what for.
struct Claim {
  MotorOwner owner = MotorOwner::nobody;
  Wish wish;
};

/// Gives the motors to one owner at a time. A wish is a lease: an owner that does not renew it
/// within kWishLease loses the motors, and with nobody left the robot stands.
class Arbiter {
 public:
  static constexpr Duration kLease = kWishLease;  ///< two cycles of 100 ms

  /// Hands in a wish; its lease counts from its own stamp.
  void offer(MotorOwner owner, const Wish& wish);
  /// Gives the motors back before the lease ends.
  void release(MotorOwner owner);
  /// The wish that drives now: that of the first owner with a valid lease, or to stand.
  Wish decide(TimePoint now);
  /// The same where these are all who want the motors now, each at most once: whoever is not among
  /// them has given them back.
  Claim decide(std::initializer_list<Claim> claims, TimePoint now);
  [[nodiscard]] MotorOwner owner() const { return owner_; }

 private:
  struct Lease {
    bool held = false;
    Wish wish;
  };
  std::array<Lease, 5> leases_{};
  MotorOwner owner_ = MotorOwner::nobody;
  double last_pan_rad_ = 0.0;
  double last_tilt_rad_ = 0.0;
};

[[nodiscard]] const char* name_of(MotorOwner owner);

}  // namespace striate::behaviours
