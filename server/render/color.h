// Light in one channel or three, as the scene's colours need.
#pragma once

#include "base/lane.h"
#include "base/vec.h"

namespace saccade {

template <int Channels>
struct Color;

template <>
struct Color<1> {
  Lane y = 0;
  Color() = default;
  explicit Color(Lane v) : y(v) {}
  explicit Color(Rgb c) : y(saccade::luminance(c)) {}
  Lane luminance() const { return y; }
  Rgb rgb() const { return {y, y, y}; }
  Color operator*(Color b) const { return Color(y * b.y); }
  Color operator*(Lane s) const { return Color(y * s); }
  Color& operator+=(Color b) { return y += b.y, *this; }
};

template <>
struct Color<3> {
  Vec3T<Lane> c;
  Color() = default;
  explicit Color(Lane v) : c{v, v, v} {}
  explicit Color(Rgb v) : c(v) {}
  Lane luminance() const { return saccade::luminance(c); }
  Rgb rgb() const { return c; }
  Color operator*(Color b) const { return Color(c * b.c); }
  Color operator*(Lane s) const { return Color(c * s); }
  Color& operator+=(Color b) { return c = c + b.c, *this; }
};

}  // namespace saccade
