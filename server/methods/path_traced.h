// Path tracing without a filter: pt, with fresh seeds in every frame, and pt-correlated, with reused ones
// (paper, 5.1 and Fig. 8 B).
#pragma once

#include "methods/method.h"

namespace saccade {

class PathTraced final : public Method {
 public:
  explicit PathTraced(bool correlated) : correlated_(correlated) {}
  static MethodInfo independentInfo();
  static MethodInfo correlatedInfo();

  void start(const Frame&, const PoolHandle&) override {}
  void estimate(const FramePair& frames, const PoolHandle& pool, IntensityChange& out,
                StageTimes& times) override;

 private:
  bool correlated_;
};

}  // namespace saccade
