// Makes a stream from a request: checks it, loads the scene, and joins a running feed or makes one.
#pragma once

#include <memory>
#include <mutex>

#include "app/feeds/feed_maker.h"
#include "app/feeds/shared_feeds.h"
#include "app/sequence/stream_plan.h"
#include "app/streams/openings.h"
#include "app/streams/stream_resources.h"

namespace saccade {

class StreamMaker {
 public:
  // `openings` is told what is being done; it must outlive this.
  StreamMaker(const StreamResources& resources, Openings& openings)
      : resources_(resources),
        feeds_(resources.pool, resources.totals, resources.log, resources.quota.limits()),
        openings_(openings) {}

  // Makes the stream and enters it into the registry. May take seconds. From any thread. Throws Refusal,
  // SceneError, and Cancelled.
  v1::StreamOpened make(v1::OpenStream request, Opening& opening);

 private:
  struct Plan : StreamPlan {
    CpuCost frame = {};  // of a frame, where the stream keeps a pace
  };
  BuildContext begin(Opening& opening, const char* doing);
  std::shared_ptr<void> reserve(const std::string& user, const std::vector<Share>& shares);
  void openFeed(Plan& plan, Opening& opening, Stream& stream);
  bool enter(const Plan& plan, const OwnFeed& own, Stream& stream);
  PoolHandle poolFor(const Opening& opening) const;
  CpuCost measure(const Plan& plan, const Trajectory& body, const Opening& opening) const;
  bool keepsPace(const ResolvedStream& resolved) const;
  void admit(const ResolvedStream& resolved, const CpuCost& frame, const FeedRunner* joined) const;
  bool connect(const ResolvedStream& resolved, Stream& stream) const;

  const StreamResources resources_;
  const FeedMaker feeds_;
  Openings& openings_;
  SharedFeeds shared_;
  std::mutex admitting_;  // held from a check of the load until the new stream is part of it
};

}  // namespace saccade
