#include "scene/scene.h"

#include <algorithm>

namespace saccade {
namespace {

bool grey(Rgb c) {
  return c.x == c.y && c.y == c.z;
}
bool grey(const SurfaceColor& c) {
  return grey(c.color0) && grey(c.color1);
}
bool grey(const Material& m) {
  return grey(m.reflectance) && grey(m.specular) && grey(m.transmittance) && grey(m.opacity) &&
         grey(m.model.eta) && grey(m.model.k);
}
bool grey(const Texture& t) {
  return t.grey();
}
bool grey(const Mesh& m) {
  return grey(m.radiance) && std::all_of(m.colors.begin(), m.colors.end(), [](Rgb c) { return grey(c); });
}
bool grey(const Sphere& s) {
  return grey(s.radiance);
}
bool grey(const PointLight& l) {
  return grey(l.intensity);
}
bool grey(const SpotLight& l) {
  return grey(l.intensity);
}
bool grey(const DirectionalLight& l) {
  return grey(l.irradiance);
}
template <class T>
bool grey(const std::vector<T>& all) {
  return std::all_of(all.begin(), all.end(), [](const T& one) { return grey(one); });
}
bool grey(const Environment& e) {
  return grey(e.radiance) && grey(e.picture.pixels);
}

}  // namespace

int colorChannels(const Scene& s) {
  const bool all_grey = grey(s.materials) && grey(s.textures) && grey(s.meshes) && grey(s.spheres) &&
                        grey(s.point_lights) && grey(s.spot_lights) && grey(s.directional_lights) &&
                        (!s.environment || grey(*s.environment));
  return all_grey ? 1 : 3;
}

}  // namespace saccade
