// A sensor turns changes of intensity into events: bias, reconstruction, event model.
#pragma once

#include <cstdint>
#include <memory>

#include "events/event_model.h"
#include "events/reconstruction.h"
#include "events/sensor_config.h"
#include "events/time_order.h"
#include "frame/intensity_change.h"
#include "wire/event.h"
#include "wire/planes.h"

namespace saccade {

struct SensorOutput {
  Events events;                 // of [t0, t1), in time order; ties by row, column, polarity
  std::uint64_t suppressed = 0;  // crossings of this interval withheld by refractory period or a bound
  std::uint64_t artefacts = 0;   // those withheld by max_artefact_odds
};

class Sensor {
 public:
  // `config` has no fault; 1 <= width, height <= 65535.
  Sensor(const SensorConfig& config, int width, int height);

  // The state of the pixels before the first interval, row by row. `I_prev`: of the first change.
  PixelState pixelsAtStart(const ImageF& I_prev) const;

  // Makes the events of an interval. Call it for every interval, in order. Overwrites `out`, reusing its
  // storage.
  void generate(const IntensityChange& change, SensorOutput& out);

 private:
  void judge(const IntensityChange& change, SensorOutput& out);

  float bias_;
  bool judges_;  // whether it has to know the odds of artefacts
  double max_artefact_odds_;
  ImageF dL_;  // [E (21)], then as reconstructed
  std::unique_ptr<Reconstruction> reconstruction_;
  std::unique_ptr<EventModel> model_;
  TimeOrder order_;
};

}  // namespace saccade
