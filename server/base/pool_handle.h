// How a caller runs jobs on a pool of threads: which pool, with which priority, and until when.
#pragma once

#include <algorithm>
#include <utility>

#include "base/tile_pool.h"

namespace saccade {

struct Tile {
  int x0, y0, x1, y1;  // [x0, x1) x [y0, y1)
};
inline constexpr int kBandRows = 8;

// A light value. The pool must outlive it.
class PoolHandle {
 public:
  // Jobs are dropped once `stop` is requested. A pool alone stands for normal jobs that nothing stops.
  PoolHandle(TilePool& pool, Priority priority = Priority::kNormal, std::stop_token stop = {})
      : pool_(&pool), priority_(priority), stop_(std::move(stop)) {}

  // Calls f(i) for i in [0, count) on the workers, in any order. Returns the CPU time of the calls. Throws
  // what a call threw, after all others. Throws Cancelled, without the remaining calls, once the stop is
  // requested.
  template <class F>
  std::chrono::nanoseconds run(int count, const F& f) const {
    TilePool::Job job{count, priority_, stop_, &f,
                      [](const void* context, int i) { (*static_cast<const F*>(context))(i); }};
    return pool_->runJob(job);
  }

  // Calls f(Tile) for every tile of a width x height picture.
  template <class F>
  std::chrono::nanoseconds forEachTile(int width, int height, int edge, const F& f) const {
    const int across = (width + edge - 1) / edge, down = (height + edge - 1) / edge;
    return run(across * down, [&](int i) {
      const int x = i % across * edge, y = i / across * edge;
      f(Tile{x, y, std::min(x + edge, width), std::min(y + edge, height)});
    });
  }

  // Calls f(y) for every row, a band of rows per piece.
  template <class F>
  std::chrono::nanoseconds forEachRow(int height, const F& f) const {
    return run((height + kBandRows - 1) / kBandRows, [&](int band) {
      for (int y = band * kBandRows; y < std::min((band + 1) * kBandRows, height); ++y) f(y);
    });
  }

 private:
  TilePool* pool_;
  Priority priority_;
  std::stop_token stop_;
};

}  // namespace saccade
