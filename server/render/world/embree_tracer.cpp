#include "render/world/embree_tracer.h"

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/instruction_set.h"
#include "render/world/embree_query.h"

namespace saccade {
namespace {

// Embree calls this with the bytes it has allocated, or with a negative number for bytes it has freed.
bool countMemory(void* counter, ssize_t bytes, bool) {
  *static_cast<std::atomic<std::size_t>*>(counter) += static_cast<std::size_t>(bytes);
  return true;
}

RTCRay toEmbree(const Ray& ray) {
  RTCRay r;
  r.org_x = ray.origin.x, r.org_y = ray.origin.y, r.org_z = ray.origin.z, r.tnear = 0;
  r.dir_x = ray.direction.x, r.dir_y = ray.direction.y, r.dir_z = ray.direction.z, r.time = 0;
  r.tfar = ray.tfar, r.mask = 0xffffffffu, r.id = 0, r.flags = 0;
  return r;
}

// Of the functions of one width.
template <int W>
struct PacketCalls;
template <>
struct PacketCalls<8> {
  using RayHit = RTCRayHit8;
  static constexpr auto intersect = rtcIntersect8;
  static constexpr auto occluded = rtcOccluded8;
};
template <>
struct PacketCalls<16> {
  using RayHit = RTCRayHit16;
  static constexpr auto intersect = rtcIntersect16;
  static constexpr auto occluded = rtcOccluded16;
};

template <int W>
struct alignas(64) Valid {
  explicit Valid(LaneSet of) {
    for (int i = 0; i < W; ++i) lanes[i] = -static_cast<int>(of.has(i));
  }
  int lanes[W];
};

}  // namespace

// One thread: Embree's own threads never compete with the tile pool.
EmbreeDevice::EmbreeDevice()
    : device_(rtcNewDevice(instructionSet() == InstructionSet::kAvx512
                               ? "threads=1,set_affinity=0"
                               : "threads=1,set_affinity=0,isa=avx2")) {
  if (!device_)
    throw std::runtime_error("Embree cannot start: error " + std::to_string(rtcGetDeviceError(nullptr)));
  rtcSetDeviceMemoryMonitorFunction(device_, countMemory, &bytes_);
}

EmbreeDevice::~EmbreeDevice() {
  rtcReleaseDevice(device_);
}

EmbreeTracer::EmbreeTracer(std::shared_ptr<EmbreeDevice> device)
    : device_(std::move(device)), scene_(rtcNewScene(device_->get())) {}

EmbreeTracer::~EmbreeTracer() {
  rtcReleaseScene(scene_);
}

void EmbreeTracer::intersect(const Ray& ray, Hit& hit) const {
  RTCRayHit r;
  r.ray = toEmbree(ray);
  r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  r.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  embree::intersect(rtcIntersect1, false, &r, scene_);
  if (r.hit.geomID == RTC_INVALID_GEOMETRY_ID) return;
  hit = {{r.hit.instID[0], r.hit.geomID, r.hit.primID, r.hit.u, r.hit.v},
         r.ray.tfar,
         {r.hit.Ng_x, r.hit.Ng_y, r.hit.Ng_z},
         true};
}

// Calls call(lanes as Embree wants them).
template <int W>
void EmbreeTracer::trace(LaneSet lanes, const auto& call) const {
  const Valid<W> valid(lanes);
  PacketCounts* counts = counts_.load(std::memory_order_relaxed);
  if (!counts) return call(valid.lanes);
  const auto begin = std::chrono::steady_clock::now();
  call(valid.lanes);
  counts->time += std::chrono::steady_clock::now() - begin;
  counts->rays += static_cast<std::uint64_t>(lanes.size()), counts->lanes += W;
}

template <int W>
void EmbreeTracer::intersectFurther(RayPacket<W>& packet, LaneSet lanes, Rays rays) const {
  using RayHit = typename PacketCalls<W>::RayHit;
  static_assert(sizeof(RayPacket<W>) >= sizeof(RayHit) && offsetof(RayHit, hit) == 12 * 4 * W);
  trace<W>(lanes, [&](const int* valid) {
    embree::intersect(PacketCalls<W>::intersect, rays == Rays::kCoherent, reinterpret_cast<RayHit*>(&packet),
                      valid, scene_);
  });
}

template <int W>
void EmbreeTracer::occluded(RayPacket<W>& packet, LaneSet lanes) const {
  trace<W>(lanes, [&](const int* valid) {
    embree::occluded(PacketCalls<W>::occluded,
                     &reinterpret_cast<typename PacketCalls<W>::RayHit*>(&packet)->ray, valid, scene_);
  });
}

bool EmbreeTracer::occluded(const Ray& ray) const {
  RTCRay r = toEmbree(ray);
  embree::occluded(rtcOccluded1, &r, scene_);
  return r.tfar < 0;
}

#define INSTANTIATE(W)                                                                 \
  template void EmbreeTracer::intersectFurther<W>(RayPacket<W>&, LaneSet, Rays) const; \
  template void EmbreeTracer::occluded<W>(RayPacket<W>&, LaneSet) const;
INSTANTIATE(8)
INSTANTIATE(16)

}  // namespace saccade
