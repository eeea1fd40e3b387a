// Cameras that stand, which every method that promises it shows without any change.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "feed/feed.h"

namespace saccade::test {

// All but those that draw new numbers for every frame, by their nature.
inline const std::vector<std::string> kMethodsWithoutGhosts{"irradiance_cache", "event_svgf", "relax",
                                                            "adaptive_denoising", "pt-correlated"};

// A scene with an object of each material that the reader of scenes knows.
struct MaterialScene {
  std::string name;
  std::string xml;
};
std::vector<MaterialScene> materialScenes();

struct Standing {
  std::shared_ptr<const RenderScene> scene;
  Trajectory path;
  FeedConfig config;
  int moving = 0, last = 6;  // frames that may change, and all of them, from 1 on
};

// Changes that a feed shows while its camera stands.
struct Ghosts {
  long changes = 0;  // values of dI and its variance that are not 0
  long events = 0;   // of a default sensor, but for its thresholds, which are as low as they may be
  long lit = 0;      // pixels of the last frame that are not black
};
Ghosts ghostsOf(Standing of, const std::string& method, TilePool& pool);

}  // namespace saccade::test
