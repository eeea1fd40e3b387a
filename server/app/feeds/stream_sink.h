// The output of a stream: its channels, and the session that takes their packets.
#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "app/sequence/channel.h"
#include "base/recent_mean.h"
#include "stream/session.h"

namespace saccade {

class StreamSink {
 public:
  // `user`: the key of its client, for the log.
  StreamSink(std::shared_ptr<Session> session, const ResolvedStream& stream, std::uint64_t epoch,
             std::string user = {});

  // From any thread.
  const Session& session() const { return *session_; }
  const std::string& user() const { return user_; }
  std::uint64_t events() const { return events_; }
  double recentSeconds() const { return recent_s_; }          // CPU time per frame, recent mean
  double recentLongestSeconds() const { return longest_s_; }  // of the channel that takes longest

  SensorSchedule& schedule(std::size_t sensor) const { return *channels_[sensor]->schedule(); }

  // For each interval, in order: process() of each channel, on any threads, then publish() on the feed's
  // thread. `lag` is how far a PACED stream is behind its clock; 0 where that is too little to tell.
  std::size_t channels() const { return channels_.size(); }
  std::size_t view(std::size_t channel) const { return channels_[channel]->view(); }
  void process(std::size_t channel, const FeedInterval& interval) {
    channels_[channel]->process(interval, packet_per_frame_);
  }
  void publish(const FeedInterval& interval, std::chrono::milliseconds lag);

  // On the feed's thread. `frame` is the index of the frame at t.
  bool catchingUp() const;               // no event is for the client yet
  void clearLag();                       // until the next publish()
  void end(TimeNs t, FrameIndex frame);  // after process() of all channels, or of some
  // Sends what is left, and an ERROR, as far as that is possible. Returns whether it was.
  bool fail(const char* message) noexcept;

 private:
  void deliver();
  void push(std::vector<Packet> packets);
  void pushError(std::uint32_t channel, const std::string& message);
  void countCost(bool ends_frame);

  const std::shared_ptr<Session> session_;
  std::vector<std::unique_ptr<Channel>> channels_;
  const std::size_t sensors_;  // the first of them
  const bool packet_per_frame_;
  const std::string user_;
  std::chrono::milliseconds lag_{0};
  std::atomic<std::uint64_t> events_ = 0;
  std::chrono::nanoseconds frame_cost_{0}, frame_longest_{0};  // of the frame that is under way
  RecentMean cost_mean_, longest_mean_;
  std::atomic<double> recent_s_ = 0, longest_s_ = 0;  // for other threads
};

}  // namespace saccade
