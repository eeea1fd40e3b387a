#include "app/outlet.h"

#include <algorithm>
#include <utility>

namespace saccade {

Outlet::Outlet(std::shared_ptr<Session> session, const ResolvedStream& stream, std::uint64_t epoch)
    : session_(std::move(session)), eyes_(makeEyes(stream, session_->id(), epoch)) {}

std::chrono::nanoseconds Outlet::publish(const IntensityChange& change, TilePool& pool) {
  const auto used = pool.run(static_cast<int>(eyes_.size()), [&](int i) { eyes_[i].look(change); });
  std::uint64_t events = 0;
  for (Eye& eye : eyes_) {
    push(eye.takePackets());
    events += eye.events();
  }
  events_ = events;
  cost_s_.add(seconds(used));
  recent_s_ = cost_s_.value();
  session_->setProgress(change.frame, change.t1.count());
  return used;
}

bool Outlet::catchingUp() const {
  return std::any_of(eyes_.begin(), eyes_.end(), [](const Eye& eye) { return eye.catchingUp(); });
}

void Outlet::push(std::vector<Packet> packets) {
  for (Packet& packet : packets) session_->push(std::move(packet));
}

void Outlet::end(TimeNs t, FrameIndex frame) {
  for (Eye& eye : eyes_) push(eye.end(t, frame, session_->endReason()));
  session_->finish();
}

void Outlet::fail(const std::string& message) {
  for (std::uint32_t i = 0; i < session_->sensors(); ++i) {
    push(eyes_[i].flush());
    Packet packet = makeErrorPacket(session_->id(), message, session_->epoch());
    packet.header.set_sensor(i);
    session_->push(std::move(packet));
  }
  session_->finish();
}

}  // namespace saccade
