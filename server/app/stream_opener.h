// Opens streams: checks the request, loads the scene, finds or makes the feed. This may take seconds, so
// every request has its own thread.
#pragma once

#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "app/budget.h"
#include "app/resolve.h"
#include "app/scene_cache.h"
#include "app/stream_registry.h"
#include "ops/client_log.h"

namespace saccade {

class StreamOpener {
 public:
  struct Transports {
    WakeFd &data, &broadcast;
  };

  // Keeps references.
  StreamOpener(SceneCache& scenes, const MeasuredTables& tables, TilePool& pool, Budget& budget,
               StreamRegistry& streams, Transports transports, Totals& totals, ClientLog& log,
               std::uint64_t epoch);

  // `answer` is called once, from another thread. How many wait is the caller's to bound. Throws Refusal.
  void open(const v1::OpenStream& request, const std::string& user, std::function<void(v1::Reply)> answer);
  // From now on every request is refused. Returns whether those being opened are open before `deadline`; the
  // destructor waits for the others.
  bool stop(Signal::Clock::time_point deadline);

 private:
  v1::StreamOpened openNow(const v1::OpenStream& request, const std::string& user);
  // Throws LimitReached, where the threads do not suffice for the pace.
  void openFeed(const ResolvedStream& resolved, const RenderScene& whole,
                const std::shared_ptr<const RenderScene>& scene, Stream& stream);
  CpuCost admit(const ResolvedStream& resolved, const Trajectory& path,
                const std::shared_ptr<const RenderScene>& scene, bool joins);
  std::shared_ptr<FeedRunner> findFeed(const ResolvedStream& resolved);
  std::shared_ptr<FeedRunner> makeFeed(const ResolvedStream& resolved, Trajectory path,
                                       std::shared_ptr<const RenderScene> scene);
  void share(const ResolvedStream& resolved, const std::shared_ptr<FeedRunner>& feed);
  // Makes the stream's session and outlet. False: the feed has ended.
  bool connect(const ResolvedStream& resolved, Stream& stream);

  SceneCache& scenes_;
  const MeasuredTables& tables_;
  TilePool& pool_;
  TilePool paced_pool_;
  Budget& budget_;
  StreamRegistry& streams_;
  const Transports transports_;
  Totals& totals_;
  ClientLog& log_;
  const std::uint64_t epoch_;
  std::mutex pacing_;  // PACED streams are admitted one after another
  std::mutex mutex_;
  std::map<std::string, std::weak_ptr<FeedRunner>> shared_;  // by ResolvedStream::feedKey()
  std::vector<std::future<void>> opening_;
  bool stopped_ = false;
};

}  // namespace saccade
