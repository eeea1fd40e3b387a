#include "feed/bake.h"

#include <chrono>
#include <stdexcept>
#include <utility>

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
    throw std::runtime_error(path + ": is damaged: " + fault.what());
  }
}

// More than any state of such a plan. Memory counts 128 bytes of a vertex; a file has about half. The last
// pose before memory is full may add some vertices for each of its pixels.
std::uint64_t mostBytesOf(const BakePlan& plan) {
  constexpr std::uint64_t kOfPixel = 1024;
  const auto pixels =
      static_cast<std::uint64_t>(plan.camera.width) * static_cast<std::uint64_t>(plan.camera.height);
  return (2 * static_cast<std::uint64_t>(plan.memory) << 20) + kOfPixel * pixels;
}

// A baker that goes on where the file at `path` has ended, with the digest of that; 0: from the beginning.
std::pair<std::unique_ptr<Baker>, std::uint64_t> begin(const std::shared_ptr<const RenderScene>& scene,
                                                       const BakePlan& plan, const std::string& path,
                                                       std::uint64_t plan_digest,
                                                       const std::function<void(const std::string&)>& warn) {
  try {
    auto baker = std::make_unique<Baker>(scene, plan);
    const auto kept = readBake(path, plan_digest, mostBytesOf(plan));
    if (kept) restore(path, *kept, *baker);
    return {std::move(baker), kept ? kept->digest : 0};
  } catch (const std::runtime_error& fault) {
    warn(std::string(fault.what()) + "; it is now " + setBakeAside(path) + ", and is made anew");
  }
  return {std::make_unique<Baker>(scene, plan), 0};
}

}  // namespace

Bake bake(std::shared_ptr<const RenderScene> scene, const BakePlan& plan, const std::string& folder,
          const PoolHandle& pool, const std::function<void(const Baker&)>& after_pass,
          const std::function<void(const std::string&)>& warn) {
  const std::uint64_t plan_digest = digestOf(*scene, plan);
  const std::string path = bakePath(folder, plan_digest);
  Bake bake;
  const auto begun = begin(scene, plan, path, plan_digest, warn);
  Baker& baker = *begun.first;
  bake.digest = begun.second;
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
