#include "truth/object_source.h"

#include "render/world/posed_scene.h"
#include "truth/object_numbers.h"

namespace saccade {

// The first interval of a feed also completes frame 0.
TruthSamples ObjectSource::sample(const FeedInterval& interval) {
  TruthSamples samples;
  if (!interval.rendered->scene.bodies()) return samples;
  if (interval.change.frame == 1) add(*interval.rendered, interval.change.t0, samples);
  if (interval.ends_frame) add(*interval.rendered, interval.change.t1, samples);
  return samples;
}

void ObjectSource::add(const RenderedInterval& interval, TimeNs t, TruthSamples& samples) {
  if (numbers_.empty()) numbers_ = bodyNumbers(interval.scene.still().description());
  const std::vector<Trajectory>& paths = interval.scene.bodies()->paths();
  for (std::size_t i = 0; i < paths.size(); ++i) {
    std::vector<double> values{static_cast<double>(numbers_[i])};
    const std::vector<double> rest = row(paths[i], t);
    values.insert(values.end(), rest.begin(), rest.end());
    samples.push_back({t.count(), std::string(reinterpret_cast<const char*>(values.data()),
                                              values.size() * sizeof(double))});
  }
}

}  // namespace saccade
