// Light from infinitely far away: the radiance of a direction, and samples of directions.
#pragma once

#include <array>
#include <vector>

#include "base/vec.h"
#include "scene/light.h"

namespace saccade {

struct EnvironmentSample {
  Vec3 direction;  // away from the scene, unit
  Rgb radiance;
  float pdf;  // per solid angle; 0: all directions are black
};

// The picture is interpolated bilinearly between the centres of its pixels. It is continuous around the
// horizon. Its first and last row reach to the poles.
// Directions are sampled from a table [Pharr et al., 14.2.4]. Each cell of the table lies between four
// centres. The probability of a cell is proportional to its solid angle times the mean luminance of its
// corners. A direction within a cell is uniform.
// So the pdf is above 0 wherever light comes from. Radiance over pdf is at most four times its mean over the
// cell. An environment of one colour is a picture of one pixel.
class EnvironmentLight {
 public:
  // Keeps a pointer to the pixels of `environment`.
  explicit EnvironmentLight(const Environment& environment);

  // Directions are unit vectors in the world.
  Rgb radiance(Vec3 direction) const;
  EnvironmentSample sample(float u1, float u2) const;  // of numbers in [0, 1)
  float pdf(Vec3 direction) const;                     // of sample()

  // The mean over all directions, from the means of the cells. Its relative error is about 1 / height^2.
  float meanLuminance() const { return mean_luminance_; }

 private:
  // The corners are the left and right one of the upper row, then of the lower row. `x` and `y` are a place
  // between them.
  struct Cell {
    std::array<Rgb, 4> corners;  // radiance
    float x, y;
  };
  Cell cellAt(Vec3 direction) const;
  static Rgb radianceIn(const Cell& cell);
  float pdfIn(const Cell& cell) const;
  Rgb corner(int column, int row) const;  // at most one beyond the edge
  std::array<Rgb, 4> cornersOf(int column, int row) const;
  float shareAbove(int row) const;

  const Rgb* pixels_;
  int width_, height_;
  Rgb factor_;
  Vec3 x_, y_, z_;  // axes of the picture's space in the world
  // Cell (column, row), in [0, width) x [0, height], lies right of and above the centre of pixel (column,
  // row). These are running sums that rise to 1, or stay 0 where all is black:
  std::vector<float> row_cdf_;
  std::vector<float> column_cdf_;  // row after row
  float mean_luminance_ = 0;
};

}  // namespace saccade
