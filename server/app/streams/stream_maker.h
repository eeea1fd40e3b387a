// Makes a stream from a request: checks it, loads the scene, and joins a running feed or makes one.
#pragma once

#include <memory>
#include <mutex>

#include "app/feeds/feed_maker.h"
#include "app/feeds/measured_costs.h"
#include "app/feeds/shared_feeds.h"
#include "app/sequence/stream_plan.h"
#include "app/streams/pending_opens.h"
#include "app/streams/stream_resources.h"

namespace saccade {

class StreamMaker {
 public:
  // `pending_opens` is told what is being done; it must outlive this.
  StreamMaker(const StreamResources& resources, PendingOpens& pending_opens)
      : resources_(resources),
        feeds_(resources.pool, resources.totals, resources.log, resources.quota.limits()),
        pending_opens_(pending_opens) {}

  // Makes the stream and enters it into the registry. May take seconds. From any thread. Throws Refusal,
  // SceneError, and Cancelled.
  v1::StreamOpened make(v1::OpenStream request, PendingOpen& opening);

 private:
  struct Plan : StreamPlan {
    CpuCost frame = {};  // of a frame, where the stream keeps a pace
  };
  BuildContext begin(PendingOpen& opening, const char* doing);
  std::vector<Share> feedShare(const ResolvedStream& stream) const;
  std::shared_ptr<void> reserve(const std::string& user, const std::vector<Share>& shares);
  void openFeed(Plan& plan, PendingOpen& opening, Stream& stream);
  bool enter(const Plan& plan, const OwnFeed& own, Stream& stream);
  PoolHandle poolFor(const PendingOpen& opening) const;
  CpuCost measure(const Plan& plan, const Trajectory& body, const PendingOpen& opening);
  void chooseSpeed(Plan& plan);
  bool keepsPace(const ResolvedStream& resolved) const;
  void admit(const ResolvedStream& resolved, const CpuCost& frame, const FeedRunner* joined) const;
  bool connect(const ResolvedStream& resolved, Stream& stream) const;

  const StreamResources resources_;
  const FeedMaker feeds_;
  PendingOpens& pending_opens_;
  SharedFeeds shared_;
  MeasuredCosts costs_;
  std::mutex admitting_;  // held from a check of the load until the new stream is part of it
};

}  // namespace saccade
