// The flags of commands that run a feed, or prepare one.
#pragma once

#include <memory>
#include <string>

#include "feed/feed.h"

namespace CLI {
class App;
}

namespace saccade::eval {

struct FeedOptions {
  std::string scene, trajectory = "right", size = "256x256";
  std::vector<std::string> objects;
  std::string animation;
  FeedConfig feed;
  int threads = hardwareThreads();
};

// Adds the scene and the flags, with what stands in `o` as their defaults.
void addFeedOptions(CLI::App& app, FeedOptions& o);

// Adds --bake, for commands that run methods.
void addBakeOption(CLI::App& app, double& error);

struct OpenedFeed {
  std::shared_ptr<const RenderScene> scene;
  Trajectory path;
};
// Opens what the flags name, and completes `o.feed` by it. Throws SceneError, CLI::ValidationError.
OpenedFeed open(FeedOptions& o);

}  // namespace saccade::eval
