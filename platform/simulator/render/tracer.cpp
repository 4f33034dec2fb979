#include "striate/platform/simulator/render/tracer.hpp"

#include <stdexcept>

namespace striate::simulator::render {
namespace {

RTCScene build(RTCDevice device, const std::vector<Patch>& patches, unsigned id,
               RTCBuildQuality quality) {
  RTCScene scene = rtcNewScene(device);
  rtcSetSceneBuildQuality(scene, quality);
  if (!patches.empty()) {
    RTCGeometry quads = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_QUAD);
    auto* corner = static_cast<float*>(rtcSetNewGeometryBuffer(quads, RTC_BUFFER_TYPE_VERTEX, 0,
                                                               RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                                               patches.size() * 4));
    auto* index = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
        quads, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT4, 4 * sizeof(unsigned), patches.size()));
    unsigned next = 0;
    for (const Patch& patch : patches) {
      for (const Vec3& p : patch.corner) {
        *corner++ = p.x;
        *corner++ = p.y;
        *corner++ = p.z;
        *index++ = next++;
      }
    }
    rtcSetGeometryBuildQuality(quads, quality);
    rtcCommitGeometry(quads);
    rtcAttachGeometryByID(scene, quads, id);
    rtcReleaseGeometry(quads);
  }
  rtcCommitScene(scene);
  return scene;
}

}  // namespace

Tracer::Tracer(const std::vector<Patch>& still) {
  // One thread: a run is one thread, and several runs share the machine.
  device_ = rtcNewDevice("threads=1,user_threads=1,set_affinity=0");
  if (device_ == nullptr) throw std::runtime_error("Embree cannot start on this machine");
  still_ = build(device_, still, kStill, RTC_BUILD_QUALITY_MEDIUM);
}

Tracer::~Tracer() {
  if (people_ != nullptr) rtcReleaseScene(people_);
  if (still_ != nullptr) rtcReleaseScene(still_);
  if (device_ != nullptr) rtcReleaseDevice(device_);
}

void Tracer::set_people(const std::vector<Patch>& people) {
  if (people_ != nullptr) rtcReleaseScene(people_);
  people_ = nullptr;
  has_people_ = !people.empty();
  if (has_people_) people_ = build(device_, people, kPeople, RTC_BUILD_QUALITY_LOW);
}

void Tracer::intersect(Packet& packet, bool coherent, bool people) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags =
      coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
  rtcIntersect16(packet.valid.data(), still_, &context, &packet.rays);
  if (people && has_people_) rtcIntersect16(packet.valid.data(), people_, &context, &packet.rays);
}

void Tracer::occlude(Packet& packet) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded16(packet.valid.data(), still_, &context, &packet.rays.ray);
  if (!has_people_) return;
  // A ray that was stopped is no valid ray any more.
  alignas(64) std::array<int, Packet::kSize> open = packet.valid;
  for (unsigned i = 0; i < Packet::kSize; ++i) {
    if (packet.rays.ray.tfar[i] < 0.0F) open[i] = 0;
  }
  rtcOccluded16(open.data(), people_, &context, &packet.rays.ray);
}

}  // namespace striate::simulator::render
