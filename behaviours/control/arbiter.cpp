#include "striate/behaviours/control/arbiter.hpp"

namespace striate::behaviours {

void Arbiter::offer(MotorOwner owner, const Wish& wish) {
  if (owner == MotorOwner::nobody) return;
  leases_[static_cast<std::size_t>(owner)] = {true, wish};
}

void Arbiter::release(MotorOwner owner) {
  leases_[static_cast<std::size_t>(owner)].held = false;
}

Wish Arbiter::decide(TimePoint now) {
  for (const MotorOwner owner :
       {MotorOwner::emergency, MotorOwner::guard, MotorOwner::pilot, MotorOwner::behaviour}) {
    Lease& lease = leases_[static_cast<std::size_t>(owner)];
    if (!lease.held) continue;
    if (now - lease.wish.stamp > kLease) {
      lease.held = false;
      continue;
    }
    owner_ = owner;
    last_pan_rad_ = lease.wish.pan_rad;
    last_tilt_rad_ = lease.wish.tilt_rad;
    return lease.wish;
  }
  owner_ = MotorOwner::nobody;
  Wish stand;
  stand.pan_rad = last_pan_rad_;
  stand.tilt_rad = last_tilt_rad_;
  stand.why = "nobody wants the motors";
  stand.stamp = now;
  return stand;
}

Claim Arbiter::decide(std::initializer_list<Claim> claims, TimePoint now) {
  leases_ = {};
  for (const Claim& claim : claims) offer(claim.owner, claim.wish);
  const Wish wish = decide(now);
  return {owner_, wish};
}

const char* name_of(MotorOwner owner) {
  switch (owner) {
    case MotorOwner::behaviour:
      return "behaviour";
    case MotorOwner::pilot:
      return "pilot";
    case MotorOwner::guard:
      return "guard";
    case MotorOwner::emergency:
      return "emergency";
    case MotorOwner::nobody:
      break;
  }
  return "nobody";
}

}  // namespace striate::behaviours
