#include "render/lights/distant_lights.h"

#include <limits>
#include <numbers>

#include "render/lights/delta_samples.h"

namespace saccade {

DistantLights::DistantLights(const Scene& scene) : suns_(scene.directional_lights) {
  std::vector<float> all, with_extent(suns_.size());
  for (const DirectionalLight& sun : suns_) all.push_back(luminance(sun.irradiance));
  if (scene.environment) {
    sky_.emplace(*scene.environment);
    for (auto* weights : {&all, &with_extent})
      weights->push_back(std::numbers::pi_v<float> * sky_->meanLuminance());
  }
  choices_ = {LightChoice(all), LightChoice(with_extent)};
}

IncidentLight DistantLights::sample(LightSet set, float u_light, float u1, float u2) const {
  const std::size_t i = choice(set).choose(u_light);
  const float p = choice(set).probability(i);
  if (i < suns_.size()) return sampleOf(suns_[i], p);
  const EnvironmentSample s = sky_->sample(u1, u2);
  constexpr float kEndless = std::numeric_limits<float>::infinity();
  return {s.direction, s.direction, kEndless, s.radiance, s.pdf * p};
}

Rgb DistantLights::radiance(Vec3 direction) const {
  return sky_ ? sky_->radiance(direction) : Rgb{};
}

float DistantLights::pdf(LightSet set, Vec3 direction) const {
  return sky_ && has(set) ? sky_->pdf(direction) * choice(set).probability(suns_.size()) : 0;
}

}  // namespace saccade
