#include "methods/path_traced.h"

#include "methods/param_fields.h"

namespace saccade {
namespace {

struct CorrelatedParams {
  int independent_numbers = 0;
  int reconnect = 0;
};

const std::vector<ParamField<CorrelatedParams>>& fields() {
  static const std::vector<ParamField<CorrelatedParams>> table = {
      independentNumbersField<CorrelatedParams>(&CorrelatedParams::independent_numbers),
      {"reconnect", &CorrelatedParams::reconnect, 0, 1,
       "1: paths of both frames are reconnected at diffuse second vertices, unless jittered; 0: replayed",
       "Kettunen et al. 2015; paper 4.3: 0"}};
  return table;
}

SeedPlanner correlatedSeeds(const ParamValues& values) {
  const CorrelatedParams p = makeParams(fields(), values);
  if (p.reconnect) return seedsWith<SeedPlan::reconnected>(p.independent_numbers);
  return seedsWith<SeedPlan::correlated>(p.independent_numbers);
}

}  // namespace

MethodInfo PathTraced::independentInfo() {
  return {"pt",
          "path tracing, fresh seeds in every frame, no filter",
          {},
          [](const ParamValues&) -> SeedPlanner { return SeedPlan::independent; },
          [](const MethodSetup&) -> std::unique_ptr<Method> { return std::make_unique<PathTraced>(false); }};
}

MethodInfo PathTraced::correlatedInfo() {
  return {"pt-correlated", "path tracing, seeds of the previous frame reused for the difference, no filter",
          paramSpecs(fields()), correlatedSeeds,
          [](const MethodSetup&) -> std::unique_ptr<Method> { return std::make_unique<PathTraced>(true); }};
}

void PathTraced::estimate(const FramePair& frames, const PoolHandle& pool, IntensityChange& out,
                          StageTimes& times) {
  const FrameSamples &cur = frames.cur.samples, &prev = frames.prev.samples;
  const float share1 = correlated_ ? 0.5f : 0.f;  // of pass 1 in the primal [E (9)]
  times[Stage::kModulate] += pool.forEachRow(out.dI.height(), [&](int y) {
    const float *I1 = cur.I1.row(y), *I2 = cur.I2.row(y), *I1_prev = prev.I1.row(y),
                *I2_prev = prev.I2.row(y);
    float *dI = out.dI.row(y), *I_prev = out.I_prev.row(y), *I_now = out.I_now.row(y);
    for (int x = 0; x < out.dI.width(); ++x) {
      dI[x] = (correlated_ ? I1[x] : I2[x]) - I2_prev[x];  // [E (8)]
      I_prev[x] = share1 * I1_prev[x] + (1 - share1) * I2_prev[x];
      I_now[x] = share1 * I1[x] + (1 - share1) * I2[x];
    }
  });
}

}  // namespace saccade
