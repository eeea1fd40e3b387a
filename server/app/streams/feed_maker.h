// Makes feeds, and what their clients control them with.
#pragma once

#include <memory>

#include "app/request/resolve.h"
#include "app/streams/feed_runner.h"
#include "app/streams/pushed_frames.h"
#include "app/streams/steering.h"
#include "app/streams/stream_resources.h"

namespace saccade {

struct OwnFeed {
  std::shared_ptr<FeedRunner> runner;
  std::shared_ptr<Steering> steering = {};    // where its client steers it
  std::shared_ptr<PushedFrames> pushed = {};  // where its client sends the frames
};

class FeedMaker {
 public:
  explicit FeedMaker(const StreamResources& resources) : resources_(resources) {}

  // Renders frame 0 on `pool`. `body`: the path of the body that carries the cameras.
  OwnFeed ofScene(const std::shared_ptr<const RenderScene>& scene, const Trajectory& body,
                  const ResolvedStream& stream, const PoolHandle& pool) const;
  // Of a stream with `pushed`.
  OwnFeed ofClient(const ResolvedStream& stream) const;

 private:
  std::shared_ptr<FeedRunner> run(std::shared_ptr<IntervalSource> source, const ResolvedStream& stream,
                                  const FeedFacts& facts) const;
  std::size_t most(Limit limit) const;

  const StreamResources resources_;
};

}  // namespace saccade
