// A wall, and a grid that looks at it.
#pragma once

#include <functional>

#include "cache/grid/surface_grid.h"
#include "filter/synthetic.h"

namespace saccade::test {

inline constexpr int kW = 48, kH = 40;
inline constexpr float kPixel = 0.01f;  // on the wall

// A camera slides along a wall z = 0, pixel by pixel of kPixel. Samples of `light` with noise.
struct Wall {
  Frame frame{kW, kH, 1};
  const Obstacles* obstacles = nullptr;
  float noise = 0, unoccluded = 0;
  std::function<float(float)> light = [](float) { return 1.f; };       // of x
  std::function<float(float)> visibility = [](float) { return 1.f; };  // of x
  Vec3 normal{0, 0, 1};
  float footprint_px = 1;

  float xAt(int x, int y) const { return frame.surfaces->place(frame.surfaces->indexOf(x, y)).position.x; }
  void show(float shift_px, std::uint64_t seed) {
    for (int y = 0; y < kH; ++y) {
      for (int x = 0; x < kW; ++x) {
        const float at = (static_cast<float>(x) + shift_px) * kPixel;
        const std::size_t index = frame.surfaces->indexOf(x, y);
        (*frame.surfaces)[index] = {.share = 1, .kind = SurfaceKind::kDiffuse, .paths = 1};
        frame.surfaces->place(index) = {
            {at, static_cast<float>(y) * kPixel, 0}, normal, kPixel * footprint_px, unoccluded};
        SurfaceLight& found = frame.surfaces->light(index);
        found.residual = light(at) + noise * (2 * randomAt(seed, x, y) - 1);
        found.unoccluded = unoccluded * (0.5f + randomAt(seed + 77, x, y));
        found.visible = randomAt(seed + 99, x, y) < visibility(at) ? found.unoccluded : 0;
        frame.g.motion_x.at(x, y) = 1;
      }
    }
  }
};

// Stands on the wall, across it, without any thickness.
struct Curtain final : Obstacles {
  float x = 24 * kPixel;

  Hits find(const ProbeRays& rays) const override {
    Hits met;
    for (int i = 0; i < kRays; ++i) {
      const auto& [from, along, reach] = rays[i];
      const float to_curtain = (x - from.x) / along.x, to_wall = -from.z / along.z;
      if (along.x != 0 && to_curtain > 0 && to_curtain <= reach) met[i] = {to_curtain, {1, 0, 0}};
      if (along.z != 0 && to_wall > 0 && to_wall <= reach) met[i] = {to_wall, {0, 0, 1}};
    }
    return met;
  }
};

struct View {
  explicit View(int threads = 2) : pool(threads) {}

  // Adds a view of the wall; the estimate there is in `now`.
  void look(Wall& wall, float shift_px, std::uint64_t seed) {
    wall.show(shift_px, seed);
    add(wall);
  }
  // The view as it is.
  void add(const Wall& wall) {
    std::swap(at, prev);
    grid.place(*wall.frame.surfaces, wall.obstacles, pool, prev, at);
    grid.learn(grid.readAdded(grid.add({*wall.frame.surfaces, wall.frame.g, at}, pool), pool, now), pool);
  }
  // Root of the mean square of now.i - f(x), and of what the grid says of it.
  std::pair<double, double> errors(const Wall& wall, const std::function<float(float)>& f) const {
    double sum = 0, variance = 0;
    for (int y = 0; y < kH; ++y) {
      for (int x = 0; x < kW; ++x) {
        sum += std::pow(now.i.at(x, y) - f(wall.xAt(x, y)), 2);
        variance += now.var_i.at(x, y);
      }
    }
    return {std::sqrt(sum / (kW * kH)), std::sqrt(variance / (kW * kH))};
  }

  TilePool pool;
  SurfaceGrid grid{{}};
  Placement at, prev;
  GridEstimate now{kW, kH};
};

}  // namespace saccade::test
