#include "app/sequence/sensor_schedule.h"

#include <algorithm>

#include "app/request/refusal.h"

namespace saccade {

TimeNs SensorSchedule::add(SensorChange change) {
  std::lock_guard lock(mutex_);
  if (changes_.size() >= static_cast<std::size_t>(ranges::kSensorChanges.max))
    refuse("change", "the sensor has " + std::to_string(changes_.size()) + " changes already");
  change.time = std::max(change.time, next_);
  const auto later = [](TimeNs t, const SensorChange& other) { return t < other.time; };
  changes_.insert(std::upper_bound(changes_.begin(), changes_.end(), change.time, later), change);
  return change.time;
}

std::optional<SensorChange> SensorSchedule::takeDue(TimeNs t0, TimeNs t1) {
  std::lock_guard lock(mutex_);
  std::optional<SensorChange> due;
  for (; done_ < changes_.size() && changes_[done_].time <= t0; ++done_)
    due = together(due.value_or(SensorChange{}), changes_[done_]);
  next_ = t1;
  return due;
}

std::vector<SensorChange> SensorSchedule::all() const {
  std::lock_guard lock(mutex_);
  return changes_;
}

std::size_t SensorSchedule::size() const {
  std::lock_guard lock(mutex_);
  return changes_.size();
}

}  // namespace saccade
