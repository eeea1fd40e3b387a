// The data that lanes read of the shapes that rays hit: a row for each, by its geometry id.
#pragma once

#include <array>
#include <vector>

#include "scene/scene.h"

namespace saccade {

struct alignas(64) ShapeRow {
  // Of a sphere: nullptr.
  const std::array<std::uint32_t, 3>* triangles = nullptr;
  const Vec3* normals = nullptr;  // nullptr: as the triangles lie
  Rgb reflectance;                // of a diffuse surface without texture
  bool textured, twosided, emits;
  bool plain;      // diffuse and opaque, without a bump map
  float edge = 0;  // the longest of its triangles; of a sphere its diameter, scene units
};

std::vector<ShapeRow> shapeRows(const Scene& scene);

float longestEdge(const Mesh& mesh);  // 0 of a mesh without triangles

}  // namespace saccade
