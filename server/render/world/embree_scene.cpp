#include "render/world/embree_scene.h"

#include "base/check.h"
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

bool changesForm(const Mesh& mesh) {
  return deforms(mesh);
}
bool changesForm(const Sphere&) {
  return false;
}

}  // namespace

EmbreeScene::EmbreeScene(const Scene& scene, Shapes shapes, int body, std::shared_ptr<EmbreeDevice> device,
                         Form form)
    : EmbreeTracer(std::move(device)), shapes_(scene) {
  if (form == Form::kChanges) {  // else a commit builds all anew
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_DYNAMIC);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_LOW);
  }
  unsigned id = 0;
  const auto attach = [&](const auto& shape, auto make) {
    const unsigned its_id = id++;
    const bool straight = transmitsStraight(scene.materials[static_cast<std::size_t>(shape.material)]);
    if (shape.body != body) return;
    if (shapes == Shapes::kEmitters && !emits(shape)) return;
    if (shapes == Shapes::kStraight && !straight) return;
    RTCGeometry geometry = make(device_->get(), shape);
    const std::uint32_t kind = straight ? kStraightMask : kBlockingMask;
    rtcSetGeometryMask(geometry, shapes == Shapes::kAll ? kind : kBlockingMask | kStraightMask);
    if (form == Form::kChanges && changesForm(shape)) {
      rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_REFIT);
      changing_.push_back(its_id);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene_, geometry, its_id);
    rtcReleaseGeometry(geometry);
  };
  for (const Mesh& mesh : scene.meshes) attach(mesh, makeMesh);
  for (const Sphere& sphere : scene.spheres) attach(sphere, makeSphere);
  rtcCommitScene(scene_);
  RTCBounds b;
  rtcGetSceneBounds(scene_, &b);
  const bool empty = !(b.lower_x <= b.upper_x);
  diagonal_ = empty ? 0 : length(Vec3{b.upper_x - b.lower_x, b.upper_y - b.lower_y, b.upper_z - b.lower_z});
}

// A refitted tree keeps its topology, so that it depends on the present form alone.
void EmbreeScene::update() {
  for (const unsigned id : changing_) {
    RTCGeometry geometry = rtcGetGeometry(scene_, id);
    rtcUpdateGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0);
    rtcCommitGeometry(geometry);
  }
  rtcCommitScene(scene_);
}

}  // namespace saccade
