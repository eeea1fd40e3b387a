#include "stream/session.h"

#include <sys/random.h>

#include <cerrno>
#include <system_error>
#include <vector>

namespace saccade {

std::string randomHex(int count) {
  std::vector<unsigned char> bytes(count);
  // Up to 256 bytes come whole or not at all.
  if (getrandom(bytes.data(), bytes.size(), 0) != count) {
    throw std::system_error(errno, std::generic_category(), "getrandom");
  }
  std::string hex;
  for (unsigned char byte : bytes) {
    for (int digit : {byte >> 4, byte & 15}) hex += "0123456789abcdef"[digit];
  }
  return hex;
}

Session::Session(std::string id, v1::Delivery delivery, std::uint32_t channels, WakeFd& transport,
                 std::shared_ptr<ChangeNotifier> producer, Traffic& traffic, std::uint64_t queue_bytes,
                 std::uint64_t epoch, std::shared_ptr<ClientCounts> client)
    : id_(std::move(id)),
      token_(randomHex(16)),
      delivery_(delivery),
      channels_(channels),
      epoch_(epoch),
      transport_(transport),
      producer_(std::move(producer)),
      traffic_(traffic),
      client_(std::move(client)),
      queue_(
          delivery == v1::DELIVERY_LIVE ? CreditQueue::Overflow::kDropOldest : CreditQueue::Overflow::kHold,
          queue_bytes, channels) {
  touch();
}

bool Session::hasToken(const std::string& token) const {
  if (token.size() != token_.size()) return false;
  int difference = 0;
  for (std::size_t i = 0; i < token.size(); ++i) difference |= token[i] ^ token_[i];
  return difference == 0;
}

std::string Session::topic(std::uint32_t sensor) const {
  return std::string(kTopicPrefix) + id_ + "/" + std::to_string(sensor) + "/";
}

void Session::start() {
  started_ = has_receiver_ = true;
  touch();
  producer_->raise();
}

void Session::leave() {
  touch();
  has_receiver_ = false;
  producer_->raise();
}

bool Session::sendOldest(const CreditQueue::Send& send) {
  std::uint64_t bytes = 0;
  const auto count = [&](const WirePacket& packet) {
    bytes = packet.bytes();
    return send(packet);
  };
  if (!queue_.sendOldest(count)) return false;
  traffic_.packets += 1;
  traffic_.bytes += bytes;
  if (client_) client_->sent_bytes += bytes;
  if (has_receiver_) touch();
  producer_->raise();
  return true;
}

v1::StreamState Session::state() const {
  if (finished_) return v1::STREAM_STATE_ENDED;
  if (!started_) return v1::STREAM_STATE_WAITING;
  return has_receiver_ ? v1::STREAM_STATE_RUNNING : v1::STREAM_STATE_LEFT;
}

std::optional<ChangeNotifier::Clock::time_point> Session::unattended() const {
  if (has_receiver_ && !drained()) return std::nullopt;
  return last_activity_;
}

Packet Session::heartbeat(std::uint32_t sensor) const {
  v1::PacketHeader header;
  header.set_stream_id(id_);
  header.set_sensor(sensor);
  header.set_kind(v1::KIND_HEARTBEAT);
  header.set_epoch(epoch_);
  std::unique_lock lock(progress_mutex_);
  header.set_frame(progress_.frame);
  header.set_t0_ns(progress_.t_ns);
  lock.unlock();
  header.set_t1_ns(header.t0_ns());
  header.set_lag_ms(static_cast<std::uint64_t>(lag_ms_));
  return sealPacket(std::move(header), {});
}

void Session::makeRoom() {
  traffic_.dropped_packets += queue_.makeRoom();
}

void Session::push(const Packet& packet) {
  queue_.push(packet);
  transport_.wake();
}

void Session::setProgress(std::uint64_t frame, std::int64_t t_ns) {
  std::lock_guard lock(progress_mutex_);
  progress_ = {frame, t_ns};
}

void Session::finish() {
  finished_ = true;
  touch();
  producer_->raise();
  transport_.wake();
}

void Session::stop(v1::EndReason reason) {
  auto unstopped = v1::END_REASON_FINISHED;
  end_reason_.compare_exchange_strong(unstopped, reason);
  stopping_ = true;
  producer_->raise();
}

}  // namespace saccade
