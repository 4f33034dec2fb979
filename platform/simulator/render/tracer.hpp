#pragma once

#include <embree3/rtcore.h>

#include <array>
#include <memory>
#include <vector>

#include "striate/platform/simulator/render/patches.hpp"

namespace striate::simulator::render {

/// Sixteen rays at once, as Embree takes them.
struct alignas(64) Packet {
  static constexpr unsigned kSize = 16;  ///< rays: Embree's widest packet
  RTCRayHit16 rays;
  std::array<int, kSize> valid{};  ///< -1 for a ray to be traced, 0 for an empty lane

  /// Sixteen valid rays from one place, still to be aimed. Field by field, which a compiler turns
  /// into whole vectors.
  void start(Vec3 origin, float t_min, float t_max);
  void aim(unsigned lane, Vec3 direction) {
    rays.ray.dir_x[lane] = direction.x;
    rays.ray.dir_y[lane] = direction.y;
    rays.ray.dir_z[lane] = direction.z;
  }
  /// One valid ray; `t_max` in lengths of `direction`.
  void set(unsigned lane, Vec3 origin, Vec3 direction, float t_min, float t_max);
  /// No ray in this lane. It gets harmless numbers: Debian's Embree checks empty lanes too.
  void clear(unsigned lane) {
    set(lane, {}, {0.0F, 0.0F, 1.0F}, 0.0F, -1.0F);
    valid[lane] = 0;
  }
  [[nodiscard]] bool hit(unsigned lane) const {
    return rays.hit.geomID[lane] != RTC_INVALID_GEOMETRY_ID;
  }
  [[nodiscard]] Vec3 direction(unsigned lane) const {
    return {rays.ray.dir_x[lane], rays.ray.dir_y[lane], rays.ray.dir_z[lane]};
  }
  [[nodiscard]] Vec3 place(unsigned lane) const {
    return Vec3{rays.ray.org_x[lane], rays.ray.org_y[lane], rays.ray.org_z[lane]} +
           direction(lane) * rays.ray.tfar[lane];
  }
};

inline void Packet::start(Vec3 origin, float t_min, float t_max) {
  for (unsigned i = 0; i < kSize; ++i) rays.ray.org_x[i] = origin.x;
  for (unsigned i = 0; i < kSize; ++i) rays.ray.org_y[i] = origin.y;
  for (unsigned i = 0; i < kSize; ++i) rays.ray.org_z[i] = origin.z;
  for (unsigned i = 0; i < kSize; ++i) rays.ray.tnear[i] = t_min;
  for (unsigned i = 0; i < kSize; ++i) rays.ray.tfar[i] = t_max;
  for (unsigned i = 0; i < kSize; ++i) rays.ray.time[i] = 0.0F;
  for (unsigned i = 0; i < kSize; ++i) rays.ray.mask[i] = ~0U;
  for (unsigned i = 0; i < kSize; ++i) rays.ray.id[i] = i;
  for (unsigned i = 0; i < kSize; ++i) rays.ray.flags[i] = 0;
  for (unsigned i = 0; i < kSize; ++i) rays.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
  for (unsigned i = 0; i < kSize; ++i) rays.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  valid.fill(-1);
}

inline void Packet::set(unsigned lane, Vec3 origin, Vec3 direction, float t_min, float t_max) {
  rays.ray.org_x[lane] = origin.x;
  rays.ray.org_y[lane] = origin.y;
  rays.ray.org_z[lane] = origin.z;
  aim(lane, direction);
  rays.ray.tnear[lane] = t_min;
  rays.ray.tfar[lane] = t_max;
  rays.ray.time[lane] = 0.0F;
  rays.ray.mask[lane] = ~0U;
  rays.ray.id[lane] = lane;
  rays.ray.flags[lane] = 0;
  rays.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
  rays.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
  valid[lane] = -1;
}

/// The patches in Embree: what stands still, built once, and the people, built anew each image.
/// One thread; two tracers may work in two threads.
class Tracer {
 public:
  static constexpr unsigned kStill = 0;   ///< geomID of a patch that stands still
  static constexpr unsigned kPeople = 1;  ///< geomID of a part of a person

  explicit Tracer(const std::vector<Patch>& still);
  ~Tracer();
  Tracer(const Tracer&) = delete;
  Tracer& operator=(const Tracer&) = delete;

  void set_people(const std::vector<Patch>& people);
  /// primID is the patch's number. `coherent`: the rays go nearly the same way. `people`: whether
  /// the rays may meet anybody.
  void intersect(Packet& packet, bool coherent, bool people = true) const;
  /// tfar becomes -inf where anything stands between; the hits are left alone.
  void occlude(Packet& packet) const;

 private:
  RTCDevice device_ = nullptr;
  RTCScene still_ = nullptr;
  RTCScene people_ = nullptr;
  bool has_people_ = false;
};

}  // namespace striate::simulator::render
