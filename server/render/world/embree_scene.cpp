#include "render/world/embree_scene.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <stdexcept>
#include <string>

#include "base/check.h"
#include "base/instruction_set.h"
#include "render/world/embree_query.h"

namespace saccade {
namespace {

RTCGeometry makeMesh(RTCDevice device, const Mesh& mesh) {
  SACCADE_CHECK(mesh.positions.size() > 1);  // the last entry is padding
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, mesh.positions.data(), 0,
                             sizeof(Vec3), mesh.positions.size() - 1);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.triangles.data(), 0,
                             sizeof(mesh.triangles[0]), mesh.triangles.size());
  return geometry;
}

RTCGeometry makeSphere(RTCDevice device, const Sphere& sphere) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
  auto* point = static_cast<float*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 4 * sizeof(float), 1));
  point[0] = sphere.center.x, point[1] = sphere.center.y, point[2] = sphere.center.z,
  point[3] = sphere.radius;
  return geometry;
}

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

}  // namespace

EmbreeScene::EmbreeScene(const Scene& scene, Shapes shapes) : shapes_(scene) {
  // One thread: Embree builds in the calling thread, and its own threads never compete with the tile pool.
  const bool wide = instructionSet() == InstructionSet::kAvx512;
  device_ = rtcNewDevice(wide ? "threads=1,set_affinity=0" : "threads=1,set_affinity=0,isa=avx2");
  if (!device_)
    throw std::runtime_error("Embree cannot start: error " + std::to_string(rtcGetDeviceError(nullptr)));
  rtcSetDeviceMemoryMonitorFunction(device_, countMemory, &bytes_);
  scene_ = rtcNewScene(device_);
  unsigned id = 0;
  const auto attach = [&](const auto& shape, auto make) {
    const unsigned its_id = id++;
    const bool straight = transmitsStraight(scene.materials[static_cast<std::size_t>(shape.material)]);
    if (shapes == Shapes::kEmitters && !emits(shape)) return;
    if (shapes == Shapes::kStraight && !straight) return;
    RTCGeometry geometry = make(device_, shape);
    const std::uint32_t kind = straight ? kStraightMask : kBlockingMask;
    rtcSetGeometryMask(geometry, shapes == Shapes::kAll ? kind : kBlockingMask | kStraightMask);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene_, geometry, its_id);
    rtcReleaseGeometry(geometry);
  };
  for (const Mesh& mesh : scene.meshes) attach(mesh, makeMesh);
  for (const Sphere& sphere : scene.spheres) attach(sphere, makeSphere);
  rtcCommitScene(scene_);
  RTCBounds b;
  rtcGetSceneBounds(scene_, &b);
  diagonal_ = length(Vec3{b.upper_x - b.lower_x, b.upper_y - b.lower_y, b.upper_z - b.lower_z});
}

EmbreeScene::~EmbreeScene() {
  rtcReleaseScene(scene_);
  rtcReleaseDevice(device_);
}

Hit EmbreeScene::intersect(const Ray& ray) const {
  RTCRayHit r;
  r.ray = toEmbree(ray);
  r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  r.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  embree::intersect(rtcIntersect1, false, &r, scene_);
  if (r.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  return {r.ray.tfar, {r.hit.Ng_x, r.hit.Ng_y, r.hit.Ng_z}, r.hit.u, r.hit.v, r.hit.geomID, r.hit.primID,
          true};
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

// Calls call(lanes as Embree wants them).
template <int W>
void EmbreeScene::trace(LaneSet lanes, const auto& call) const {
  const Valid<W> valid(lanes);
  PacketCounts* counts = counts_.load(std::memory_order_relaxed);
  if (!counts) return call(valid.lanes);
  const auto begin = std::chrono::steady_clock::now();
  call(valid.lanes);
  counts->time += std::chrono::steady_clock::now() - begin;
  counts->rays += static_cast<std::uint64_t>(lanes.size()), counts->lanes += W;
}

template <int W>
void EmbreeScene::intersect(RayPacket<W>& packet, LaneSet lanes, Rays rays) const {
  using RayHit = typename PacketCalls<W>::RayHit;
  static_assert(sizeof(RayPacket<W>) >= sizeof(RayHit) && offsetof(RayHit, hit) == 12 * 4 * W);
  std::fill_n(packet.geometry, W, RTC_INVALID_GEOMETRY_ID);
  std::fill_n(packet.instance, W, RTC_INVALID_GEOMETRY_ID);
  trace<W>(lanes, [&](const int* valid) {
    embree::intersect(PacketCalls<W>::intersect, rays == Rays::kCoherent, reinterpret_cast<RayHit*>(&packet),
                      valid, scene_);
  });
}

template <int W>
void EmbreeScene::occluded(RayPacket<W>& packet, LaneSet lanes) const {
  trace<W>(lanes, [&](const int* valid) {
    embree::occluded(PacketCalls<W>::occluded,
                     &reinterpret_cast<typename PacketCalls<W>::RayHit*>(&packet)->ray, valid, scene_);
  });
}

template <int W>
void intersectCoherent(const EmbreeScene& scene, std::span<const Ray> rays, std::span<Hit> hits) {
  RayPacket<W> packet;
  for (std::size_t first = 0; first < hits.size(); first += W) {
    const int count = static_cast<int>(std::min<std::size_t>(W, hits.size() - first));
    for (int i = 0; i < count; ++i) packet.set(i, rays[first + static_cast<std::size_t>(i)]);
    scene.intersect(packet, LaneSet::first(count), EmbreeScene::Rays::kCoherent);
    for (int i = 0; i < count; ++i) hits[first + static_cast<std::size_t>(i)] = packet.hit(i);
  }
}

#define INSTANTIATE(W)                                                                      \
  template void EmbreeScene::intersect<W>(RayPacket<W>&, LaneSet, EmbreeScene::Rays) const; \
  template void EmbreeScene::occluded<W>(RayPacket<W>&, LaneSet) const;
INSTANTIATE(8)
INSTANTIATE(16)

void EmbreeScene::intersect(std::span<const Ray> rays, std::span<Hit> hits) const {
  if (instructionSet() == InstructionSet::kAvx512)
    intersectCoherent<16>(*this, rays, hits);
  else
    intersectCoherent<8>(*this, rays, hits);
}

bool EmbreeScene::occluded(const Ray& ray) const {
  RTCRay r = toEmbree(ray);
  embree::occluded(rtcOccluded1, &r, scene_);
  return r.tfar < 0;
}

}  // namespace saccade
