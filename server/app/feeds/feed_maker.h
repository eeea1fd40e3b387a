// Makes feeds, and what their clients control them with.
#pragma once

#include <memory>

#include "app/admission/limits.h"
#include "app/feeds/feed_runner.h"
#include "app/feeds/pushed_frames.h"
#include "app/feeds/steering.h"
#include "app/request/resolved_stream.h"

namespace saccade {

struct OwnFeed {
  std::shared_ptr<FeedRunner> runner;
  std::shared_ptr<Steering> steering = {};    // where its client steers it
  std::shared_ptr<PushedFrames> pushed = {};  // where its client sends the frames
};

class FeedMaker {
 public:
  // Keeps the references. Feeds run on `pool`, add to `totals` and log to `log`.
  FeedMaker(TilePool& pool, Totals& totals, ClientLog& log, const Limits& limits)
      : pool_(pool), totals_(totals), log_(log), limits_(limits) {}

  // Renders frame 0 on `pool`. `body`: the path of the body that carries the cameras.
  OwnFeed ofScene(const std::shared_ptr<const RenderScene>& scene, const Trajectory& body,
                  const ResolvedStream& stream, const PoolHandle& pool) const;
  // Of a stream with `pushed`.
  OwnFeed ofClient(const ResolvedStream& stream) const;

 private:
  std::shared_ptr<FeedRunner> run(std::shared_ptr<IntervalSource> source, const ResolvedStream& stream,
                                  const FeedFacts& facts) const;
  std::size_t most(Limit limit) const;

  TilePool& pool_;
  Totals& totals_;
  ClientLog& log_;
  const Limits& limits_;
};

}  // namespace saccade
