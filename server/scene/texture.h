// Mip-mapped bitmap, linear colours, trilinear look-up (paper, 4.4.3).
#pragma once

#include <string>
#include <vector>

#include "base/vec.h"

namespace saccade {

// Coordinates repeat with period 1; v = 0 is the bottom row of the picture (the convention of Mitsuba and OBJ).
class Texture {
 public:
  Texture(int width, int height, std::vector<Rgb> linear_pixels);  // row 0 on top; builds the mip chain

  int width() const { return levels_[0].width; }
  int height() const { return levels_[0].height; }
  bool grey() const { return grey_; }

  // Trilinear. `footprint` is the width of the region to average, in units of uv (1 = the whole picture).
  Rgb sample(Vec2 uv, float footprint) const;

 private:
  struct Level {
    int width, height;
    std::vector<Rgb> pixels;
  };
  Rgb bilinear(const Level& level, Vec2 uv) const;
  std::vector<Level> levels_;
  bool grey_;
};

// Reads a picture with OpenImageIO. `raw`: values are linear already; else sRGB-encoded 8/16-bit pictures are
// made linear. Throws SceneError if it cannot be read.
Texture loadTexture(const std::string& path, bool raw);

}  // namespace saccade
