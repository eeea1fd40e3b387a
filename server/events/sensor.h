// A sensor turns changes of intensity into events: bias, reconstruction, event model, noise, readout.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "events/brightness_pieces.h"
#include "events/event_model.h"
#include "events/noise/arbiter.h"
#include "events/noise/dead_pixels.h"
#include "events/noise/jitter.h"
#include "events/noise/level_leak.h"
#include "events/noise/noise_source.h"
#include "events/noise/photoreceptor.h"
#include "events/path_lengths.h"
#include "events/reconstruction.h"
#include "events/sensor_config.h"
#include "events/time_order.h"
#include "frame/intensity_change.h"
#include "saccade/wire/event.h"
#include "saccade/wire/planes.h"

namespace saccade {

struct SensorOutput {
  // Of [t0, t1), in time order. Ties: those of the signal by row, column, polarity, then those of noise. With
  // jitter, a readout_hz or updates inside the interval, ties are in no order.
  Events events;
  std::uint64_t suppressed = 0;       // of this interval, withheld by refractory period, bound or readout
  std::uint64_t artefacts = 0;        // of them, by max_artefact_odds
  std::uint64_t lost_in_readout = 0;  // of them, by the readout
};

class Sensor {
 public:
  // `config` has no fault; 1 <= width, height <= 65535.
  Sensor(const SensorConfig& config, int width, int height);

  // The state of the pixels before the first interval, row by row. `I_prev`: of the first change.
  PixelState pixelsAtStart(const ImageF& I_prev) const;

  // Takes new settings for the next interval; its time has no effect here. The new configuration has no
  // fault. A change of the bias moves the references of the pixels along, and makes no event. A change of the
  // noise keeps the state of the pixels, what the photoreceptor lags behind, and what waits for the readout.
  void change(const SensorChange& change);

  // Makes the events of an interval. Call it for every interval, in order. Overwrites `out`, reusing its
  // storage.
  void generate(const IntensityChange& change, SensorOutput& out);

 private:
  // Both move the pixels by the response of `change`, which is in dL_. They return how many events they
  // withheld. They leave in dL_ what judge() takes.
  std::uint64_t moveStraight(const IntensityChange& change, const Interval& interval, Events& events);
  std::uint64_t moveInPieces(const IntensityChange& change, const Interval& interval, Events& events);
  bool judges() const;
  void judge(const IntensityChange& change, SensorOutput& out);
  void addNoise(const IntensityChange& change, SensorOutput& out);
  void readOut(const Interval& interval, SensorOutput& out);
  void setNoise();  // that of config_
  // Added to the intensity before the logarithm: I_eps and the dark current.
  double bias() const { return config_.bias + config_.noise.dark_luminance; }

  SensorConfig config_;
  ImageF dL_;  // [E (21)], then as reconstructed
  std::unique_ptr<Reconstruction> reconstruction_;
  std::unique_ptr<EventModel> model_;
  TimeOrder order_;
  // Once an interval has updates; the lengths where odds are asked for.
  std::optional<BrightnessPieces> pieces_;
  std::optional<PathLengths> lengths_;
  // The parts of noise that are on.
  std::optional<Photoreceptor> photoreceptor_;
  std::optional<LevelLeak> level_leak_;
  std::vector<std::unique_ptr<NoiseSource>> noise_sources_;
  std::optional<DeadPixels> dead_pixels_;
  std::optional<Jitter> jitter_;
  std::optional<Arbiter> arbiter_;
};

}  // namespace saccade
