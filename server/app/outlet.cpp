#include "app/outlet.h"

namespace saccade {

Outlet::Outlet(std::shared_ptr<Session> session, const std::vector<SensorConfig>& sensors, int width,
               int height, std::uint64_t epoch)
    : session_(std::move(session)) {
  PacketCutter::Source source{session_->id(), epoch, 0, static_cast<std::uint32_t>(width),
                              static_cast<std::uint32_t>(height)};
  for (const SensorConfig& config : sensors) {
    eyes_.push_back({Sensor(config, width, height), PacketCutter(source), {}});
    ++source.sensor;
  }
}

std::chrono::nanoseconds Outlet::publish(const IntensityChange& change, TilePool& pool) {
  const auto used = pool.run(static_cast<int>(eyes_.size()),
                             [&](int i) { eyes_[i].sensor.generate(change, eyes_[i].output); });
  for (Eye& eye : eyes_) {
    const PacketInterval interval{change.t0.count(), change.t1.count(), change.frame - 1,
                                  eye.output.suppressed};
    for (Packet& packet : eye.cutter.cut(eye.output.events, interval)) session_->push(std::move(packet));
    events_ += eye.output.events.size();
  }
  return used;
}

void Outlet::end(TimeNs t, FrameIndex frame) {
  for (Eye& eye : eyes_) session_->push(eye.cutter.end(t.count(), frame));
  session_->finish();
}

void Outlet::fail(const std::string& message) {
  for (std::uint32_t i = 0; i < session_->sensors(); ++i) {
    Packet packet = makeErrorPacket(session_->id(), message);
    packet.header.set_sensor(i);
    session_->push(std::move(packet));
  }
  session_->finish();
}

}  // namespace saccade
