#include "feed/bake.h"

#include <chrono>
#include <stdexcept>

#include "feed/bake_file.h"

namespace saccade {
namespace {

using std::chrono::steady_clock;

constexpr std::chrono::seconds kBetweenFiles{10};

// Goes on where the file at `path` has ended.
void restore(const std::string& path, const KeptBake& kept, Baker& baker) {
  try {
    baker.restore(kept.state);
  } catch (const std::exception& fault) {
    throw std::runtime_error(path + ": is damaged: " + fault.what() + "; remove it");
  }
}

}  // namespace

Bake bake(std::shared_ptr<const RenderScene> scene, const BakePlan& plan, const std::string& folder,
          const PoolHandle& pool, const std::function<void(const Baker&)>& after_pass) {
  const std::uint64_t plan_digest = digestOf(*scene, plan);
  const std::string path = bakePath(folder, plan_digest);
  Bake bake;
  Baker baker(std::move(scene), plan);
  if (const auto kept = readBake(path, plan_digest)) restore(path, *kept, baker), bake.digest = kept->digest;
  const auto keep = [&] { bake.digest = writeBake(path, plan_digest, baker.state()); };
  auto kept_at = steady_clock::now();
  while (!baker.isDone()) {
    baker.pass(pool);
    try {
      after_pass(baker);
    } catch (...) {
      keep();
      throw;
    }
    if (!baker.isDone() && steady_clock::now() - kept_at < kBetweenFiles) continue;
    keep();
    kept_at = steady_clock::now();
  }
  bake.known = baker.known(), bake.passes = baker.passes(), bake.poses = baker.poses();
  bake.full = baker.isFull();
  bake.light = baker.light(pool);
  return bake;
}

}  // namespace saccade
