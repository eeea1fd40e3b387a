// The vertices that a frame adds to a level.
#pragma once

#include <cstdint>
#include <vector>

#include "cache/grid/vertex_table.h"

namespace saccade {

struct NewVertices {
  // A vertex, and the point that asked for it first, an index into Placement::points.
  struct Vertex {
    VertexKey key;
    VertexTable::Place place;
    std::uint32_t index, point;
  };
  // Taps that have one of them. `tap`: their place in their slot.
  struct Tap {
    std::uint32_t point, tap;
  };
  std::vector<Vertex> vertices;
  std::vector<Tap> taps;

  void clear() { vertices.clear(), taps.clear(); }
};

}  // namespace saccade
