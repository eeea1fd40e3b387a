#include "app/request/read_pose.h"
#include "app/request/refusal.h"
#include "app/request/resolve_parts.h"
#include "base/hash_rng.h"

namespace saccade {
namespace {

Pose resolveMount(v1::View& view, const std::string& field) {
  if (!view.has_body_camera()) return {};
  v1::RigidTransform& mount = *view.mutable_body_camera();
  if (!mount.has_rotation()) mount.mutable_rotation()->set_w(1);
  const Pose pose = readPose(mount.position(), mount.rotation(), field + ".body_camera");
  return {pose.position, unitNear(pose.rotation, pose.rotation)};
}

void checkOfStream(std::uint32_t view, const std::string& field, const ResolvedStream& stream) {
  if (view >= stream.views())
    refuse(field,
           "there is no view " + std::to_string(view) + "; there are " + std::to_string(stream.views()));
}

}  // namespace

std::string viewField(std::size_t view) {
  return view == 0 ? "view" : "further_views[" + std::to_string(view - 1) + "]";
}

void resolveMounts(ResolvedStream& stream) {
  v1::OpenStream& request = stream.request;
  stream.T_body_camera = {resolveMount(*request.mutable_view(), viewField(0))};
  for (v1::View& view : *request.mutable_further_views())
    stream.T_body_camera.push_back(resolveMount(view, viewField(stream.views())));
  for (int i = 0; i < request.sensors_size(); ++i)
    checkOfStream(request.sensors(i).view(), "sensors[" + std::to_string(i) + "].view", stream);
  for (int i = 0; i < request.truth_size(); ++i)
    checkOfStream(request.truth(i).view(), "truth[" + std::to_string(i) + "].view", stream);
}

void shareSettings(ResolvedStream& stream) {
  constexpr std::uint64_t kSeeds = ranges::kSensors.max;  // the addresses below are those of sensors
  for (std::size_t i = 0; i < stream.further.size(); ++i) {
    FeedConfig feed = stream.feed;
    feed.camera = stream.further[i].camera;
    feed.seed = hashKey(stream.feed.seed, kSeeds + i);
    stream.further[i] = feed;
  }
}

}  // namespace saccade
