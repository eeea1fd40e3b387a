#include "render/world/deformed_shapes.h"

#include <algorithm>

#include "base/content_hash.h"

namespace saccade {
namespace {

std::vector<char> bodiesThatDeform(const Scene& scene) {
  std::vector<char> bodies(scene.bodies.size());
  for (const Mesh& mesh : scene.meshes)
    if (deforms(mesh)) bodies[static_cast<std::size_t>(mesh.body)] = true;
  return bodies;
}

Scene shapesOf(const Scene& scene) {
  const std::vector<char> bodies = bodiesThatDeform(scene);
  const auto isOfOne = [&](const auto& shape) {
    return shape.body != kStands && bodies[static_cast<std::size_t>(shape.body)];
  };
  Scene shapes;
  shapes.materials = scene.materials;
  for (const Mesh& mesh : scene.meshes) shapes.meshes.push_back(isOfOne(mesh) ? mesh : Mesh{});
  for (const Sphere& sphere : scene.spheres) shapes.spheres.push_back(isOfOne(sphere) ? sphere : Sphere{});
  return shapes;
}

void addVertices(const Mesh& mesh, ShapeBox& box) {
  for (std::size_t i = 0; i + 1 < mesh.positions.size(); ++i) box.add(mesh.positions[i]);
}

}  // namespace

bool anyDeforms(const Scene& scene) {
  return std::ranges::any_of(scene.meshes, deforms);
}

DeformedShapes::DeformedShapes(const RenderScene& scene)
    : scene_(scene.description()),
      shapes_(shapesOf(scene_)),
      nodes_(scene_.nodes),
      rows_(scene.shapeRows()),
      trees_(scene_.bodies.size()),
      boxes_(scene_.bodies.size()),
      boxes_of_others_(scene_.bodies.size()),
      changed_(scene_.bodies.size()) {
  const std::vector<char> bodies = bodiesThatDeform(scene_);
  using Shapes = EmbreeScene::Shapes;
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    if (!bodies[body]) continue;
    const auto tree = [&](Shapes kind) {
      return EmbreeScene(shapes_, kind, static_cast<int>(body), scene.deviceOfBodies(),
                         EmbreeScene::Form::kChanges);
    };
    trees_[body].reset(new Trees{tree(Shapes::kAll), tree(Shapes::kStraight)});
  }
  for (std::uint32_t i = 0; i < shapes_.meshes.size(); ++i) {
    const Mesh& mesh = shapes_.meshes[i];
    if (deforms(mesh))
      parts_.push_back({i});
    else if (mesh.body != kStands)
      addVertices(mesh, boxes_of_others_[static_cast<std::size_t>(mesh.body)]);
  }
  for (const Sphere& sphere : shapes_.spheres)
    if (sphere.body != kStands) boxes_of_others_[static_cast<std::size_t>(sphere.body)].add(sphere);
}

// Returns whether the form is another one now.
bool DeformedShapes::change(Part& part, TimeNs t) {
  Mesh& mesh = shapes_.meshes[part.geometry];
  const Deformation& deformation = scene_.deformations[static_cast<std::size_t>(mesh.deformation)];
  setForm(deformation, nodes_, t, next_);
  if (next_ == part.form) return false;
  part.form = next_;  // a copy: a swap would give parts of other sizes memory that is too small
  deform(deformation, part.form, mesh.positions, mesh.normals);
  ShapeRow& row = rows_[part.geometry];
  row.edge = longestEdge(mesh);
  if (row.normals) row.normals = mesh.normals.data();
  return true;
}

void DeformedShapes::setTime(TimeNs t) {
  std::ranges::fill(changed_, false);
  for (Part& part : parts_)
    if (change(part, t)) changed_[static_cast<std::size_t>(shapes_.meshes[part.geometry].body)] = true;
  for (std::size_t body = 0; body < trees_.size(); ++body) {
    if (!changed_[body]) continue;
    trees_[body]->all.update(), trees_[body]->straight.update();
    boxes_[body] = boxes_of_others_[body];
  }
  for (const Part& part : parts_) {
    const Mesh& mesh = shapes_.meshes[part.geometry];
    const auto body = static_cast<std::size_t>(mesh.body);
    if (changed_[body]) addVertices(mesh, boxes_[body]);
  }
}

bool DeformedShapes::equals(const DeformedShapes& other) const {
  return parts_ == other.parts_;
}

bool DeformedShapes::equals(const DeformedShapes& other, std::size_t body) const {
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const Mesh& mesh = shapes_.meshes[parts_[i].geometry];
    if (static_cast<std::size_t>(mesh.body) == body && !(parts_[i] == other.parts_[i])) return false;
  }
  return true;
}

std::uint64_t DeformedShapes::state(std::uint64_t other) const {
  ContentHash h{other};
  for (const Part& part : parts_) h.add(part.form.weights), h.add(part.form.joints);
  return h.value;
}

}  // namespace saccade
