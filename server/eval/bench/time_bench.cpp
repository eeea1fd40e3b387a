#include "eval/bench/time_bench.h"

#include <algorithm>
#include <numeric>

namespace saccade::eval {
namespace {

double pixelsOf(const BenchSetup& setup) {
  return static_cast<double>(setup.width) * setup.height;
}

BenchSetup smallOf(BenchSetup setup) {
  setup.width = std::max(1, setup.width / 2), setup.height = std::max(1, setup.height / 2);
  setup.first = setup.last = kLateFrames * setup.last;
  setup.reference_spp = 0;
  return setup;
}

}  // namespace

TimeBench::TimeBench(const BenchSetup& setup, std::shared_ptr<const RenderScene> scene, TilePool& pool)
    : frames_(static_cast<std::size_t>(setup.last)),
      scaled_(pixelsOf(setup) / 4 / pixelsOf(smallOf(setup))),
      bench_(smallOf(setup), std::move(scene), pool) {}

MeasuredTime TimeBench::run(const MethodSpec& method, int spp) const {
  return meansOf(bench_.run(method, spp, 1).frame_ms);
}

MeasuredTime TimeBench::meansOf(std::span<const double> frame_ms) const {
  const auto mean = [&](std::span<const double> ms) {
    return scaled_ * std::accumulate(ms.begin(), ms.end(), 0.0) / static_cast<double>(ms.size());
  };
  return {0, mean(frame_ms.first(frames_)), mean(frame_ms.last(frames_))};
}

}  // namespace saccade::eval
