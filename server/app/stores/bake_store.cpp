#include "app/stores/bake_store.h"

#include "app/request/refusal.h"
#include "app/stores/bake_folder.h"
#include "feed/bake_file.h"
#include "render/world/render_scene.h"

namespace saccade {
namespace {

constexpr const char* kField = "quality.bake_error";

}  // namespace

std::shared_ptr<const Bake> BakeStore::get(const std::shared_ptr<const RenderScene>& scene,
                                           const BakePlan& plan, TilePool& pool, const std::stop_token& stop,
                                           const std::function<void(double)>& progress) {
  if (folder_.empty()) throw Refusal(v1::CODE_UNAVAILABLE, kField, "this server keeps no bakes");
  const Digest digest = digestOf(*scene, plan);
  const auto build = [=, this, &pool](const BuildContext& context) {
    if (auto bake = find(digest)) return bake;
    const auto making = admit(digest, plan.memory);
    const BakePtr bake = make(scene, plan, digest, pool, context);
    std::lock_guard lock(mutex_);
    kept_[digest].bake = bake;
    return bake;
  };
  return builds_.get(digest, stop, build, progress);
}

// Null: no stream uses it.
BakeStore::BakePtr BakeStore::find(Digest digest) {
  std::lock_guard lock(mutex_);
  const auto found = kept_.find(digest);
  return found == kept_.end() ? nullptr : found->second.bake.lock();
}

// Counts a bake that is about to be made while the result is held. Throws LimitReached where there is no
// memory for one more.
std::shared_ptr<const void> BakeStore::admit(Digest digest, int mib) {
  std::lock_guard lock(mutex_);
  std::erase_if(kept_, [](const auto& entry) { return entry.second.gone(); });
  double taken = mib;
  for (const auto& [other, kept] : kept_) taken += kept.mib;
  if (taken > limits_[Limit::kBakes])
    throw LimitReached(Limit::kBakes, kField, "other bakes are in use or being made", kRetrySeconds);
  const auto making = std::make_shared<const int>();
  kept_[digest] = {making, {}, mib};
  return making;
}

double BakeStore::inUse() const {
  std::lock_guard lock(mutex_);
  double mib = 0;
  for (const auto& [digest, kept] : kept_) mib += kept.gone() ? 0 : kept.mib;
  return mib;
}

BakeStore::BakePtr BakeStore::make(const std::shared_ptr<const RenderScene>& scene, const BakePlan& plan,
                                   Digest digest, TilePool& pool, const BuildContext& context) const {
  const std::string path = bakePath(folder_, digest);
  makeRoomForBake(path, limits_.bytes(Limit::kBakeFiles), static_cast<std::uint64_t>(plan.memory) << 20);
  try {
    return std::make_shared<const Bake>(bake(
        scene, plan, folder_, PoolHandle(pool, Priority::kNormal, context.stop),
        [&](const Baker& baker) { context.setProgress(baker.share()); },
        [this](const std::string& fault) { log_.write(spdlog::level::warn, "bake: " + fault); }));
  } catch (const std::runtime_error& fault) {  // the operator's to repair
    log_.write(spdlog::level::err, std::string("bake: ") + fault.what());
    throw Refusal(v1::CODE_UNAVAILABLE, kField, "the server cannot keep the light that it computes");
  }
}

}  // namespace saccade
