#include "app/sequence/stream_rig.h"

#include <stdexcept>

#include "app/request/refusal.h"

namespace saccade {
namespace {

void checkAlike(const FeedConfig& first, const FeedConfig& further) {
  if (first.camera == further.camera) return;
  refuse("quality.bake_error",
         "light is computed ahead for views of equal size, intrinsics and distortion only");
}

BakePlan planView(const RenderScene& scene, const Trajectory& body, const ResolvedStream& stream,
                  std::size_t view) {
  try {
    return planBake(scene, body.mounted(stream.T_body_camera[view]), stream.feedOf(view), stream.frames,
                    stream.request.quality().bake_error());
  } catch (const std::runtime_error& fault) {
    refuse("quality.bake_error", fault.what());
  }
}

}  // namespace

Rig makeRig(const std::shared_ptr<const RenderScene>& scene, const Trajectory& body,
            const ResolvedStream& stream, const PoolHandle& pool,
            const std::map<std::size_t, Trajectory>& steered) {
  std::vector<std::unique_ptr<Feed>> feeds;
  for (std::size_t i = 0; i < stream.views(); ++i) {
    FeedConfig config = stream.feedOf(i);
    for (const auto& [number, path] : steered) config.body_paths[number] = path;
    feeds.push_back(std::make_unique<Feed>(scene, body.mounted(stream.T_body_camera[i]), config, pool));
  }
  return Rig(std::move(feeds));
}

BakePlan planBakeOf(const RenderScene& scene, const Trajectory& body, const ResolvedStream& stream) {
  BakePlan whole = planView(scene, body, stream, 0);
  for (std::size_t i = 1; i < stream.views(); ++i) {
    checkAlike(stream.feed, stream.feedOf(i));
    const BakePlan plan = planView(scene, body, stream, i);
    whole.poses.insert(whole.poses.end(), plan.poses.begin(), plan.poses.end());
  }
  return whole;
}

}  // namespace saccade
