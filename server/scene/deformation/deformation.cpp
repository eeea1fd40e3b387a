#include "scene/deformation/deformation.h"

#include <algorithm>
#include <cmath>

namespace saccade {
namespace {

JointMap toMap(const Affine& a) {
  JointMap map;
  auto* to = map.data();
  for (const Vec3d column : {a.x, a.y, a.z, a.translation})
    for (const double v : {column.x, column.y, column.z}) *to++ = static_cast<float>(v);
  return map;
}

// The weighted sum of the maps of a vertex.
JointMap blend(const std::vector<JointMap>& joints, std::span<const Influence> influences) {
  JointMap sum{};
  for (const Influence& influence : influences)
    for (std::size_t k = 0; k < influence.joints.size(); ++k) {
      const JointMap& joint = joints[influence.joints[k]];
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += influence.weights[k] * joint[i];
    }
  return sum;
}

struct Columns {
  explicit Columns(const JointMap& m)
      : x{m[0], m[1], m[2]}, y{m[3], m[4], m[5]}, z{m[6], m[7], m[8]}, translation{m[9], m[10], m[11]} {}

  Vec3 point(Vec3 p) const { return x * p.x + y * p.y + z * p.z + translation; }
  // See mapNormal().
  Vec3 normal(Vec3 n) const {
    const Vec3 yz = cross(y, z), m = yz * n.x + cross(z, x) * n.y + cross(x, y) * n.z;
    return dot(x, yz) < 0 ? -m : m;
  }

  Vec3 x, y, z, translation;
};

Vec3 unitOr(Vec3 v, Vec3 fallback) {
  const float square = dot(v, v);
  return square > 0 && std::isfinite(square) ? v * (1 / std::sqrt(square)) : fallback;
}

// Numbers of a file may lead beyond the region of poses, see kMaxDistance. There nothing is seen: a vertex
// goes to the origin.
Vec3 within(Vec3 p) {
  constexpr float kFarthest = 1e9f;
  return dot(p, p) <= kFarthest * kFarthest ? p : Vec3{};
}

}  // namespace

std::size_t bytesOf(const Deformation& d) {
  std::size_t vectors = d.positions.size() + d.normals.size();
  for (const MorphTarget& target : d.targets) vectors += target.positions.size() + target.normals.size();
  return vectors * sizeof(Vec3) + d.influences.size() * sizeof(Influence) + d.joints.size() * sizeof(Joint) +
         d.weights.size() * sizeof(double) +
         (d.weight_keys.times.size() + d.weight_keys.values.size()) * sizeof(float);
}

void setForm(const Deformation& d, NodePoses& nodes, TimeNs t, MeshForm& form) {
  if (d.period > TimeNs{0}) t %= d.period;
  const std::span<const Affine> worlds = nodes.at(seconds(t));
  form.joints.resize(d.joints.size());
  for (std::size_t i = 0; i < d.joints.size(); ++i) {
    const Joint& joint = d.joints[i];
    form.joints[i] = toMap(joint.node ? worlds[*joint.node] * joint.from_mesh : joint.from_mesh);
  }
  form.weights = d.weights;
  if (!d.weight_keys.times.empty()) d.weight_keys.at(seconds(t), form.weights);
}

void deform(const Deformation& d, const MeshForm& form, std::span<Vec3> positions, std::span<Vec3> normals) {
  const bool smooth = !d.normals.empty();
  const std::span<const Influence> influences = d.influences;
  const std::size_t per_vertex = influences.size() / std::max<std::size_t>(1, d.positions.size());
  for (std::size_t i = 0; i < d.positions.size(); ++i) {
    Vec3 p = d.positions[i], n = smooth ? d.normals[i] : Vec3{};
    for (std::size_t k = 0; k < d.targets.size(); ++k) {
      const auto weight = static_cast<float>(form.weights[k]);
      if (weight == 0) continue;
      p = p + d.targets[k].positions[i] * weight;
      if (smooth && !d.targets[k].normals.empty()) n = n + d.targets[k].normals[i] * weight;
    }
    const std::span<const Influence> here = influences.subspan(i * per_vertex, per_vertex);
    const Columns map(here.empty() ? form.joints[0] : blend(form.joints, here));
    positions[i] = within(map.point(p));
    if (smooth) normals[i] = unitOr(map.normal(n), {0, 0, 1});
  }
}

bool isMirrored(const MeshForm& form) {
  const Columns map(form.joints[0]);
  return dot(map.x, cross(map.y, map.z)) < 0;
}

}  // namespace saccade
