#include "methods/a_svgf.h"

namespace saccade {
namespace {

using P = ASvgfParams;

const std::vector<ParamField<P>>& fields() {
  static const std::vector<ParamField<P>> table = withCommonFields<P>({
      {"gradient_iterations", &P::gradient_iterations, 0, 5,
       "a-trous iterations of the temporal gradient, over strata of 3x3 pixels", "Q2RTX"},
  });
  return table;
}

}  // namespace

MethodInfo ASvgf::info() {
  return {
      "a_svgf", "A-SVGF: as svgf, and forgets its history where the same paths find other light",
      paramSpecs(fields()),
      [](const ParamValues& values) -> SeedPlanner {
        return seedsWith<SeedPlan::correlatedAlongMotion>(makeParams(fields(), values).independent_numbers);
      },
      [](const MethodSetup& setup) -> std::unique_ptr<Method> {
        return std::make_unique<ASvgf>(makeParams(fields(), setup.params), setup.width, setup.height);
      }};
}

void ASvgf::estimate(const FramePair& frames, const PoolHandle& pool, IntensityChange& out,
                     StageTimes& times) {
  times[Stage::kTemporal] += gradient_.estimate(frames, pool);
  svgf_.estimate(frames, pool, out, times);
}

}  // namespace saccade
