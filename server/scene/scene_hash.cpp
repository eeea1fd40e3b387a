#include "scene/scene_hash.h"

#include "base/content_hash.h"

namespace saccade {
namespace {

void add(ContentHash& h, const SurfaceColor& c) {
  h.add(static_cast<int>(c.kind)), h.add(c.color0), h.add(c.color1), h.add(c.texture), h.add(c.uv_scale),
      h.add(c.uv_offset);
  if (c.uv_cross.x != 0 || c.uv_cross.y != 0) h.add(c.uv_cross);
  if (c.second_uvs) h.add(1);
}

void add(ContentHash& h, const BsdfModel& m) {
  h.add(static_cast<int>(m.kind)), h.add(static_cast<int>(m.microfacets)), h.add(m.alpha), h.add(m.ior);
  h.add(m.eta), h.add(m.k), h.add(static_cast<int>(m.nonlinear));
  if (m.scatters_once) h.add(1);
  if (m.coat_ior != 0) h.add(m.coat_ior);
  if (m.coat_alpha != 0) h.add(m.coat_alpha), h.add(static_cast<int>(m.coat_microfacets));
}

// A diffuse material adds only its reflectance, so that older cached references stay valid.
void add(ContentHash& h, const Material& m) {
  add(h, m.reflectance);
  h.add(static_cast<int>(m.twosided));
  if (isTextured(m.emission)) add(h, m.emission);
  if (m.model.kind == BsdfKind::kDiffuse && isOpaque(m) && !isBumpy(m)) return;
  add(h, m.model);
  for (const SurfaceColor* c : {&m.specular, &m.transmittance, &m.opacity, &m.height}) add(h, *c);
  h.add(m.height_scale);
  if (m.model.kind == BsdfKind::kMetallicRoughness) add(h, m.metallic_roughness);
  if (isTextured(m.normals)) add(h, m.normals), h.add(m.normals_scale);
}

// Samples the finest level. A texture without mips looks different from afar.
void add(ContentHash& h, const Texture& t) {
  if (!t.mipMapped()) h.add(1);
  if (t.wrapU() != Texture::Wrap::kRepeat) h.add(2 + static_cast<int>(t.wrapU()));
  if (t.wrapV() != Texture::Wrap::kRepeat) h.add(4 + static_cast<int>(t.wrapV()));
  for (int i = 0; i < 4096; ++i)
    h.add(t.sample({static_cast<float>(i % 64) / 64, static_cast<float>(i / 64) / 64}, 0));
}

void add(ContentHash& h, const Environment& e) {
  h.add(e.radiance), h.add(e.to_world), h.add(e.picture.width), h.add(e.picture.height),
      h.add(e.picture.pixels);
}

void add(ContentHash& h, const KeyTrack& track) {
  h.add(static_cast<int>(track.interpolation)), h.add(track.times), h.add(track.values);
}

void add(ContentHash& h, const Deformation& d) {
  h.add(d.positions), h.add(d.normals), h.add(d.influences), h.add(d.weights), h.add(d.period.count());
  add(h, d.weight_keys);
  for (const MorphTarget& target : d.targets) h.add(target.positions), h.add(target.normals);
  for (const Joint& joint : d.joints) h.add(joint.node ? *joint.node + 1 : 0), h.add(joint.from_mesh);
}

void add(ContentHash& h, const MovingNode& node) {
  h.add(node.parent ? *node.parent + 1 : 0), h.add(node.rest.affine());
  for (const NodeTrack& track : node.tracks) h.add(static_cast<int>(track.property)), add(h, track.keys);
}

}  // namespace

std::uint64_t hashScene(const Scene& scene) {
  ContentHash h;
  for (const Mesh& m : scene.meshes)
    h.add(m.positions), h.add(m.normals), h.add(m.uvs), h.add(m.triangles), h.add(m.material),
        h.add(m.radiance), h.add(m.colors), h.add(m.second_uvs);
  for (const Sphere& s : scene.spheres)
    h.add(s.center), h.add(s.radius), h.add(s.material), h.add(s.radiance);
  for (const Material& m : scene.materials) add(h, m);
  for (const Texture& t : scene.textures) add(h, t);
  if (scene.environment) add(h, *scene.environment);
  for (const PointLight& l : scene.point_lights) h.add(l.position), h.add(l.intensity);
  for (const SpotLight& l : scene.spot_lights)
    h.add(l.position), h.add(l.axis), h.add(l.intensity), h.add(l.beam), h.add(l.cutoff);
  for (const DirectionalLight& l : scene.directional_lights) h.add(l.direction), h.add(l.irradiance);
  if (scene.origin != Vec3d{}) h.add(scene.origin);
  if (scene.bodies.empty()) return h.value;
  for (const Mesh& m : scene.meshes) h.add(m.body);
  for (const Sphere& s : scene.spheres) h.add(s.body);
  for (const PointLight& l : scene.point_lights) h.add(l.body);
  for (const SpotLight& l : scene.spot_lights) h.add(l.body);
  for (const DirectionalLight& l : scene.directional_lights) h.add(l.body);
  if (scene.deformations.empty()) return h.value;
  for (const Mesh& m : scene.meshes) h.add(m.deformation);
  for (const Deformation& d : scene.deformations) add(h, d);
  for (const MovingNode& node : scene.nodes) add(h, node);
  return h.value;
}

}  // namespace saccade
