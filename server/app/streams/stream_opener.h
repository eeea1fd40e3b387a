// Opens streams: checks the request, loads the scene, finds or makes the feed. This may take seconds, so
// every request has its own thread.
#pragma once

#include <atomic>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "app/admission/resource_quota.h"
#include "app/request/resolve.h"
#include "app/streams/openings.h"
#include "app/streams/scene_cache.h"
#include "app/streams/stream_registry.h"
#include "ops/client_log.h"

namespace saccade {

class StreamOpener {
 public:
  struct Transports {
    WakeFd &data, &broadcast;
  };

  // Keeps references.
  StreamOpener(SceneCache& scenes, const MeasuredTables& tables, TilePool& pool, ResourceQuota& quota,
               StreamRegistry& streams, Transports transports, Totals& totals, ClientLog& log,
               std::uint64_t epoch);

  // `answer` is called once, from another thread. How many wait is the caller's to bound. Throws Refusal.
  void open(RawRequest request, const Peer& peer, std::function<void(v1::Reply)> answer);
  Openings& openings() { return openings_; }
  void stop();  // from now on every request is refused, and those under way end soon
  // After stop(): whether none is being opened any more, before `deadline`. The destructor waits for the
  // rest.
  bool wait(ChangeNotifier::Clock::time_point deadline);

 private:
  v1::Status openNow(RawRequest request, Opening& opening, v1::StreamOpened& opened);
  v1::StreamOpened openStream(v1::OpenStream request, Opening& opening);
  std::shared_ptr<void> reserve(const std::string& user, const ResolvedStream& resolved);
  // Throws LimitReached, where the threads do not suffice for the pace.
  void openFeed(const ResolvedStream& resolved, const RenderScene& whole,
                const std::shared_ptr<const RenderScene>& scene, Opening& opening, Stream& stream);
  // Puts the stream into the registry: with a feed that runs, or else with `own`. False: there is neither.
  bool enter(const ResolvedStream& resolved, const CpuCost& frame, const std::shared_ptr<FeedRunner>& own,
             Stream& stream);
  CpuCost measure(const ResolvedStream& resolved, const Trajectory& path,
                  std::shared_ptr<const RenderScene> scene, const Opening& opening) const;
  bool isMeasured(const ResolvedStream& resolved) const;
  void admit(const ResolvedStream& resolved, const CpuCost& frame, const FeedRunner* joined) const;
  std::shared_ptr<FeedRunner> findFeed(const ResolvedStream& resolved);
  std::shared_ptr<FeedRunner> makeFeed(const ResolvedStream& resolved, Trajectory path,
                                       std::shared_ptr<const RenderScene> scene,
                                       const Opening& opening) const;
  void share(const ResolvedStream& resolved, const std::shared_ptr<FeedRunner>& feed);
  // Makes the stream's session and sink. False: the feed has ended.
  bool connect(const ResolvedStream& resolved, Stream& stream);

  SceneCache& scenes_;
  const MeasuredTables& tables_;
  TilePool& pool_;
  ResourceQuota& quota_;
  StreamRegistry& streams_;
  const Transports transports_;
  Totals& totals_;
  ClientLog& log_;
  const std::uint64_t epoch_;
  std::mutex admitting_;  // held from a look at what streams take until one more is among them
  std::mutex mutex_;
  std::map<std::string, std::weak_ptr<FeedRunner>> shared_;  // by ResolvedStream::feedKey()
  Openings openings_;
  std::vector<std::future<void>> opening_;
  std::atomic<bool> stopped_ = false;
};

}  // namespace saccade
