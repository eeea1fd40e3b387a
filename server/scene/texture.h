// Mip-mapped bitmap, linear colours, trilinear look-up (paper, 4.4.3).
#pragma once

#include <string>
#include <vector>

#include "base/vec.h"
#include "scene/files/picture.h"

namespace saccade {

// Coordinates repeat with period 1 unless said otherwise, and v = 0 is the bottom edge of the picture, as in
// Mitsuba and OBJ. The centre of pixel i of n lies at (i + 0.5) / n. Every level has the mean of the whole
// picture.
class Texture {
 public:
  Texture(int width, int height, std::vector<Rgb> linear_pixels);  // row 0 on top; builds the mip chain

  // Beyond [0, 1] a picture repeats, or every second one is mirrored, or its edge goes on.
  enum class Wrap { kRepeat, kMirror, kClamp };
  void setWrap(Wrap u, Wrap v) { wrap_u_ = u, wrap_v_ = v; }
  Wrap wrapU() const { return wrap_u_; }
  Wrap wrapV() const { return wrap_v_; }

  int width() const { return levels_[0].width; }
  int height() const { return levels_[0].height; }
  bool grey() const { return grey_; }
  const std::vector<Rgb>& pixels() const { return levels_[0].pixels; }  // row 0 on top
  Rgb mean() const;                                                     // of all pixels
  std::size_t bytes() const;                                            // in memory, with the mip chain

  bool mipMapped() const { return levels_.size() > 1; }
  // Drops all levels but the finest. From then on a look-up is bilinear, whatever its footprint.
  void dropMips() { levels_.erase(levels_.begin() + 1, levels_.end()); }

  // Trilinear: bilinear within a level, linear between the two whose pixels are nearest to the footprint in
  // size. `footprint` is the width of the region to average, in units of uv (1 = the whole picture); 0: the
  // finest level.
  Rgb sample(Vec2 uv, float footprint) const;

 private:
  struct Level {
    int width, height;
    std::vector<Rgb> pixels;
  };
  static Level halve(const Level& fine);
  Rgb bilinear(const Level& level, Vec2 uv) const;

  std::vector<Level> levels_;
  Wrap wrap_u_ = Wrap::kRepeat, wrap_v_ = Wrap::kRepeat;
  bool grey_;
};

// Throws as loadPicture() does.
Texture loadTexture(const std::string& path, PixelUse use);

}  // namespace saccade
