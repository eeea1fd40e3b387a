#include "eval/bench/kept_bake.h"

#include "eval/bench/interrupt.h"
#include "eval/bench/progress.h"

namespace saccade::eval {

Bake keptBake(std::shared_ptr<const RenderScene> scene, const BakePlan& plan, const std::string& folder,
              const std::string& what, TilePool& pool) {
  Progress progress("bake of " + what, 1);
  double done = 0;
  return bake(std::move(scene), plan, folder, pool, [&](const Baker& baker) {
    progress.add(baker.share() - done);
    done = baker.share();
    if (interrupted()) throw Interrupted{};
  });
}

}  // namespace saccade::eval
