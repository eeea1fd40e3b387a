// Light from infinitely far away: how much comes from a direction, and directions it comes from.
#pragma once

#include <array>
#include <vector>

#include "base/vec.h"
#include "scene/light.h"

namespace saccade {

struct EnvironmentSample {
  Vec3 direction;  // away from the scene, unit
  Rgb radiance;
  float pdf;  // per solid angle; 0: nothing comes from anywhere
};

// The picture is looked up bilinearly between the centres of its pixels; it goes on around the horizon, and
// ends with its first and last row at the poles. Directions are drawn from a table [Pharr et al., 14.2.4]
// with one cell between each four centres: a cell is chosen by its solid angle times the mean luminance of
// its corners, a direction within it uniformly. So the pdf is above 0 wherever light comes from, and radiance
// over pdf is at most four times what it is on average over the cell. One colour is a picture of one pixel.
class EnvironmentLight {
 public:
  // Shares the pixels of `environment`, which are to stay where they are.
  explicit EnvironmentLight(const Environment& environment);

  // Directions are unit vectors in the world.
  Rgb radiance(Vec3 direction) const;
  EnvironmentSample sample(float u1, float u2) const;  // of numbers in [0, 1)
  float pdf(Vec3 direction) const;                     // of sample()

  // Over all directions, by the means of the cells: true to 1 / height^2 of it.
  float meanLuminance() const { return mean_luminance_; }

 private:
  // The corners of a cell, left and right of the upper row, then of the lower; `x`, `y`: place between them.
  struct Cell {
    std::array<Rgb, 4> corners;  // radiance
    float x, y;
  };
  Cell cellAt(Vec3 direction) const;
  static Rgb radianceIn(const Cell& cell);
  float pdfIn(const Cell& cell) const;
  Rgb corner(int column, int row) const;  // one beyond the edge at most
  std::array<Rgb, 4> cornersOf(int column, int row) const;
  float shareAbove(int row) const;

  const Rgb* pixels_;
  int width_, height_;
  Rgb factor_;
  Vec3 x_, y_, z_;  // axes of the picture's space in the world
  // Cell (column, row), in [0, width) x [0, height], lies right of and above the centre of pixel (column,
  // row). Running sums, ascending to 1 (to 0 where all is black):
  std::vector<float> row_cdf_;
  std::vector<float> column_cdf_;  // row after row
  float mean_luminance_ = 0;
};

}  // namespace saccade
