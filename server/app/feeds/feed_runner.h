// Runs a source of intervals on a thread of its own and hands each interval to the streams that share it.
//
// A stream takes part from the first frame after its receiver has attached until it is stopped; then it gets
// its END. Where all are stopped in the midst of a frame, channels that have made their part of it give it.
// The others end before it. A frame is made when its source is ready, some stream has a receiver, and every
// stream with a receiver has room. Frames keep the pace, except those that a resumed stream skips. One run of
// the pool serves the sensors of all streams.
#pragma once

#include <memory>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

#include "app/feeds/newest_interval.h"
#include "app/feeds/pace_clock.h"
#include "app/feeds/stream_sink.h"
#include "app/feeds/totals.h"
#include "base/recent_mean.h"
#include "feed/feed_facts.h"
#include "feed/interval_source.h"
#include "log/client_log.h"
#include "stream/change_notifier.h"

namespace saccade {

struct FeedPace {
  FrameIndex frames = 0;  // to render after frame 0; 0: until the last stream ends
  double speed = 0;       // stream seconds per second; 0: as fast as possible
};

struct FeedProgress {
  FrameIndex frames = 0;       // done, without frame 0
  double lag_s = 0;            // by how much the last interval missed its time; 0 without a pace
  StageTimes cpu;              // of all frames together
  RecentMean recent_s;         // CPU time for a frame, without its events
  RecentMean critical_path_s;  // the part of that time that more threads do not shorten
};

class FeedRunner {
 public:
  // Runs on `pool`, urgently while the feed keeps its pace. Adds to `totals`. Logs the ends of streams. All
  // three must outlive this. `facts`: for the answers to the clients that open streams.
  FeedRunner(std::shared_ptr<IntervalSource> source, const FeedPace& pace, TilePool& pool, Totals& totals,
             ClientLog& log, const FeedFacts& facts = {});
  ~FeedRunner();  // waits for the thread: all streams must be stopped, or the feed must have an end
  FeedRunner(const FeedRunner&) = delete;
  FeedRunner& operator=(const FeedRunner&) = delete;

  // Sessions raise this to wake the feed, and so does what makes the source ready.
  const std::shared_ptr<ChangeNotifier>& notifier() const { return notifier_; }
  // Adds a stream; the first one starts the thread. Returns false where the feed has ended.
  bool add(std::shared_ptr<StreamSink> sink);
  bool ending() const;  // whether all its streams are to stop
  // Ends the feed in the middle of its frame, if all its streams are to stop. From any thread.
  void interrupt();

  FeedProgress progress() const;
  const NewestInterval& newest() const { return newest_; }
  const FeedFacts& facts() const { return facts_; }

 private:
  void run();
  void fail(const char* message) noexcept;
  void logFault(const char* message) noexcept;
  bool gather();
  void admit();
  bool close();
  bool ready() const;
  bool needsAttention() const;
  bool allStopping() const;
  void step();
  PoolHandle pool() const;
  std::chrono::nanoseconds publish(const std::vector<FeedInterval>& views, double lag_s);
  const std::vector<FeedInterval>& makeIntervals();
  void holdClock();
  void endStopped();
  double waitUntilDue(TimeNs t);
  void record(const StageTimes& times, std::chrono::nanoseconds critical_path, double lag_s, bool ends_frame);
  void finish(StreamSink& sink);

  TilePool& pool_;
  const std::shared_ptr<IntervalSource> source_;
  const FeedPace pace_;
  Totals& totals_;
  ClientLog& log_;
  const FeedFacts facts_;
  const std::shared_ptr<ChangeNotifier> notifier_ = std::make_shared<ChangeNotifier>();
  NewestInterval newest_;

  // The feed's thread.
  std::vector<std::shared_ptr<StreamSink>> sinks_;  // changed under the mutex
  FrameIndex frame_ = 0;                            // the newest one
  TimeNs now_{0};                                   // the end of the last interval
  StageTimes frame_cpu_;                            // of the intervals of the frame that is under way
  std::chrono::nanoseconds frame_critical_path_{0};
  PaceClock clock_;
  ChangeNotifier::Clock::time_point began_ = ChangeNotifier::Clock::now();  // when frame 1 was begun

  mutable std::mutex mutex_;
  std::stop_source stop_;
  std::vector<std::shared_ptr<StreamSink>> newcomers_;
  FeedProgress progress_;
  bool ended_ = false;
  std::thread thread_;
};

}  // namespace saccade
