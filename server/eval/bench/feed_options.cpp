#include "eval/bench/feed_options.h"

#include <CLI/CLI.hpp>

#include "base/number_in.h"
#include "eval/bench/arguments.h"
#include "eval/bench/open_scene.h"
#include "saccade/wire/ranges.h"

namespace saccade::eval {

void addFeedOptions(CLI::App& app, FeedOptions& o) {
  app.add_option("scene", o.scene, "a scene by name, or by the path of its file or folder")->required();
  app.add_option(kTrajectoryFlag, o.trajectory, trajectoryHelp())
      ->check(readBy(checkMotion))
      ->capture_default_str();
  addObjectOption(app, o.objects);
  addAnimationOption(app, o.animation);
  app.add_option("--size", o.size, "WIDTHxHEIGHT, pixels")->capture_default_str();
  app.add_option("--rate", o.feed.frame_rate_hz, "frames per second")
      ->check(NumberIn(ranges::kFrameRate.min, ranges::kFrameRate.max))
      ->capture_default_str();
  app.add_option("--bounces", o.feed.bounces, "indirect bounces")
      ->check(NumberIn(ranges::kBounces.min, ranges::kBounces.max))
      ->capture_default_str();
  app.add_option("--threads", o.threads, "threads that render")
      ->check(NumberIn(1, 1024))
      ->capture_default_str();
}

void addBakeOption(CLI::App& app, double& error) {
  app.add_option("--bake", error,
                 "compute light ahead to this relative error, for methods that can use it; the bake is kept "
                 "beside the reference frames")
      ->check(NumberIn(ranges::kBakeError.min, ranges::kBakeError.max));
}

OpenedFeed open(FeedOptions& o) {
  const Size size = parseSize(o.size);
  const auto objects = parseObjects(o.objects);
  auto scene = openMovingScene(o.scene, objects, o.animation);
  o.feed.camera = pinhole(scene->description().fov_x_deg, size.width, size.height);
  o.feed.body_paths = openPaths(scene->description(), objects, o.feed.frame_rate_hz);
  Trajectory path = openTrajectory(o.scene, o.trajectory, *scene, o.feed);
  return {std::move(scene), std::move(path)};
}

}  // namespace saccade::eval
