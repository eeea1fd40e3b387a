// Measures simplified models of one scene: the CPU time they save, and the events they change.
#pragma once

#include <vector>

#include "eval/bench/bench_options.h"
#include "eval/metrics/event_rates.h"
#include "tables/simplification_table.h"

namespace saccade::eval {

class ModelBench {
 public:
  // Renders the truth of the whole model, of o.setup.reference_spp paths, with progress on stderr. Times are
  // of `method` at `spp`. Throws SceneError, Interrupted.
  ModelBench(const BenchOptions& o, const MethodSpec& method, int spp, TilePool& pool);

  const Scene& description() const { return whole_.scene()->description(); }
  double events() const { return events_; }  // of the whole model, per pixel-frame
  // The share of events that other seeds change, at half of the paths. Models share their seeds, so that
  // noise changes fewer events between them.
  double noise() const { return noise_; }

  MeasuredModel whole() const;
  // The whole model with jitter: its CPU time and the events it changes. Throws Interrupted.
  MeasuredModel jittered() const;
  // Times each in turn with the whole model. Throws Interrupted.
  std::vector<MeasuredModel> measure(const std::vector<SceneModel>& models) const;

 private:
  struct Brightness {  // dL of a frame, and two independent halves of it
    Brightness(const Truth& truth, float bias);
    ImageF dL, half_a, half_b;
  };
  double share(const EventRates& rates) const;  // of the whole model's events
  void compare(const Bench& bench, MeasuredModel& model) const;
  double timeOf(const Bench& bench, int round) const;
  std::vector<double> relativeTimes(const std::vector<Bench>& benches) const;

  const MethodSpec method_;
  const int spp_;
  const float bias_;
  const double threshold_;
  const Bench whole_;
  std::vector<Brightness> frames_;  // of the whole model
  double events_ = 0, noise_ = 0, whole_ms_ = 0;
};

}  // namespace saccade::eval
