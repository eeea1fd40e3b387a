// Where a stream leaves its feed: its sensors, and the session that takes their packets.
#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "app/eye.h"
#include "base/recent_mean.h"
#include "base/tile_pool.h"
#include "stream/session.h"

namespace saccade {

class Outlet {
 public:
  Outlet(std::shared_ptr<Session> session, const ResolvedStream& stream, std::uint64_t epoch);

  const Session& session() const { return *session_; }
  bool catchingUp() const;  // nothing has come yet of what its client wants; on the feed's thread
  // From any thread.
  std::uint64_t events() const { return events_; }
  double recentSeconds() const { return recent_s_; }  // of CPU time for an interval

  // The feed's thread only. publish() takes every interval from the stream's first on, in order, and returns
  // the CPU time of its eyes. `frame` is the index of the frame at t.
  std::chrono::nanoseconds publish(const IntensityChange& change, TilePool& pool);
  void end(TimeNs t, FrameIndex frame);
  void fail(const std::string& message);

 private:
  void push(std::vector<Packet> packets);

  const std::shared_ptr<Session> session_;
  std::vector<Eye> eyes_;
  std::atomic<std::uint64_t> events_ = 0;
  RecentMean cost_s_;
  std::atomic<double> recent_s_ = 0;  // its value
};

}  // namespace saccade
