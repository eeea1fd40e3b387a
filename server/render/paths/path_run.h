// The paths of a tile, traced batch by batch.
#pragma once

#include "base/instruction_set.h"
#include "base/scratch.h"
#include "base/tile_pool.h"
#include "render/paths/begin_plain.h"
#include "render/paths/trace_batch.h"

namespace saccade {

template <int C>
struct PathMemory {
  LivePaths<C> now, next;
  PathResults<C> results;
  std::array<std::uint32_t, kBatchPaths> owners;
};

// A path's own data, wherever it begins.
struct NewPath {
  PathSampler sampler;
  std::uint32_t owner = 0;
  bool touched = false;  // see PathResults
};

// Takes paths, and tells what each has found in the order in which they were added.
template <Shading S, int C, bool kSplit, class OnPath>
class PathRun {
 public:
  // on_path(owner, results, slot) is called once for each path.
  PathRun(const Tracing& t, const OnPath& on_path) : t_(t), on_path_(on_path) { memory_->now.count = 0; }

  void add(const PathStart& start, const NewPath& path) {
    if (memory_->now.count == kBatchPaths) finish();
    const auto slot = static_cast<std::uint32_t>(memory_->now.count);
    memory_->owners[slot] = path.owner;
    clear(slot, path.touched);
    stages_.begin(start, path.sampler, slot, memory_->now);
  }

  // A path for each lane of a set, at plain surfaces, with path(lane).
  void addPlain(const PlainSurfaces& surfaces, LaneSet lanes, float spread, const auto& path) {
    LivePaths<C>& now = memory_->now;
    if (now.count + lanes.size() > kBatchPaths) finish();
    auto slot = static_cast<std::uint32_t>(now.count);
    beginPlain<C>(surfaces, lanes, spread, S.extras, now);
    forEachLane(lanes, [&](int lane) {
      const NewPath own = path(lane);
      now.reversed_index[slot] = own.sampler.reversed_index, now.path_key[slot] = own.sampler.key,
      now.slot[slot] = slot;
      memory_->owners[slot] = own.owner;
      clear(slot++, own.touched);
    });
  }

  // Traces those that have not been. Lets urgent work in.
  void finish() {
    const auto count = static_cast<std::uint32_t>(memory_->now.count);
    if (count == 0) return;
    if (!t_.scene.lights().empty()) tracer()(t_, stages_, memory_->now, memory_->next, memory_->results);
    for (std::uint32_t slot = 0; slot < count; ++slot)
      on_path_(memory_->owners[slot], memory_->results, slot);
    memory_->now.count = 0;
    TilePool::yieldToHighPriority();
  }

 private:
  static TraceBatch<C> tracer() {
    return instructionSet() == InstructionSet::kAvx512 ? batchTracerAvx512<C>(S.extras, kSplit)
                                                       : batchTracerAvx2<C>(S.extras, kSplit);
  }
  void clear(std::uint32_t slot, bool touched) {
    PathResults<C>& r = memory_->results;
    const Color<C> black;
    r.radiance.set(slot, black);
    if constexpr (kSplit) {
      r.unoccluded.set(slot, black), r.visible.set(slot, black), r.mis_weighted.set(slot, black);
      r.suffix_cell[slot] = 0, r.touched[slot] = touched;
    }
  }

  const Tracing& t_;
  const SurfaceStages<C> stages_ = surfaceStages<S, C, kSplit>();
  const OnPath& on_path_;
  Scratch<PathMemory<C>> memory_;
};

}  // namespace saccade
