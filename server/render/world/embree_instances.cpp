#include "render/world/embree_instances.h"

#include "base/check.h"
#include "render/world/embree_query.h"

namespace saccade {

EmbreeInstances::EmbreeInstances(const std::vector<const EmbreeScene*>& bodies)
    : EmbreeTracer(bodies.at(0)->device_) {
  rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_LOW);
  for (const EmbreeScene* body : bodies) {
    RTCGeometry instance = rtcNewGeometry(device_->get(), RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(instance, body->scene_);
    rtcSetGeometryMask(instance, kBlockingMask | kStraightMask);  // that of each shape counts, too
    rtcAttachGeometryByID(scene_, instance, static_cast<unsigned>(instances_.size()));
    instances_.push_back(instance);
  }
}

EmbreeInstances::~EmbreeInstances() {
  for (RTCGeometry instance : instances_) rtcReleaseGeometry(instance);
}

void EmbreeInstances::place(std::span<const RigidMotion> motions) {
  SACCADE_CHECK(motions.size() == instances_.size());
  for (std::size_t i = 0; i < instances_.size(); ++i) {
    const RigidMotion& m = motions[i];
    const float columns[]{m.x.x, m.x.y, m.x.z, m.y.x,           m.y.y,           m.y.z,
                          m.z.x, m.z.y, m.z.z, m.translation.x, m.translation.y, m.translation.z};
    rtcSetGeometryTransform(instances_[i], 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns);
    rtcCommitGeometry(instances_[i]);
  }
  rtcCommitScene(scene_);
}

}  // namespace saccade
