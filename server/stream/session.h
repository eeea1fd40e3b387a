// One stream between its producer and the transports: its token, its packets and its state.
#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/queue_bounds.h"
#include "saccade/v1/control.pb.h"
#include "stream/change_notifier.h"
#include "stream/client_keys.h"
#include "stream/credit_queue.h"
#include "stream/large_packets.h"
#include "stream/traffic.h"
#include "stream/wake_fd.h"

namespace saccade {

inline constexpr std::string_view kTopicPrefix = "s/";  // of every topic; the stream's id follows

// All members may be called from any thread.
class Session {
 public:
  // `transport` is woken when there is something to send. `producer` is raised when started(), stopping(),
  // hasRoom() or settled() may have changed. Adds to `traffic`. `transport` and `traffic` must outlive the
  // session. `epoch`: of the server. `client`: adds the bytes that are sent to its counts, too.
  Session(std::string id, v1::Delivery delivery, std::uint32_t channels, WakeFd& transport,
          std::shared_ptr<ChangeNotifier> producer, Traffic& traffic, std::uint64_t queue_bytes = kQueueBytes,
          std::uint64_t epoch = 0, std::shared_ptr<ClientCounts> client = {});

  const std::string& id() const { return id_; }
  const std::string& token() const { return token_; }  // 128 random bits as hex digits
  bool hasToken(const std::string& token) const;       // takes as long for any wrong one
  bool broadcast() const { return delivery_ == v1::DELIVERY_BROADCAST; }
  std::uint32_t channels() const { return channels_; }  // sensors and truth channels
  std::uint64_t epoch() const { return epoch_; }
  std::string topic(std::uint32_t sensor) const;  // BROADCAST

  // Transports. start(): a receiver is there, the producer may begin. leave(): it has gone. The others are
  // those of CreditQueue.
  void start();
  void leave();
  bool sendOldest(const CreditQueue::Send& send);
  // The payload of a packet that is about to be sent; null where receivers hold too many large ones.
  auto lend(const WirePacket& packet) { return large_.lend(packet.payload); }
  void acknowledge(std::uint32_t sensor, std::uint64_t seq) { queue_.acknowledge(sensor, seq); }
  std::string resume(const std::vector<std::uint64_t>& from_seqs) { return queue_.resume(from_seqs); }
  Packet heartbeat(std::uint32_t sensor = 0) const;

  // Producer.
  bool started() const { return started_; }
  bool stopping() const { return stopping_; }
  bool hasRoom() const { return queue_.hasRoom(); }
  void makeRoom();  // before the packets of each frame
  void push(const Packet& packet);
  // For heartbeats: the newest frame, and how far the stream is behind its clock.
  void setProgress(std::uint64_t frame, std::int64_t t_ns);
  void setLag(std::chrono::milliseconds lag) { lag_ms_ = lag.count(); }
  v1::EndReason endReason() const { return end_reason_; }  // END_REASON_FINISHED unless stopping()
  void finish();  // END or ERROR has been pushed for every sensor; no packet follows

  // Owner. stop(): the producer ends the stream at the next frame. The first reason stands.
  void stop(v1::EndReason reason);
  bool finished() const { return finished_; }
  bool drained() const { return finished_ && queue_.empty(); }
  bool settled() const { return drained() || (finished_ && !has_receiver_); }  // nothing more can be sent
  v1::StreamState state() const;
  std::uint64_t droppedPackets() const { return queue_.droppedPackets(); }
  // Time since which the stream has had no receiver; nullopt while it has one, or one could still get
  // packets.
  std::optional<ChangeNotifier::Clock::time_point> unattended() const;

 private:
  void touch() { last_activity_ = ChangeNotifier::Clock::now(); }

  const std::string id_, token_;
  const v1::Delivery delivery_;
  const std::uint32_t channels_;
  const std::uint64_t epoch_;
  WakeFd& transport_;
  const std::shared_ptr<ChangeNotifier> producer_;
  Traffic& traffic_;
  const std::shared_ptr<ClientCounts> client_;  // may be null
  CreditQueue queue_;
  LargePackets large_;
  std::atomic<bool> started_ = false, has_receiver_ = false, stopping_ = false, finished_ = false;
  std::atomic<v1::EndReason> end_reason_ = v1::END_REASON_FINISHED;
  struct Progress {
    std::uint64_t frame = 0;
    std::int64_t t_ns = 0;
  };
  mutable std::mutex progress_mutex_;
  Progress progress_;
  std::atomic<std::int64_t> lag_ms_ = 0;
  std::atomic<ChangeNotifier::Clock::time_point> last_activity_;
};

// `count` bytes of the kernel's random numbers as hex digits.
std::string randomHex(int count);

}  // namespace saccade
