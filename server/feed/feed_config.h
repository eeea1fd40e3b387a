// The settings of a feed: camera, rate, method, quality.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "feed/interval_bounds.h"
#include "methods/method.h"
#include "scene/camera/lens.h"
#include "scene/camera/trajectory.h"

namespace saccade {

// How far pixels are refined within an interval, see refinement.h. Thresholds and biases: the least of all
// sensors of the feed.
struct RefinementSettings {
  double finest_px = 1. / 16;  // motion within the shortest pieces, pixels, > 0
  double threshold = 0.2;      // log brightness, > 0
  double bias = 1e-3;          // scene luminance, > 0
  // Of a pixel, in the mean over a tile. Where pieces would exceed it, those nearest to their lines stay
  // whole.
  double most_updates = 8;
  // Whether all shadow rays are traced at each moment. Otherwise those that KnownRays knows from the moments
  // around are left out.
  bool every_ray = false;
};

// Of an interval.
struct RefinementCounts {
  std::size_t samples = 0;  // look-ups
  std::size_t unsplit = 0;  // pieces that found no room among most_updates
  std::size_t rays = 0;     // shadow rays to lamps whose light has a closed form
};

struct FeedConfig {
  CameraModel camera = pinhole(45, 256, 256);
  double frame_rate_hz = 500;
  IntervalBounds intervals = {};                  // of a Rig
  std::string method = defaultMethod(true).name;  // of methodTable()
  ParamValues params;                             // resolved by resolveParams()
  int spp = 2;                                    // paths per pixel and frame over both passes
  int bounces = 3;                                // indirect bounces
  bool jitter = false;                            // RenderSettings::jitter
  bool monochrome = false;
  std::uint64_t seed = 0;
  std::vector<Trajectory> body_paths = {};            // of Scene::bodies, in their order
  std::shared_ptr<const BakedLight> baked = {};       // precomputed light of this scene; nullptr: none
  std::optional<RefinementSettings> refinement = {};  // none: a change has no updates

  double pixels() const { return static_cast<double>(camera.width) * camera.height; }
};

}  // namespace saccade
