// Meshes that deform, for tests.
#pragma once

#include <algorithm>
#include <string>

#include "scene/motion/bodies.h"
#include "scene/scene.h"

namespace saccade::test {

inline Mesh& meshOf(Scene& s, const std::string& name) {
  return *std::ranges::find(s.meshes, name, &Mesh::name);
}

// Makes the mesh a body that deforms, and has this form at first.
inline void setDeformation(Scene& s, const std::string& name, Deformation d) {
  Mesh& mesh = meshOf(s, name);
  d.positions = mesh.positions, d.normals = mesh.normals;
  d.positions.pop_back();  // the spare one
  mesh.deformation = static_cast<int>(s.deformations.size());
  s.deformations.push_back(std::move(d));
  const std::string names[]{name};
  setBodies(s, names);
}

// All vertices follow a node, which goes from no motion to `end` in this time.
inline void setNodeMotion(Scene& s, const std::string& name, const Pose& end, float seconds) {
  const auto single = [](double v) { return static_cast<float>(v); };
  const Quaternion q = end.rotation;
  const Vec3 p = toFloat(end.position);
  KeyTrack turn{KeyInterpolation::kLinear, true, 4, {0, seconds}, {0, 0, 0, 1}};
  for (const double v : {q.x, q.y, q.z, q.w}) turn.values.push_back(single(v));
  const KeyTrack go{KeyInterpolation::kLinear, false, 3, {0, seconds}, {0, 0, 0, p.x, p.y, p.z}};
  using Property = NodeTrack::Property;
  s.nodes = {{{}, {}, {{Property::kRotation, turn}, {Property::kTranslation, go}}}};
  Deformation d;
  d.joints = {{0, {}}};
  setDeformation(s, name, d);
}

// Each vertex goes along z by `slope` times its x, in this time.
inline void setBending(Scene& s, const std::string& name, float slope, float seconds) {
  Deformation d;
  MorphTarget& target = d.targets.emplace_back();
  const Mesh& mesh = meshOf(s, name);
  for (const Vec3 p : mesh.positions) target.positions.push_back({0, 0, slope * p.x});
  target.positions.pop_back();
  d.weights = {0};
  d.weight_keys = {KeyInterpolation::kLinear, false, 1, {0, seconds}, {0, 1}};
  d.joints = {{{}, {}}};
  setDeformation(s, name, d);
}

}  // namespace saccade::test
