// Changes of intensity of a scene, rendered once, for measurements of what comes behind the renderer.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/quantile.h"
#include "eval/bench/open_scene.h"
#include "methods/method_spec.h"

namespace saccade {

struct Recording {
  std::vector<IntensityChange> changes;  // of the frames after a warm-up
  double frame_ms;                       // CPU time of one of these frames, the median
  FeedConfig feed;                       // 346 x 260, with the default method
  std::unique_ptr<Feed> source;          // after the last frame
};

// A Feed of the default method at 346 x 260 pixels.
inline std::unique_ptr<Feed> openFeed(const std::string& scene_name, const std::string& trajectory,
                                      FeedConfig& feed, TilePool& pool) {
  feed.params = parseMethod(feed.method).params;
  const auto scene = eval::openScene(scene_name);
  feed.camera = pinhole(scene->description().fov_x_deg, 346, 260);
  return std::make_unique<Feed>(scene, eval::openTrajectory(scene_name, trajectory, *scene, feed), feed,
                                pool);
}

// One thread renders `warm_up` + `frames` frames.
inline Recording recordChanges(const std::string& scene_name, const std::string& trajectory, int warm_up,
                               int frames) {
  Recording r;
  TilePool pool(1);
  r.source = openFeed(scene_name, trajectory, r.feed, pool);
  std::vector<double> times;
  for (int i = 0; i < warm_up + frames; ++i) {
    const IntensityChange& change = r.source->step(pool);
    if (i < warm_up) continue;
    times.push_back(1e3 * seconds(r.source->lastTimes().total()));
    r.changes.emplace_back(r.feed.camera.width, r.feed.camera.height);
    r.changes.back().copyFrom(change);
  }
  r.frame_ms = quantile(times, 0.5);
  return r;
}

}  // namespace saccade
