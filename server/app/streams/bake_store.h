// The bakes that streams share. Each is made once, and kept in a folder.
#pragma once

#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <stop_token>
#include <string>

#include "app/admission/limits.h"
#include "feed/bake.h"
#include "ops/limited_log.h"

namespace saccade {

class BakeStore {
 public:
  BakeStore(std::string folder, const Limits& limits) : folder_(std::move(folder)), limits_(limits) {}

  // The bake of a plan: one that a stream uses, or the one in its file. If there is none it is made, which
  // may take minutes; `progress` is then told the share that is done. Waits where another thread makes it.
  // From any thread. Throws Refusal, and Cancelled once `stop` is requested.
  std::shared_ptr<const Bake> get(const std::shared_ptr<const RenderScene>& scene, const BakePlan& plan,
                                  const PoolHandle& pool, const std::stop_token& stop,
                                  const std::function<void(double)>& progress);

 private:
  using Digest = std::uint64_t;  // of a plan
  void admit(int mib);
  std::shared_ptr<const Bake> make(const std::shared_ptr<const RenderScene>& scene, const BakePlan& plan,
                                   Digest digest, const PoolHandle& pool,
                                   const std::function<void(double)>& progress) const;

  const std::string folder_;  // empty: there are no bakes
  const Limits limits_;
  mutable LimitedLog log_;
  std::mutex mutex_;
  std::condition_variable_any made_;
  std::set<Digest> under_way_;
  struct Kept {
    std::weak_ptr<const Bake> bake;
    int mib;
  };
  std::map<Digest, Kept> kept_;
};

}  // namespace saccade
