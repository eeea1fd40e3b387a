// The light sources of a scene in two strata. A vertex of a path takes one sample of each that the scene has.
// So light that does not reach a place never costs it the samples of light that does [ours].
#pragma once

#include "render/lights/distant_lights.h"
#include "render/lights/lamps.h"

namespace saccade {

enum class Stratum { kLamps, kDistant };

class Lights {
 public:
  // Keeps a pointer to the pixels of the scene's environment.
  explicit Lights(const Scene& scene) : lamps_(scene), distant_(scene) {}

  // In place of the lamps, others of the same scene.
  void setLamps(Lamps lamps) { lamps_ = std::move(lamps); }
  // See DistantLights.
  void setSuns(std::vector<DirectionalLight> suns) { distant_.setSuns(std::move(suns)); }

  // See Lamps.
  void look(LightSet set, LampSight sight) { lamps_.look(set, std::move(sight)); }

  const Lamps& lamps() const { return lamps_; }
  const DistantLights& distant() const { return distant_; }

  bool empty() const { return !lamps_.has(LightSet::kAll) && !distant_.has(LightSet::kAll); }
  bool has(Stratum stratum, LightSet set) const {
    return stratum == Stratum::kLamps ? lamps_.has(set) : distant_.has(set);
  }

  // A sample of a stratum, of numbers in [0, 1). The strata of a vertex share the numbers. There they stand
  // for different things, so that their errors are not alike.
  IncidentLight sample(Stratum stratum, LightSet set, const Receiver& at, float u_light, float u1,
                       float u2) const {
    if (stratum == Stratum::kDistant) return distant_.sample(set, u_light, u2, u1);
    return lamps_.sample(lamps_.choose(set, at, u_light), at.point, u1, u2);
  }

 private:
  Lamps lamps_;
  DistantLights distant_;
};

}  // namespace saccade
