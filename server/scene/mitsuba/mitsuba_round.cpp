#include "scene/mitsuba/mitsuba_round.h"

#include <cmath>

#include "scene/mesh/round_shapes.h"

namespace saccade {
namespace {

// From the axis from z = 0 to 1 with a radius of 1 to that from p0 to p1.
Affine readAxis(const XmlFile& file, pugi::xml_node shape, Properties& properties) {
  const Vec3d p0 = properties.vector("p0").value_or(Vec3d{}),
              p1 = properties.vector("p1").value_or(Vec3d{0, 0, 1});
  const double radius = properties.number("radius", 1);
  const Vec3d axis = p1 - p0, z = normalize(axis);
  const Vec3d across = std::abs(z.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
  const Vec3d x = normalize(cross(across, z)) * radius, y = cross(z, x);
  if (!(radius > 0 && determinant({x, y, axis, {}}) > 0))
    throw file.error(shape, "a cylinder needs a radius and a length above 0");
  return {x, y, axis, p0};
}

// From a sphere of radius 1 around 0.
Affine readBall(const XmlFile& file, pugi::xml_node shape, Properties& properties) {
  const double r = properties.number("radius", 1);
  if (!(r > 0)) throw file.error(shape, "a sphere needs a radius above 0");
  return {{r, 0, 0}, {0, r, 0}, {0, 0, r}, properties.vector("center").value_or(Vec3d{})};
}

}  // namespace

bool isRound(const std::string& type) {
  return type == "cylinder" || type == "sphere";
}

Mesh makeRound(const std::string& type) {
  return type == "cylinder" ? makeCylinder() : makeSphere();
}

Affine readRound(const XmlFile& file, pugi::xml_node shape, const std::string& type, Properties& properties) {
  if (!isRound(type)) return {};
  return type == "cylinder" ? readAxis(file, shape, properties) : readBall(file, shape, properties);
}

}  // namespace saccade
