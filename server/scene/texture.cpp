#include "scene/texture.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace saccade {
namespace {

// The run of fine pixels under one coarse pixel, and how much of the first and the last is under it.
struct Cover {
  int first, last;
  float first_part, last_part, total;
};

Cover coverOf(int coarse, int coarse_count, int fine_count) {
  const double scale = static_cast<double>(fine_count) / coarse_count;
  const double begin = coarse * scale, end = (coarse + 1) * scale;
  const int first = static_cast<int>(begin),
            last = std::min(static_cast<int>(std::ceil(end)), fine_count) - 1;
  return {first, last, static_cast<float>(first + 1 - begin), static_cast<float>(end - last),
          static_cast<float>(scale)};
}

float part(const Cover& c, int i) {
  return i == c.first ? c.first_part : i == c.last ? c.last_part : 1.0f;
}

// Wraps to [0, 1); 0 where the value is not finite.
float wrap(float u) {
  const float f = u - std::floor(u);
  return f >= 0 && f < 1 ? f : 0;
}

// A coordinate brought into [0, 1].
float within(float u, Texture::Wrap kind) {
  if (kind == Texture::Wrap::kRepeat) return wrap(u);
  if (kind == Texture::Wrap::kClamp) return u > 0 ? std::min(u, 1.f) : 0;
  const float period = 2 * wrap(u / 2);
  return period > 1 ? 2 - period : period;
}

// The two pixels around a coordinate in [0, 1], and the weight of the second. Where a picture does not
// repeat, no tap crosses an edge.
struct Taps {
  Taps(float u, int count, bool repeats) {
    const float x = u * static_cast<float>(count) - 0.5f;
    const int i = static_cast<int>(std::floor(x)), last = count - 1;
    i0 = i >= 0 ? i : repeats ? last : 0;
    i1 = i < last ? i + 1 : repeats ? 0 : last;
    w1 = x - static_cast<float>(i);
  }
  int i0, i1;
  float w1;
};

Rgb mix(Rgb a, Rgb b, float w) {
  return a + (b - a) * w;
}

}  // namespace

Texture::Texture(int width, int height, std::vector<Rgb> linear_pixels) {
  SACCADE_CHECK(width > 0 && height > 0);
  SACCADE_CHECK(linear_pixels.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  grey_ =
      std::all_of(linear_pixels.begin(), linear_pixels.end(), [](Rgb c) { return c.x == c.y && c.y == c.z; });
  levels_.push_back({width, height, std::move(linear_pixels)});
  while (levels_.back().width > 1 || levels_.back().height > 1) levels_.push_back(halve(levels_.back()));
}

// Averages over areas, which keeps the mean where a side is odd.
Texture::Level Texture::halve(const Level& fine) {
  Level coarse{std::max(1, fine.width / 2), std::max(1, fine.height / 2), {}};
  coarse.pixels.reserve(static_cast<std::size_t>(coarse.width) * static_cast<std::size_t>(coarse.height));
  for (int y = 0; y < coarse.height; ++y) {
    const Cover rows = coverOf(y, coarse.height, fine.height);
    for (int x = 0; x < coarse.width; ++x) {
      const Cover columns = coverOf(x, coarse.width, fine.width);
      Rgb sum;
      for (int j = rows.first; j <= rows.last; ++j) {
        const Rgb* row = &fine.pixels[static_cast<std::size_t>(j) * static_cast<std::size_t>(fine.width)];
        for (int i = columns.first; i <= columns.last; ++i)
          sum = sum + row[i] * (part(rows, j) * part(columns, i));
      }
      coarse.pixels.push_back(sum / (rows.total * columns.total));
    }
  }
  return coarse;
}

// `uv`: within() its bounds, from the top.
inline Rgb Texture::bilinear(const Level& level, Vec2 uv) const {
  const Taps x(uv.x, level.width, wrap_u_ == Wrap::kRepeat), y(uv.y, level.height, wrap_v_ == Wrap::kRepeat);
  const Rgb* row0 = &level.pixels[static_cast<std::size_t>(y.i0) * static_cast<std::size_t>(level.width)];
  const Rgb* row1 = &level.pixels[static_cast<std::size_t>(y.i1) * static_cast<std::size_t>(level.width)];
  return mix(mix(row0[x.i0], row0[x.i1], x.w1), mix(row1[x.i0], row1[x.i1], x.w1), y.w1);
}

Rgb Texture::sample(Vec2 uv, float footprint) const {
  const Vec2 at{within(uv.x, wrap_u_), within(1 - uv.y, wrap_v_)};
  const float pixels = footprint * static_cast<float>(std::max(width(), height()));
  const float coarsest = static_cast<float>(levels_.size() - 1);
  const float level = pixels > 1 ? std::min(std::log2(pixels), coarsest) : 0;
  const std::size_t fine = static_cast<std::size_t>(level);
  const float w = level - static_cast<float>(fine);
  const Rgb color = bilinear(levels_[fine], at);
  return w > 0 ? mix(color, bilinear(levels_[fine + 1], at), w) : color;
}

Rgb Texture::mean() const {
  Vec3d sum;
  for (const Rgb c : pixels()) sum = sum + toDouble(c);
  return toFloat(sum / static_cast<double>(pixels().size()));
}

std::size_t Texture::bytes() const {
  std::size_t count = 0;
  for (const Level& level : levels_) count += level.pixels.size();
  return count * sizeof(Rgb);
}

Texture loadTexture(const std::string& path, PixelUse use) {
  Picture picture = loadPicture(path, use);
  return Texture(picture.width, picture.height, std::move(picture.pixels));
}

}  // namespace saccade
