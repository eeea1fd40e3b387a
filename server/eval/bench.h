// One scene on one path, with its truth: what every method is run on and measured against.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/feed.h"
#include "eval/reference.h"

namespace saccade {

struct BenchSetup {
  std::string scene = "cornell-box", trajectory = "right";
  int width = 128, height = 128;
  double frame_rate_hz = 500;
  int bounces = 3;
  int frame = 21;  // the one that is scored; the feed runs from 0
  int reference_spp = 4096;
  std::string cache;  // folder of reference frames
};

// What a method made of the scored frame.
struct BenchRun {
  BenchRun(int width, int height) : change(width, height) {}
  IntensityChange change;
  double cpu_ms = 0;    // per frame, tracing and filter
  double trace_ms = 0;  // of it, tracing
};

class Bench {
 public:
  // Opens the scene and renders the truth, with progress on stderr. Throws SceneError, Interrupted.
  Bench(const BenchSetup& setup, TilePool& pool);

  const BenchSetup& setup() const { return setup_; }
  const ReferenceChange& truth() const { return *truth_; }
  BenchRun run(const std::string& method, int spp, const ParamValues& params, std::uint64_t seed) const;

 private:
  BenchSetup setup_;
  TilePool& pool_;
  std::shared_ptr<const RenderScene> scene_;
  Trajectory path_;
  std::unique_ptr<ReferenceChange> truth_;
};

}  // namespace saccade
