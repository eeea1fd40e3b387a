// The truth of tasks: how surfaces and the camera move, which surfaces are bodies, and how bright they are.
#pragma once

#include <vector>

#include "eval/bench/bench.h"

namespace saccade::eval {

// A frame at t1, and the interval from the frame before at t0. Planes are of the frame, one value per pixel.
struct TruthFrame {
  TimeNs t0{0}, t1{0};
  ImageF z;                   // depth, scene units; kMissDepth where no surface is
  ImageF flow_x, flow_y;      // of the surface, mean over the interval, pixels per second
  Image<std::uint32_t> body;  // 1 where a body is shown at t0 or t1, else 0
  ImageF L;                   // log(I_eps + I)
  Velocity camera;            // in its own axes, in the middle of the interval
};

struct TaskTruth {
  CameraModel camera;
  ImageF L_start;                  // at the t0 of the first frame
  std::vector<TruthFrame> frames;  // at least one, each from the end of the one before

  // The frame in whose interval `t` lies; before all the first, and after all the last.
  const TruthFrame& frameAt(TimeNs t) const;
  // Pixels per second. Of the nearest surface within a pixel of (x, y), because an edge belongs to the
  // surface in front. A position outside the picture counts as the nearest pixel.
  Vec2 flowAt(Vec2 position, TimeNs t) const;
  float depthAt(Vec2 position, TimeNs t) const;  // of the same surface, scene units
  // Where a point that is at `position` at `from` is at `to`, which is not before: it follows the flow.
  Vec2 carried(Vec2 position, TimeNs from, TimeNs to) const;

  bool hasBodies() const;  // whether some pixels show a body, and others do not
  bool onlyTurns() const;  // whether the camera turns, and moves in no other way
  bool goes() const;       // whether the camera changes its place in all frames
};

// log(I_eps + I) by pixel.
ImageF logPicture(const ImageF& I, double bias);

// Of the scored frames of `bench`, which has a truth. `bias`: I_eps. Throws Interrupted.
TaskTruth truthOf(const Bench& bench, double bias, TilePool& pool);

}  // namespace saccade::eval
