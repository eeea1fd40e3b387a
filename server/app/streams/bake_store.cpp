#include "app/streams/bake_store.h"

#include "app/request/refusal.h"
#include "app/streams/bake_folder.h"
#include "feed/bake_file.h"

namespace saccade {
namespace {

constexpr const char* kField = "quality.bake_error";

}  // namespace

std::shared_ptr<const Bake> BakeStore::get(const std::shared_ptr<const RenderScene>& scene,
                                           const BakePlan& plan, const PoolHandle& pool,
                                           const std::stop_token& stop,
                                           const std::function<void(double)>& progress) {
  if (folder_.empty()) throw Refusal(v1::CODE_UNAVAILABLE, kField, "this server keeps no bakes");
  const Digest digest = digestOf(*scene, plan);
  std::unique_lock lock(mutex_);
  if (!made_.wait(lock, stop, [&] { return !under_way_.contains(digest); })) throw Cancelled();
  if (auto found = kept_[digest].bake.lock()) return found;
  admit(plan.memory);
  kept_[digest] = {{}, plan.memory};
  under_way_.insert(digest);
  lock.unlock();
  std::shared_ptr<const Bake> bake;
  std::exception_ptr fault;
  try {
    bake = make(scene, plan, digest, pool, progress);
  } catch (...) {
    fault = std::current_exception();
  }
  lock.lock();
  under_way_.erase(digest);
  kept_[digest].bake = bake;
  made_.notify_all();
  if (fault) std::rethrow_exception(fault);
  return bake;
}

// Throws LimitReached where there is no memory for one more.
void BakeStore::admit(int mib) {
  std::erase_if(kept_, [&](const auto& entry) {
    return entry.second.bake.expired() && !under_way_.contains(entry.first);
  });
  double taken = mib;
  for (const auto& [digest, kept] : kept_) taken += kept.mib;
  if (taken <= limits_[Limit::kBakes]) return;
  throw LimitReached(Limit::kBakes, kField, "other bakes are in use or being made", kRetrySeconds);
}

std::shared_ptr<const Bake> BakeStore::make(const std::shared_ptr<const RenderScene>& scene,
                                            const BakePlan& plan, Digest digest, const PoolHandle& pool,
                                            const std::function<void(double)>& progress) const {
  const std::string path = bakePath(folder_, digest);
  makeRoomForBake(path, limits_.bytes(Limit::kBakeFiles), static_cast<std::uint64_t>(plan.memory) << 20);
  try {
    return std::make_shared<const Bake>(bake(
        scene, plan, folder_, pool, [&](const Baker& baker) { progress(baker.share()); },
        [this](const std::string& fault) { log_.write(spdlog::level::warn, "bake: " + fault); }));
  } catch (const std::runtime_error& fault) {  // the operator's to repair
    log_.write(spdlog::level::err, std::string("bake: ") + fault.what());
    throw Refusal(v1::CODE_UNAVAILABLE, kField, "the server cannot keep the light that it computes");
  }
}

}  // namespace saccade
