// The bakes that streams share. Each is made once, and kept in a folder.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>

#include "app/admission/limits.h"
#include "base/shared_build.h"
#include "feed/bake.h"
#include "log/limited_log.h"

namespace saccade {

class BakeStore {
 public:
  BakeStore(std::string folder, const Limits& limits) : folder_(std::move(folder)), limits_(limits) {}

  // The bake of a plan: one that a stream uses, or the one in its file. If there is none it is made on the
  // pool, once for all who ask, which may take minutes. Meanwhile `progress` is told the share that is done.
  // From any thread. The pool must outlive this. Throws Refusal, and Cancelled as soon as `stop` is
  // requested.
  std::shared_ptr<const Bake> get(const std::shared_ptr<const RenderScene>& scene, const BakePlan& plan,
                                  TilePool& pool, const std::stop_token& stop,
                                  const std::function<void(double)>& progress);

  double inUse() const;  // MiB of the bakes that streams use, or that are being made

 private:
  using Digest = std::uint64_t;  // of a plan
  using BakePtr = std::shared_ptr<const Bake>;
  BakePtr find(Digest digest);
  std::shared_ptr<const void> admit(Digest digest, int mib);
  BakePtr make(const std::shared_ptr<const RenderScene>& scene, const BakePlan& plan, Digest digest,
               TilePool& pool, const BuildContext& context) const;

  const std::string folder_;  // empty: there are no bakes
  const Limits limits_;
  mutable LimitedLog log_;
  mutable std::mutex mutex_;
  struct Kept {
    std::weak_ptr<const void> making;  // held while it is made
    std::weak_ptr<const Bake> bake;
    int mib;
    bool gone() const { return making.expired() && bake.expired(); }
  };
  std::map<Digest, Kept> kept_;
  SharedBuild<Digest, Bake> builds_;  // last: its threads use all others
};

}  // namespace saccade
