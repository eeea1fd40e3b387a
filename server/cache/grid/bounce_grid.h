// Light at the second vertices of paths, kept on surfaces. A path that reaches a cell whose light is known
// takes it, and most end there. So most paths are short, and their light has less noise [ours, after NVIDIA's
// SHaRC].
//
// A sample is what a path of full length finds from its second vertex on. So a path that ends there counts as
// many bounces as one that goes on. Cells are cubes of 8 to 16 pixels as the camera sees them, and the six
// directions of normals have cells of their own.
#pragma once

#include <optional>

#include "cache/lattice/index_table.h"
#include "cache/lattice/lanes.h"
#include "frame/surface_samples.h"

namespace saccade {

struct BounceCell {
  // `pixel`: the width of a pixel at the distance of the point, scene units.
  BounceCell(Vec3 point, Vec3 normal, float pixel);
  std::uint64_t key;
  float edge;  // scene units
};

class BounceGrid {
 public:
  // How many cells are kept beside a grid of so many bytes: they take a sixteenth of that.
  static constexpr std::size_t cellsBeside(std::size_t bytes) { return bytes / 16 / kBytesPerCell; }

  explicit BounceGrid(std::size_t max_cells) : max_cells_(max_cells) {}

  struct Known {
    Rgb light;  // that arrives, as BounceSample has it
    bool well;  // no more samples are wanted
  };
  // Where it is known.
  std::optional<Known> find(const BounceCell& cell) const;
  // Adds a frame's samples, in order.
  void add(const SurfaceSamples& on);
  // Forgets all light: it has changed.
  void forget();
  void limit(std::size_t max_cells) { max_cells_ = max_cells; }

  std::size_t cells() const { return light_.size(); }

  // Its state, by cell.
  std::vector<std::uint64_t> keys() const { return table_.keys(); }
  const std::vector<Quad>& light() const { return light_; }
  // Fills an empty grid with that. False if a key is not valid or stands twice.
  bool restore(const std::vector<std::uint64_t>& keys, const std::vector<Quad>& light);

 private:
  static constexpr std::size_t kBytesPerCell = 64;

  std::size_t max_cells_;  // beyond, no new ones are kept, and their paths go on
  IndexTable table_;
  std::vector<Quad> light_;  // by cell: the number of samples, and their sum for each colour
};

}  // namespace saccade
