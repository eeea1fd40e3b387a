#include "app/outlet.h"

#include <algorithm>
#include <utility>

namespace saccade {

Outlet::Outlet(std::shared_ptr<Session> session, const ResolvedStream& stream, std::uint64_t epoch)
    : session_(std::move(session)) {
  const int width = stream.feed.width, height = stream.feed.height;
  PacketCutter::Source source{.stream_id = session_->id(),
                              .epoch = epoch,
                              .width = static_cast<std::uint32_t>(width),
                              .height = static_cast<std::uint32_t>(height),
                              .codec = findCodec(stream.request.codec())};
  for (const SensorConfig& config : stream.sensors) {
    const auto& wish = stream.request.sensors(static_cast<int>(source.sensor));
    eyes_.push_back({Sensor(config, width, height), PacketCutter(source), wish.from_event(), {}});
    ++source.sensor;
  }
}

std::chrono::nanoseconds Outlet::publish(const IntensityChange& change, TilePool& pool) {
  if (!std::exchange(joined_, true)) join(change);
  const auto used = pool.run(static_cast<int>(eyes_.size()),
                             [&](int i) { eyes_[i].sensor.generate(change, eyes_[i].output); });
  for (Eye& eye : eyes_) {
    const PacketInterval interval{change.t0.count(), change.t1.count(), change.frame - 1,
                                  eye.output.suppressed};
    push(eye, eye.cutter.cut(eye.output.events, interval));
    eye.events += eye.output.events.size();
    events_ += eye.output.events.size();
  }
  session_->setProgress(change.frame, change.t1.count());
  return used;
}

bool Outlet::catchingUp() const {
  return std::any_of(eyes_.begin(), eyes_.end(), [](const Eye& eye) { return eye.events < eye.from_event; });
}

void Outlet::join(const IntensityChange& first) {
  const FrameIndex frame = first.frame - 1;
  if (frame == 0) return;
  for (Eye& eye : eyes_) {
    std::string planes = encodePlanes(eye.sensor.pixelsAtStart(first.I_prev));
    session_->push(eye.cutter.snapshot(first.t0.count(), frame, std::move(planes)));
  }
}

void Outlet::push(const Eye& eye, std::vector<Packet> packets) {
  for (Packet& packet : packets) {
    const v1::PacketHeader& header = packet.header;
    const std::uint64_t begin = header.first_event_index(), end = begin + header.count();
    const bool known = begin < eye.from_event && end <= eye.from_event && header.kind() == v1::KIND_EVENTS;
    if (!known) session_->push(std::move(packet));
  }
}

void Outlet::end(TimeNs t, FrameIndex frame) {
  for (Eye& eye : eyes_) push(eye, eye.cutter.end(t.count(), frame, session_->endReason()));
  session_->finish();
}

void Outlet::fail(const std::string& message) {
  for (std::uint32_t i = 0; i < session_->sensors(); ++i) {
    push(eyes_[i], eyes_[i].cutter.flush());
    Packet packet = makeErrorPacket(session_->id(), message);
    packet.header.set_sensor(i);
    session_->push(std::move(packet));
  }
  session_->finish();
}

}  // namespace saccade
