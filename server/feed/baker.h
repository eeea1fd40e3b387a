// Computes the light of a scene ahead. Passes over the poses of the plan add paths where the light is not
// known well enough yet.
#pragma once

#include <string>
#include <string_view>

#include "cache/bake/baked_light.h"
#include "cache/grid/bounce_grid.h"
#include "feed/bake_plan.h"

namespace saccade {

class Baker {
 public:
  // Shares `scene`.
  Baker(std::shared_ptr<const RenderScene> scene, BakePlan plan);

  // One pass. After an exception it cannot go on.
  void pass(const PoolHandle& pool);
  bool isDone() const;
  double share() const;  // of the work that is done, estimated, [0, 1]
  // The share of the pixels of the last pass whose light was known as well as asked, before they got paths.
  double known() const { return pass_.known; }
  int passes() const { return static_cast<int>(pass_.count); }
  // Of the plan's poses, those before the first for which memory did not suffice.
  std::size_t poses() const { return pass_.poses; }
  bool isFull() const { return pass_.shifts != 0; }  // memory sufficed for nothing new after some passes
  std::size_t vertices() const { return grid_.vertices(); }

  // The state between two passes. A new Baker of the same plan goes on from there as this one would. Throws
  // std::runtime_error where it is none.
  std::string state() const;
  void restore(std::string_view state);

  // Read by feeds.
  std::shared_ptr<const BakedLight> light(const PoolHandle& pool) const;

 private:
  Camera cameraAt(std::size_t pose) const;
  // Finds the surfaces, and plans their paths. False where memory does not suffice for them.
  std::optional<SurfaceFrame> look(std::size_t pose, const PoolHandle& pool);
  void planPaths();
  // Starts again with cells of twice the size, if the first pass found too little memory for them all.
  bool useLargerCells();

  PosedScene posed_;  // with steady lamps
  BakePlan plan_;
  Lens lens_;
  Renderer renderer_;
  struct Passes {
    std::uint64_t count = 0, poses = 0;
    std::uint64_t shifts = 0;        // of the pixels, for which memory sufficed; 0: for all so far
    std::uint64_t larger_cells = 0;  // whether memory did not suffice for the finest
    double known = 0, done = 0;
  } pass_;
  std::size_t max_vertices_;
  SurfaceGrid grid_;
  BounceGrid bounces_;
  Frame frame_;
  Placement at_, none_;
  GridEstimate estimate_;
  ImageF uncertainty_;
  double pixels_ = 0, below_ = 0, progress_ = 0;  // of a pass: sums over the pixels that show a surface
};

}  // namespace saccade
