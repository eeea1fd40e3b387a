// Runs methods on one scene and one camera path, and holds the truth for them.
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
  std::string scene = "cornell-box";      // a name or a path, see open_scene.h
  std::string trajectory = "right";       // likewise
  std::vector<std::string> objects = {};  // that move, see moving_objects.h
  std::string animation = {};             // see LoadOptions
  int width = 128, height = 128;
  double frame_rate_hz = 250;
  // > 0: a motion by name moves the images by this much (median at the start); this sets frame_rate_hz.
  // `right`, `forward` and `orbit` move on steadily, and pass their start at frame `last`. `shake` begins
  // there, and has this median over its period. 0: the trajectory is taken as it is.
  double px_per_frame = 0;
  int bounces = 3;
  bool jitter = false;        // of the methods; the truth is then the mean over the whole pixel
  bool mips = true;           // false: textures have only their finest level
  int first = 21, last = 21;  // the frames that are scored, 1 <= first <= last; the feed runs from 0
  int reference_spp = 4096;   // 0: no truth
  std::string cache;          // folder of reference frames, and of bakes
  double bake_error = 0;      // > 0: methods that take a bake get one of this error, over frames 0 to `last`
};

// The true change from one frame to the next, with its times.
struct Truth : ReferenceChange {
  RegionMap regions;
};

// Statistics of the scored frames.
struct BenchView {
  double surface = 1;       // the share of pixels that show one, in the frame with the least
  double px_per_frame = 0;  // median motion of the images of surfaces, into the last frame; 0: none in view
};

// The estimates of a method for the scored frames.
struct BenchRun {
  std::vector<IntensityChange> changes;  // one for each Truth
  std::vector<double> frame_ms;          // CPU time of frames 1, 2 and so on, tracing and filter
  double cpu_ms = 0;                     // its mean
  double trace_ms = 0;                   // of it, tracing
};

class Bench {
 public:
  // Opens the scene and renders the truth, with progress on stderr. Throws SceneError, Interrupted.
  Bench(const BenchSetup& setup, TilePool& pool);
  // On `scene`, which is open already; it has mips or not.
  Bench(const BenchSetup& setup, std::shared_ptr<const RenderScene> scene, TilePool& pool);
  // The camera of `other` on another scene with so many bounces, or with other jitter; renders the truth
  // anew.
  Bench(const Bench& other, std::shared_ptr<const RenderScene> scene, int bounces);
  Bench(const Bench& other, bool jitter);

  const BenchSetup& setup() const { return setup_; }
  const std::shared_ptr<const RenderScene>& scene() const { return scene_; }
  const std::vector<Truth>& truth() const { return truth_; }  // of frames first to last
  double referenceError() const;  // of the truth's dI, relative L1, mean over the frames
  double medianPxPerFrame() const { return median_px_; }  // of the images of surfaces, into the last frame
  BenchView view() const;                                 // renders features, and no truth
  Feed features() const;  // of the same frames, by a feed of the least cost, which is at frame 0
  // Passes the changes of all frames from 1 on to `each`, if given. Throws Interrupted.
  BenchRun run(const MethodSpec& method, int spp, std::uint64_t seed,
               const std::function<void(const IntensityChange&)>& each = {}) const;

 private:
  FeedConfig feedConfig() const;
  std::shared_ptr<const BakedLight> baked() const;
  void renderTruth();

  BenchSetup setup_;
  TilePool& pool_;
  std::shared_ptr<const RenderScene> scene_;
  Trajectory path_;
  std::vector<Truth> truth_;
  double median_px_ = 0;
  mutable std::shared_ptr<const BakedLight> baked_;  // from the first run on that takes it
};

}  // namespace saccade::eval
