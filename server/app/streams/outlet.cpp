#include "app/streams/outlet.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <utility>

namespace saccade {
namespace {

// Where memory is out, the next step may still find some.
template <class F>
void attempt(const F& step) noexcept {
  try {
    step();
  } catch (const std::exception& fault) {
    spdlog::error("a stream that fails cannot be told so: {}", fault.what());
  }
}

}  // namespace

Outlet::Outlet(std::shared_ptr<Session> session, const ResolvedStream& stream, std::uint64_t epoch)
    : session_(std::move(session)), eyes_(makeEyes(stream, session_->id(), epoch)) {}

void Outlet::publish(const IntensityChange& change, std::chrono::milliseconds lag) {
  lag_ = lag;
  session_->setLag(lag);
  std::uint64_t events = 0;
  for (Eye& eye : eyes_) {
    push(eye.takePackets());
    events += eye.events();
  }
  events_ = events;
  countCost();
  session_->setProgress(change.frame, change.t1.count());
}

void Outlet::countCost() {
  std::chrono::nanoseconds sum{0}, longest{0};
  for (const Eye& eye : eyes_) {
    sum += eye.cost();
    longest = std::max(longest, eye.cost());
  }
  cost_mean_.add(seconds(sum));
  longest_mean_.add(seconds(longest));
  recent_s_ = cost_mean_.value();
  longest_s_ = longest_mean_.value();
}

void Outlet::hold() {
  session_->setLag(lag_ = {});
}

bool Outlet::catchingUp() const {
  return std::any_of(eyes_.begin(), eyes_.end(), [](const Eye& eye) { return eye.catchingUp(); });
}

void Outlet::push(std::vector<Packet> packets) {
  for (Packet& packet : packets) {
    packet.header.set_lag_ms(static_cast<std::uint64_t>(lag_.count()));
    session_->push(packet);
  }
}

void Outlet::end(TimeNs t, FrameIndex frame) {
  for (Eye& eye : eyes_) push(eye.end(t, frame, session_->endReason()));
  session_->finish();
}

void Outlet::fail(const char* message) noexcept {
  for (std::uint32_t i = 0; i < session_->sensors(); ++i) {
    attempt([&] { push(eyes_[i].flush()); });
    attempt([&] { pushError(i, message); });
  }
  session_->finish();
}

void Outlet::pushError(std::uint32_t sensor, const std::string& message) {
  Packet packet = makeErrorPacket(session_->id(), message, session_->epoch());
  packet.header.set_sensor(sensor);
  session_->push(packet);
}

}  // namespace saccade
