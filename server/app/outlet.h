// Where a stream leaves its feed: its sensors, the packets they fill, its session.
#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "base/tile_pool.h"
#include "events/sensor.h"
#include "stream/session.h"
#include "wire/packet_cutter.h"

namespace saccade {

class Outlet {
 public:
  Outlet(std::shared_ptr<Session> session, const std::vector<SensorConfig>& sensors, int width, int height,
         std::uint64_t epoch);

  const Session& session() const { return *session_; }
  std::uint64_t events() const { return events_; }  // from any thread

  // The feed's thread only. publish() takes every interval from the stream's first on, in order, and returns
  // the CPU time of the sensors. `frame` is the index of the frame at t.
  std::chrono::nanoseconds publish(const IntensityChange& change, TilePool& pool);
  void end(TimeNs t, FrameIndex frame);
  void fail(const std::string& message);

 private:
  struct Eye {
    Sensor sensor;
    PacketCutter cutter;
    SensorOutput output;
  };
  const std::shared_ptr<Session> session_;
  std::vector<Eye> eyes_;
  std::atomic<std::uint64_t> events_ = 0;
};

}  // namespace saccade
