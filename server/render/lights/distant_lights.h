// Light from infinitely far away: suns and a sky.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "render/lights/environment_light.h"
#include "render/lights/incident_light.h"
#include "render/lights/light_choice.h"
#include "scene/scene.h"

namespace saccade {

// Lights are chosen by their irradiance at an open place: of a sky pi times its mean luminance [ours]. So
// nothing depends on the size of the scene.
class DistantLights {
 public:
  // Keeps a pointer to the pixels of the scene's environment.
  explicit DistantLights(const Scene& scene);

  // In place of the suns, as many that shine as strongly.
  void setSuns(std::vector<DirectionalLight> suns) { suns_ = std::move(suns); }

  bool has(LightSet set) const { return !choice(set).empty(); }

  // A sample of numbers in [0, 1): u_light chooses the light, u1 and u2 a direction. There must be a light.
  IncidentLight sample(LightSet set, float u_light, float u1, float u2) const;

  // Of the sky, and the pdf of sample() for it per solid angle. Both are 0 without a sky.
  Rgb radiance(Vec3 direction) const;
  float pdf(LightSet set, Vec3 direction) const;

 private:
  const LightChoice& choice(LightSet set) const { return choices_[static_cast<std::size_t>(set)]; }

  std::vector<DirectionalLight> suns_;
  std::optional<EnvironmentLight> sky_;
  std::array<LightChoice, kLightSets> choices_;  // of the suns, then the sky
};

}  // namespace saccade
