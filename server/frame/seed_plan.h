// The seeds and the numbers of paths of both passes of a frame (paper, 4.3).
#pragma once

#include "base/hash_rng.h"
#include "base/units.h"

namespace saccade {

// How random numbers fill space.
enum class NumberKind {
  kEven,         // evenly, within a pixel and over neighbours
  kIndependent,  // by chance
};

struct SeedPlan {
  std::uint64_t seed1, seed2;         // of pass 1 and pass 2
  int spp1, spp2;                     // paths per pixel in each
  FrameIndex frame1 = 0, frame2 = 0;  // whose seeds they are; with jitter also whose points of the pixel
  std::uint64_t stream = 0;           // the seed of all frames, for paths that start at SurfaceSamples
  NumberKind numbers = NumberKind::kEven;
  // Of a picture whose paths come in parts: those of each pass before this part, and in all parts.
  int before = 0, all = 0;
  bool along_motion = false;  // pass 1 replays pixelBefore(), its point and its numbers, not the same pixel
  bool reconnects = false;    // pass 1 reconnects paths of both frames, where it can

  // r_t: the seed of frame t.
  static std::uint64_t frameSeed(std::uint64_t stream_seed, FrameIndex t) { return hashKey(stream_seed, t); }

  // Pass 1 replays the seed and the jitter of the previous frame. Pass 2 uses those of this frame [E (8)].
  static SeedPlan correlated(std::uint64_t stream_seed, FrameIndex t, int spp) {
    return {frameSeed(stream_seed, t - 1), frameSeed(stream_seed, t), spp / 2, spp / 2, t - 1, t};
  }
  // Correlated passes in which points of surfaces keep the numbers of one frame ago (Schied et al. 2018).
  static SeedPlan correlatedAlongMotion(std::uint64_t stream_seed, FrameIndex t, int spp) {
    SeedPlan plan = correlated(stream_seed, t, spp);
    plan.along_motion = true;
    return plan;
  }
  // Correlated passes, of which pass 1 reconnects paths at their second vertices. A jittered pass 1 does not.
  static SeedPlan reconnected(std::uint64_t stream_seed, FrameIndex t, int spp) {
    SeedPlan plan = correlated(stream_seed, t, spp);
    plan.reconnects = true;
    return plan;
  }
  // Both passes use seeds that no other frame uses.
  static SeedPlan independentPairs(std::uint64_t stream_seed, FrameIndex t, int spp) {
    return {hashKey(frameSeed(stream_seed, t), 1), frameSeed(stream_seed, t), spp / 2, spp / 2, t, t};
  }
  // All paths are in pass 2.
  static SeedPlan independent(std::uint64_t stream_seed, FrameIndex t, int spp) {
    return {0, frameSeed(stream_seed, t), 0, spp, t, t, stream_seed};
  }
  // One of these with independent numbers.
  template <SeedPlan (*kPlan)(std::uint64_t, FrameIndex, int)>
  static SeedPlan byChance(std::uint64_t stream_seed, FrameIndex t, int spp) {
    SeedPlan plan = kPlan(stream_seed, t, spp);
    plan.numbers = NumberKind::kIndependent;
    return plan;
  }
};

}  // namespace saccade
