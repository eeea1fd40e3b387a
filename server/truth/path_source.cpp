#include "truth/path_source.h"

namespace saccade {

// The first interval of a feed also completes frame 0.
TruthSamples PathSource::sample(const FeedInterval& interval) {
  const auto at = [&](TimeNs t) {
    const std::vector<double> values = row(interval.rendered->path, t);
    return TruthSample{
        t.count(), std::string(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double))};
  };
  TruthSamples samples;
  if (interval.change.frame == 1) samples.push_back(at(interval.change.t0));
  if (interval.ends_frame) samples.push_back(at(interval.change.t1));
  return samples;
}

}  // namespace saccade
