// An event model turns the brightness change of each interval into events. It holds the state of the pixels.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/units.h"
#include "events/pieces.h"
#include "events/sensor_config.h"
#include "frame/image.h"
#include "saccade/wire/event.h"

namespace saccade {

// [t0, t1), t0 < t1, both multiples of kEventTimeUnit; `frame` is the frame at t1.
struct Interval {
  TimeNs t0, t1;
  FrameIndex frame;
};

class EventModel {
 public:
  virtual ~EventModel() = default;
  // Before each interval: the intensities at its end, which outlive it. Only a model that depends on light
  // looks.
  virtual void see(const ImageF& /*I_now*/) {}
  // Appends the events of an interval, all times in [t0, t1). Order: row by row, pixel by pixel, then by
  // time; OFF first where times are equal. `dL`: change of log brightness over the interval, finite, with a
  // border of 0. Returns how many events were withheld.
  virtual std::uint64_t generate(const ImageF& dL, const Interval& interval, Events& events) = 0;

  // An interval whose log brightness is straight in pieces takes begin(), advance() until t1 is near, then
  // end(). The events are in the order of the pieces. `dL`: the change of the last piece of each pixel. It
  // begins at the share `from` of the interval, 0 <= from < 1, and ends at t1.
  virtual void begin(const Interval& interval, Events& events) = 0;
  virtual void advance(const Pieces& pieces, Events& events) = 0;
  virtual std::uint64_t end(const ImageF& dL, const ImageF& from, Events& events) = 0;

  // From the next interval on. A pixel whose level lies outside the new thresholds makes one event there at
  // once, and takes the level that it sees as its reference.
  virtual void setThresholds(const SensorConfig& config) = 0;
  // Log brightness of pixel (x, y) minus the reference of its next event; 0 for a model without a reference.
  virtual float level(int x, int y) const = 0;
};

struct EventModelInfo {
  std::string name, description;
  std::unique_ptr<EventModel> (*make)(const SensorConfig& config, int width, int height);
};

// THE list of event models. The first is the default.
const std::vector<EventModelInfo>& eventModelTable();
const EventModelInfo* findEventModel(const std::string& name);  // nullptr if there is none
std::string eventModelNames();                                  // "accumulating, ..." for messages

}  // namespace saccade
