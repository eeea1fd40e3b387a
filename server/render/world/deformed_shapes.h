// The shapes of bodies that deform, as they are at one time, in the place that the scene file gives them.
#pragma once

#include <memory>
#include <vector>

#include "render/world/render_scene.h"
#include "scene/shape_box.h"

namespace saccade {

// Of the bodies with a mesh that deforms. All shapes of such a body have trees of their own here.
class DeformedShapes {
 public:
  explicit DeformedShapes(const RenderScene& scene);
  DeformedShapes(const DeformedShapes&) = delete;
  DeformedShapes& operator=(const DeformedShapes&) = delete;

  // Takes a time in proportion to the vertices and triangles that have changed.
  void setTime(TimeNs t);

  struct Trees {
    EmbreeScene all, straight;
  };
  const Trees* trees(std::size_t body) const { return trees_[body].get(); }  // nullptr: it keeps its form
  const ShapeBox& box(std::size_t body) const { return boxes_[body]; }       // around a body that deforms
  // By the id of a geometry; nullptr: it keeps its form.
  const Mesh* mesh(std::uint32_t geometry) const {
    const bool changes = geometry < shapes_.meshes.size() && deforms(shapes_.meshes[geometry]);
    return changes ? &shapes_.meshes[geometry] : nullptr;
  }
  const std::vector<ShapeRow>& rows() const { return rows_; }  // of all shapes of the scene

  bool equals(const DeformedShapes& other) const;
  bool equals(const DeformedShapes& other, std::size_t body) const;
  std::uint64_t state(std::uint64_t other) const;  // a number for all forms, joined with `other`

 private:
  struct Part {
    std::uint32_t geometry;
    MeshForm form = {};
    friend bool operator==(const Part&, const Part&) = default;
  };
  bool change(Part& part, TimeNs t);

  const Scene& scene_;
  Scene shapes_;  // other meshes are empty, so that ids stay
  NodePoses nodes_;
  std::vector<Part> parts_;  // the meshes that deform
  MeshForm next_;
  std::vector<ShapeRow> rows_;
  std::vector<std::unique_ptr<Trees>> trees_;      // by body
  std::vector<ShapeBox> boxes_, boxes_of_others_;  // by body; of others: of its shapes that keep their form
  std::vector<char> changed_;                      // by body
};

// Whether some body of the scene deforms.
bool anyDeforms(const Scene& scene);

}  // namespace saccade
