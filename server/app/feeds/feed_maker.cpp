#include "app/feeds/feed_maker.h"

#include "app/feeds/steered_rig.h"
#include "app/sequence/stream_rig.h"

namespace saccade {
namespace {

// Of the objects that the client has named. All objects of a stream that is steered are bodies.
std::map<std::size_t, Trajectory> steeredBodies(const ResolvedStream& stream) {
  std::map<std::size_t, Trajectory> paths;
  for (std::size_t i = 0; i < stream.objects.size(); ++i)
    if (stream.objects[i].given) paths.emplace(i, stream.feed.body_paths[i]);
  return paths;
}

}  // namespace

OwnFeed FeedMaker::ofScene(const std::shared_ptr<const RenderScene>& scene, const Trajectory& body,
                           const ResolvedStream& stream, const PoolHandle& pool) const {
  const v1::Timing& timing = stream.request.timing();
  if (!timing.steerable()) {
    const auto rig = std::make_shared<Rig>(makeRig(scene, body, stream, pool));
    return {run(rig, stream, factsOf(*rig, body, stream.frames))};
  }
  const std::size_t waiting = timing.clock() == v1::CLOCK_LOCKSTEP ? most(Limit::kSteers) : 0;
  const auto steering =
      std::make_shared<Steering>(body, steeredBodies(stream), timing.frame_rate_hz(), stream.frames, waiting);
  const auto rig = std::make_shared<SteeredRig>(
      makeRig(scene, steering->begin(), stream, pool, steering->bodiesBegin()), steering);
  return {run(rig, stream, factsOf(*rig, body, stream.frames)), steering};
}

OwnFeed FeedMaker::ofClient(const ResolvedStream& stream) const {
  const CameraModel& camera = stream.feed.camera;
  const auto frames = std::make_shared<PushedFrames>(camera.width, camera.height, stream.feed.frame_rate_hz,
                                                     stream.frames, most(Limit::kPushes));
  return {run(frames, stream, {}), {}, frames};
}

std::shared_ptr<FeedRunner> FeedMaker::run(std::shared_ptr<IntervalSource> source,
                                           const ResolvedStream& stream, const FeedFacts& facts) const {
  const v1::Timing& timing = stream.request.timing();
  const FeedPace pace{stream.frames, timing.speed()};
  return std::make_shared<FeedRunner>(std::move(source), pace, pool_, totals_, log_, facts);
}

std::size_t FeedMaker::most(Limit limit) const {
  return static_cast<std::size_t>(limits_[limit]);
}

}  // namespace saccade
