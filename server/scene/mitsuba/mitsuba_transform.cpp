#include "scene/mitsuba/mitsuba_transform.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "scene/camera/pose.h"
#include "scene/mitsuba/xml_properties.h"

namespace saccade {
namespace {

std::vector<double> numbersIn(const XmlFile& file, pugi::xml_node node, const char* attribute) {
  return parseNumbers(file, node, node.attribute(attribute).value());
}

Vec3d vectorIn(const XmlFile& file, pugi::xml_node node, const char* attribute) {
  const auto v = numbersIn(file, node, attribute);
  if (v.size() != 3) throw file.error(node, std::string("expected three numbers in ") + attribute);
  return {v[0], v[1], v[2]};
}

// value="x, y, z", or x, y and z with a fallback for those not given.
Vec3d axesIn(const XmlFile& file, pugi::xml_node node, double fallback) {
  if (node.attribute("value")) return vectorIn(file, node, "value");
  const auto axis = [&](const char* name) {
    if (!node.attribute(name)) return fallback;
    const auto v = numbersIn(file, node, name);
    if (v.size() != 1) throw file.error(node, std::string("expected one number in ") + name);
    return v[0];
  };
  return {axis("x"), axis("y"), axis("z")};
}

Affine parseScale(const XmlFile& file, pugi::xml_node node) {
  const auto same = numbersIn(file, node, "value");
  const Vec3d s = same.size() == 1 ? Vec3d{same[0], same[0], same[0]} : axesIn(file, node, 1);
  return {{s.x, 0, 0}, {0, s.y, 0}, {0, 0, s.z}, {}};
}

Affine parseRotate(const XmlFile& file, pugi::xml_node node) {
  const Vec3d axis = axesIn(file, node, 0);
  const auto degrees = numbersIn(file, node, "angle");
  if (degrees.size() != 1 || !(length(axis) > 0)) throw file.error(node, "expected an axis and an angle");
  const Quaternion q = axisAngle(normalize(axis) * (degrees[0] * std::numbers::pi / 180));
  return {rotate(q, {1, 0, 0}), rotate(q, {0, 1, 0}), rotate(q, {0, 0, 1}), {}};
}

Affine parseMatrix(const XmlFile& file, pugi::xml_node node) {
  const auto m = numbersIn(file, node, "value");
  if (m.size() == 9) return {{m[0], m[3], m[6]}, {m[1], m[4], m[7]}, {m[2], m[5], m[8]}, {}};
  if (m.size() != 16) throw file.error(node, "expected 16 numbers, or 9, row by row");
  if (m[12] != 0 || m[13] != 0 || m[14] != 0 || m[15] != 1)
    throw file.error(node, "the last row is not 0 0 0 1");
  return {{m[0], m[4], m[8]}, {m[1], m[5], m[9]}, {m[2], m[6], m[10]}, {m[3], m[7], m[11]}};
}

// Mitsuba's camera: x left, y up, z forward.
Affine parseLookAt(const XmlFile& file, pugi::xml_node node) {
  const Vec3d origin = vectorIn(file, node, "origin"), target = vectorIn(file, node, "target");
  const Vec3d up = node.attribute("up") ? vectorIn(file, node, "up") : Vec3d{0, 1, 0};
  const Vec3d forward = target - origin, left = cross(up, forward);
  if (!(length(left) > 0)) throw file.error(node, "'up' is parallel to the line from origin to target");
  const Vec3d z = normalize(forward), x = normalize(left);
  return {x, cross(z, x), z, origin};
}

Affine parseStep(const XmlFile& file, pugi::xml_node node) {
  const std::string name = node.name();
  if (name == "matrix") return parseMatrix(file, node);
  if (name == "translate") return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, axesIn(file, node, 0)};
  if (name == "rotate") return parseRotate(file, node);
  if (name == "scale") return parseScale(file, node);
  if (name == "lookat" || name == "lookAt") return parseLookAt(file, node);
  throw file.error(node, "<" + name +
                             "> is not supported in <transform>; supported: matrix, translate, rotate, "
                             "scale, lookat");
}

}  // namespace

Affine parseTransform(const XmlFile& file, pugi::xml_node node) {
  Affine map;
  for (pugi::xml_node step : node.children())
    if (step.type() == pugi::node_element) map = parseStep(file, step) * map;
  const double d = determinant(map);
  if (d == 0 || !std::isfinite(d) || !std::isfinite(length(map.translation)))
    throw file.error(node, "the transform flattens space, or its numbers are too large");
  return map;
}

}  // namespace saccade
