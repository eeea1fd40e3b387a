#include "eval/bench/kept_bake.h"

#include <cstdio>

#include "eval/bench/interrupt.h"
#include "eval/bench/progress.h"

namespace saccade::eval {

Bake keptBake(std::shared_ptr<const RenderScene> scene, const BakePlan& plan, const std::string& folder,
              const std::string& what, TilePool& pool) {
  Progress progress("bake of " + what, 1);
  double done = 0;
  const auto after_pass = [&](const Baker& baker) {
    progress.add(baker.share() - done);
    done = baker.share();
    if (interrupted()) throw Interrupted{};
  };
  const auto warn = [](const std::string& fault) { std::fprintf(stderr, "%s\n", fault.c_str()); };
  return bake(std::move(scene), plan, folder, pool, after_pass, warn);
}

std::shared_ptr<const BakedLight> keptLight(std::shared_ptr<const RenderScene> scene, const Trajectory& path,
                                            const FeedConfig& feed, int frames, double error,
                                            const std::string& folder, const std::string& what,
                                            TilePool& pool) {
  const BakePlan plan = planBake(*scene, path, feed, static_cast<FrameIndex>(frames), error);
  return keptBake(std::move(scene), plan, folder, what, pool).light;
}

}  // namespace saccade::eval
