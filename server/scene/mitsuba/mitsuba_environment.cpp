#include "scene/mitsuba/mitsuba_environment.h"

#include <cmath>
#include <utility>

namespace saccade {

Affine orthonormal(const XmlFile& file, pugi::xml_node emitter, const Affine& map) {
  const Affine unit{normalize(map.x), normalize(map.y), normalize(map.z), {}};
  if (std::abs(std::abs(determinant(unit)) - 1) > 1e-4)
    throw file.error(emitter, "the emitter's to_world may rotate, mirror and scale, not shear");
  return unit;
}

void addEnvironment(const XmlFile& file, pugi::xml_node emitter, Scene& scene, Environment environment) {
  if (scene.environment) throw file.error(emitter, "a second emitter around the scene; one is supported");
  scene.environment = std::move(environment);
}

}  // namespace saccade
