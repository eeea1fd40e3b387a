// Measures the times that tables/time_model.h needs beside those of a Bench.
#pragma once

#include <span>

#include "eval/bench/bench.h"
#include "tables/time_model.h"

namespace saccade::eval {

class TimeBench {
 public:
  // For tables of `setup`: at half its width and height, and over kLateFrames times its frames.
  TimeBench(const BenchSetup& setup, std::shared_ptr<const RenderScene> scene, TilePool& pool);

  // All but first_ms. Throws Interrupted.
  MeasuredTime run(const MethodSpec& method, int spp) const;
  // The same of times of frames, of which there are more than `setup.last`.
  MeasuredTime meansOf(std::span<const double> frame_ms) const;

 private:
  std::size_t frames_;  // of the table
  double scaled_;       // a quarter of its pixels over those of bench_
  Bench bench_;
};

}  // namespace saccade::eval
