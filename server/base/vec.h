// Small vectors. Plain structs, passed by value.
#pragma once

#include <cmath>

namespace saccade {

struct Vec2 {
  float x = 0, y = 0;
};

template <class T>
struct Vec3T {
  T x{}, y{}, z{};

  friend bool operator==(const Vec3T&, const Vec3T&) = default;
};
using Vec3 = Vec3T<float>;
using Vec3d = Vec3T<double>;

template <class T>
constexpr Vec3T<T> operator+(Vec3T<T> a, Vec3T<T> b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
constexpr Vec3T<T> operator-(Vec3T<T> a, Vec3T<T> b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
constexpr Vec3T<T> operator*(Vec3T<T> a, Vec3T<T> b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}
template <class T>
constexpr Vec3T<T> operator-(Vec3T<T> a) {
  return {-a.x, -a.y, -a.z};
}
template <class T>
constexpr Vec3T<T> operator*(Vec3T<T> a, T s) {
  return {a.x * s, a.y * s, a.z * s};
}
template <class T>
constexpr Vec3T<T> operator*(T s, Vec3T<T> a) {
  return a * s;
}
template <class T>
constexpr Vec3T<T> operator/(Vec3T<T> a, T s) {
  return a * (T(1) / s);
}

template <class T>
constexpr T dot(Vec3T<T> a, Vec3T<T> b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
constexpr Vec3T<T> cross(Vec3T<T> a, Vec3T<T> b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T>
T length(Vec3T<T> a) {
  return std::sqrt(dot(a, a));
}
template <class T>
Vec3T<T> normalize(Vec3T<T> a) {
  return a / length(a);
}

// The same vector in all lanes of F; of a float, the vector itself.
template <class F>
constexpr Vec3T<F> splat(Vec3 v) {
  return {F(v.x), F(v.y), F(v.z)};
}

inline Vec3 toFloat(Vec3d a) {
  return {static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(a.z)};
}
inline Vec3d toDouble(Vec3 a) {
  return {a.x, a.y, a.z};
}

using Rgb = Vec3;

// Rec. 709 luminance of a linear colour.
template <class F>
F luminance(Vec3T<F> c) {
  return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z;
}
inline float luminance(Rgb c) {
  return luminance<float>(c);
}

}  // namespace saccade
