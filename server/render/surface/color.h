// Light in one channel or three, as the scene's colours need.
#pragma once

#include "base/vec.h"

namespace saccade {

template <int Channels>
struct Color;

template <>
struct Color<1> {
  float y = 0;
  Color() = default;
  explicit Color(float v) : y(v) {}
  explicit Color(Rgb c) : y(saccade::luminance(c)) {}
  float luminance() const { return y; }
  Rgb rgb() const { return {y, y, y}; }
  Color operator*(Color b) const { return Color(y * b.y); }
  Color operator*(float s) const { return Color(y * s); }
  Color& operator+=(Color b) { return y += b.y, *this; }
};

template <>
struct Color<3> {
  Vec3 c;
  Color() = default;
  explicit Color(float v) : c{v, v, v} {}
  explicit Color(Rgb v) : c(v) {}
  float luminance() const { return saccade::luminance(c); }
  Rgb rgb() const { return c; }
  Color operator*(Color b) const { return Color(c * b.c); }
  Color operator*(float s) const { return Color(c * s); }
  Color& operator+=(Color b) { return c = c + b.c, *this; }
};

}  // namespace saccade
