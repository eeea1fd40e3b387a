// Runs a feed on a thread of its own and hands each interval to the streams that look at it.
//
// A stream takes part from the first frame after its receiver has come until it is stopped, and then gets its
// END. Frames are rendered while at least one stream has a receiver, and none is without room; at their pace,
// but for those that a stream is not to get. The sensors of all streams look at a frame in one run of the
// pool.
#pragma once

#include <memory>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

#include "app/streams/frame_picture.h"
#include "app/streams/stream_sink.h"
#include "app/streams/totals.h"
#include "base/recent_mean.h"
#include "feed/feed.h"
#include "feed/pixel_speed.h"
#include "stream/change_notifier.h"

namespace saccade {

struct FeedPace {
  FrameIndex frames = 0;     // intervals to render; 0: while anyone looks
  double frame_rate_hz = 0;  // > 0
  double speed = 0;          // stream seconds per second; 0: as fast as possible
};

struct FeedProgress {
  FrameIndex frames = 0;  // intervals done
  double lag_s = 0;       // how far the last one came after it was due; 0 without a pace
  StageTimes cpu;         // of all intervals together
  RecentMean recent_s;    // CPU time for an interval, but for events
  RecentMean chain_s;     // the part of an interval that does not become shorter by more threads
};

class FeedRunner {
 public:
  // `pool`: that of `feed`, and of no other: it is urgent while the feed is at its pace. Keeps a reference to
  // `totals`, which it adds to.
  FeedRunner(std::unique_ptr<Feed> feed, int width, int height, const FeedPace& pace,
             std::shared_ptr<TilePool> pool, Totals& totals);
  ~FeedRunner();  // its streams must be stopped, or the feed must have an end
  FeedRunner(const FeedRunner&) = delete;
  FeedRunner& operator=(const FeedRunner&) = delete;

  // What sessions raise for this feed.
  const std::shared_ptr<ChangeNotifier>& notifier() const { return notifier_; }
  // False: the feed has ended. The first sink starts the thread.
  bool add(std::shared_ptr<StreamSink> sink);
  // Where all streams are to stop, ends the feed amid its frame, which may take long. From any thread.
  void interrupt();

  FeedProgress progress() const;
  const FramePicture& snapshot() const { return picture_; }
  float luminanceP01() const { return luminance_p01_; }  // of frame 0
  float luminanceP50() const { return luminance_p50_; }
  const PixelSpeed& pixelSpeed() const { return pixel_speed_; }

 private:
  void run();
  void giveUp(const char* message) noexcept;
  bool gather();
  void admit();
  bool close();
  bool ready() const;
  bool needsCare() const;
  bool allStopping() const;
  void step();
  std::chrono::nanoseconds look(const IntensityChange& change, double lag_s);
  void hold();
  void endStopped();
  double waitUntilDue(TimeNs t);
  void record(const StageTimes& times, std::chrono::nanoseconds chain, double lag_s);
  void finish(StreamSink& sink);
  TimeNs now() const { return frameTime(frame_, pace_.frame_rate_hz); }

  const std::shared_ptr<TilePool> pool_;
  const std::unique_ptr<Feed> feed_;
  const FeedPace pace_;
  Totals& totals_;
  const std::shared_ptr<ChangeNotifier> notifier_ = std::make_shared<ChangeNotifier>();
  const float luminance_p01_, luminance_p50_;
  const PixelSpeed pixel_speed_;
  FramePicture picture_;

  // The feed's thread.
  std::vector<std::shared_ptr<StreamSink>> sinks_;  // changed under the mutex
  FrameIndex frame_ = 0;                            // the newest one
  bool running_ = false;                            // at its pace, since there was a reason not to
  ChangeNotifier::Clock::time_point began_ = ChangeNotifier::Clock::now();  // the first frame
  ChangeNotifier::Clock::time_point wall_zero_;  // when stream time 0 was due, by the pace

  mutable std::mutex mutex_;
  std::stop_source stop_;
  std::vector<std::shared_ptr<StreamSink>> newcomers_;
  FeedProgress progress_;
  bool ended_ = false;
  std::thread thread_;
};

}  // namespace saccade
