// Where a stream leaves its feed: its sensors, and the session that takes their packets.
#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "app/streams/sensor_channel.h"
#include "base/recent_mean.h"
#include "stream/session.h"

namespace saccade {

class StreamSink {
 public:
  StreamSink(std::shared_ptr<Session> session, const ResolvedStream& stream, std::uint64_t epoch);

  const Session& session() const { return *session_; }
  bool catchingUp() const;  // nothing has come yet of what its client wants; on the feed's thread
  // From any thread.
  std::uint64_t events() const { return events_; }
  double recentSeconds() const { return recent_s_; }          // of CPU time for an interval
  double recentLongestSeconds() const { return longest_s_; }  // of the sensor that takes longest

  // An interval: each channel looks at it, on any threads; then the feed's thread publishes what they saw.
  // Every interval from the stream's first on, in order. `lag`: how far a PACED stream is behind its clock,
  // where that is worth telling.
  std::size_t channels() const { return channels_.size(); }
  void look(std::size_t channel, const IntensityChange& change) { channels_[channel].look(change); }
  void publish(const IntensityChange& change, std::chrono::milliseconds lag);

  // The feed's thread only. `frame` is the index of the frame at t.
  void hold();  // until the next interval the clock stands still
  void end(TimeNs t, FrameIndex frame);
  void fail(const char* message) noexcept;  // tells what can be told

 private:
  void push(std::vector<Packet> packets);
  void pushError(std::uint32_t sensor, const std::string& message);
  void countCost();

  const std::shared_ptr<Session> session_;
  std::vector<SensorChannel> channels_;
  std::chrono::milliseconds lag_{0};
  std::atomic<std::uint64_t> events_ = 0;
  RecentMean cost_mean_, longest_mean_;
  std::atomic<double> recent_s_ = 0, longest_s_ = 0;  // their values
};

}  // namespace saccade
