#include "render/embree_scene.h"

#include <embree3/rtcore.h>

#include <stdexcept>
#include <string>

#include "base/check.h"

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

EmbreeScene::EmbreeScene(const Scene& scene, Shapes shapes) {
  // One thread: Embree builds in the calling thread, and its own threads never compete with the tile pool.
  device_ = rtcNewDevice("threads=1,set_affinity=0");
  if (!device_)
    throw std::runtime_error("Embree cannot start: error " + std::to_string(rtcGetDeviceError(nullptr)));
  rtcSetDeviceMemoryMonitorFunction(device_, countMemory, &bytes_);
  scene_ = rtcNewScene(device_);
  unsigned id = 0;
  const auto attach = [&](const auto& shape, auto make) {
    const unsigned its_id = id++;
    if (shapes == Shapes::kEmitters && !emits(shape)) return;
    RTCGeometry geometry = make(device_, shape);
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
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit r;
  r.ray = toEmbree(ray);
  r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  r.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene_, &context, &r);
  if (r.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  return {r.ray.tfar, {r.hit.Ng_x, r.hit.Ng_y, r.hit.Ng_z}, r.hit.u, r.hit.v, r.hit.geomID, r.hit.primID,
          true};
}

bool EmbreeScene::occluded(const Ray& ray) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay r = toEmbree(ray);
  rtcOccluded1(scene_, &context, &r);
  return r.tfar < 0;
}

}  // namespace saccade
