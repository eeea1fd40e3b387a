// A sensor turns changes of intensity into events: threshold, bias, event model, refractory period.
#pragma once

#include <cstdint>
#include <memory>

#include "base/units.h"
#include "events/event_model.h"
#include "frame/intensity_change.h"
#include "wire/event.h"

namespace saccade {

struct SensorConfig {
  double threshold = 0.2;      // C+ > 0, natural log units; ON events
  double threshold_off = 0.2;  // C- > 0; OFF events
  double bias = 1e-3;          // I_eps > 0, scene luminance [E (1)]
  std::string model = "accumulating";  // a name of eventModelTable()
  TimeNs refractory{0};        // >= 0; after an event the pixel is blind so long, then starts from the level it sees
  int max_events_per_pixel_frame = 32;  // >= 1; what exceeds it is suppressed and counted
  std::uint64_t seed = 0;      // start phase of every pixel; random numbers of the model
};

struct SensorOutput {
  Events events;                 // of [t0, t1), in time order; ties by row, column, polarity
  std::uint64_t suppressed = 0;  // crossings of this interval withheld by refractory period or bound
};

class Sensor {
 public:
  Sensor(const SensorConfig& config, int width, int height);
  ~Sensor();
  Sensor(Sensor&&) noexcept;

  // Must be given every interval, in order. `out` is overwritten; its storage is reused.
  void generate(const IntensityChange& change, SensorOutput& out);

 private:
  SensorConfig config_;
  ImageF dL_;
  std::unique_ptr<EventModel> model_;
  std::vector<std::uint64_t> order_;  // scratch of the time sort
};

}  // namespace saccade
