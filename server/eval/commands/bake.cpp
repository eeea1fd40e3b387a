// `saccade-eval bake` computes the light of a scene ahead.
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "base/default_cache.h"
#include "base/new_folder.h"
#include "base/number_in.h"
#include "eval/bench/feed_options.h"
#include "eval/bench/interrupt.h"
#include "eval/bench/kept_bake.h"
#include "eval/bench/open_scene.h"
#include "eval/commands/commands.h"
#include "feed/bake_file.h"
#include "saccade/wire/ranges.h"

namespace saccade::eval {
namespace {

struct BakeOptions : FeedOptions {
  FrameIndex frames = 0;
  double error = 0.02;
  int memory = BakePlan().memory;
  std::string output = defaultCache();
};

void print(const BakePlan& plan, const Bake& bake, const std::string& path) {
  std::printf("wrote %s: %zu poses, %zu vertices, digest %016llx\n", path.c_str(), plan.poses.size(),
              bake.light->vertices(), static_cast<unsigned long long>(bake.digest));
  if (bake.poses < plan.poses.size())
    std::printf("memory sufficed for the first %zu poses; the others start without it\n", bake.poses);
  if (bake.full) std::printf("memory sufficed for a part of the surface between the pixels\n");
  std::printf("the error is %g or less at %.2f %% of the pixels, after %d passes\n",
              static_cast<double>(plan.error), 100 * bake.known, bake.passes);
}

void runBake(BakeOptions& o) {
  const auto [scene, path] = open(o);
  BakePlan plan = planBake(*scene, path, o.feed, o.frames, o.error);
  plan.memory = o.memory;
  TilePool pool(o.threads);
  watchInterrupt();
  try {
    print(plan, keptBake(scene, plan, o.output, sceneName(o.scene), pool),
          bakePath(o.output, digestOf(*scene, plan)));
  } catch (const Interrupted&) {
    throw std::runtime_error("interrupted; the same command continues where it stopped");
  }
}

}  // namespace

void addBakeCommand(CLI::App& app) {
  auto o = std::make_shared<BakeOptions>();
  auto* c = app.add_subcommand("bake",
                               "compute the light of a scene ahead, for irradiance_cache; after an "
                               "interruption the same command continues");
  addFeedOptions(*c, *o);
  c->add_option("--frames", o->frames,
                "the last frame; 0: all until the camera stands, one period, or a minute")
      ->check(NumberIn(0, 1 << 30))
      ->capture_default_str();
  c->add_option("--error", o->error, "relative error of the light of about a pixel")
      ->check(NumberIn(ranges::kBakeError.min, ranges::kBakeError.max))
      ->capture_default_str();
  c->add_option("--memory", o->memory, "MiB of the grid while it is made")
      ->check(NumberIn(1, 65536))
      ->capture_default_str();
  c->add_option("-o,--output", o->output, "folder for the bake; --cache of the other commands names it")
      ->check(CLI::Validator(newFolderFault, ""))
      ->capture_default_str();
  c->callback([o] { runBake(*o); });
}

}  // namespace saccade::eval
