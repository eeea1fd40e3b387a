// The changes of one sensor: those of the request, and those that its client asks for while the stream runs.
#pragma once

#include <mutex>
#include <vector>

#include "events/sensor_config.h"

namespace saccade {

// All members may be called from any thread.
class SensorSchedule {
 public:
  // `changes`: in order of time.
  explicit SensorSchedule(std::vector<SensorChange> changes) : changes_(std::move(changes)) {}

  // Adds a change, at the next interval where its time is over. Returns its time. Throws Refusal where there
  // are as many as a request may have.
  TimeNs add(SensorChange change);

  // For each interval, in order: what changes with it. Changes that begin with the same interval are one, so
  // that each interval costs one at most.
  std::optional<SensorChange> takeDue(TimeNs t0, TimeNs t1);

  std::vector<SensorChange> all() const;
  std::size_t size() const;  // of all()

 private:
  mutable std::mutex mutex_;
  std::vector<SensorChange> changes_;  // in order of time
  std::size_t done_ = 0;               // so many have been taken
  TimeNs next_{0};                     // where the next interval begins
};

}  // namespace saccade
