// One scene on one path, with its truth: what every method is run on and measured against.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "eval/bench/reference.h"
#include "eval/metrics/regions.h"
#include "feed/feed.h"
#include "methods/method_spec.h"

namespace saccade::eval {

struct BenchSetup {
  std::string scene = "cornell-box", trajectory = "right";
  int width = 128, height = 128;
  double frame_rate_hz = 250;
  // > 0: the motion `right` or `forward` goes on straight, passes its start at frame `last`, and moves the
  // images by this much (median at the start); frame_rate_hz is then chosen so. 0: the trajectory as it is.
  double px_per_frame = 0;
  int bounces = 3;
  bool jitter = false;        // of the methods; the truth is then the mean over the whole pixel
  bool mips = true;           // false: textures have their finest level alone
  int first = 21, last = 21;  // the frames that are scored, 1 <= first <= last; the feed runs from 0
  int reference_spp = 4096;   // 0: no truth
  std::string cache;          // folder of reference frames
};

// The change from one frame to the next, as it is, with its times.
struct Truth : ReferenceChange {
  RegionMap regions;
};

// What a method made of the scored frames.
struct BenchRun {
  std::vector<IntensityChange> changes;  // one for each Truth
  double cpu_ms = 0;                     // per frame, tracing and filter, mean over all frames from 1 on
  double trace_ms = 0;                   // of it, tracing
};

class Bench {
 public:
  // Opens the scene and renders the truth, with progress on stderr. Throws SceneError, Interrupted.
  Bench(const BenchSetup& setup, TilePool& pool);
  // The same camera on `scene` instead, with so many bounces, or with jitter, and its truth.
  Bench(const Bench& other, std::shared_ptr<const RenderScene> scene, int bounces);
  Bench(const Bench& other, bool jitter);

  const BenchSetup& setup() const { return setup_; }
  const std::shared_ptr<const RenderScene>& scene() const { return scene_; }
  const std::vector<Truth>& truth() const { return truth_; }  // of frames first to last
  double referenceError() const;  // of the truth's dI, relative L1, mean over the frames
  double medianPxPerFrame() const { return median_px_; }  // of the images of surfaces, into the last frame
  // `each`, where given, sees the changes of all frames from 1 on.
  BenchRun run(const MethodSpec& method, int spp, std::uint64_t seed,
               const std::function<void(const IntensityChange&)>& each = {}) const;

 private:
  FeedConfig feedConfig() const;
  void renderTruth();

  BenchSetup setup_;
  TilePool& pool_;
  std::shared_ptr<const RenderScene> scene_;
  Trajectory path_;
  std::vector<Truth> truth_;
  double median_px_ = 0;
};

}  // namespace saccade::eval
