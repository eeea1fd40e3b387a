#include "render/lights/environment_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace saccade {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr Rgb kOnePixel{1, 1, 1};

float meanLuminance(const std::array<Rgb, 4>& corners) {
  return luminance(corners[0] + corners[1] + corners[2] + corners[3]) / 4;
}

// Scales running sums so that they end at 1, unless all are 0. Returns the old last sum.
double normalizeSums(std::vector<double>& sums, std::vector<float>& cdf) {
  const double whole = sums.back();
  for (const double sum : sums) cdf.push_back(static_cast<float>(whole > 0 ? sum / whole : 0));
  return whole;
}

// An interval of a running sum, and the position of u within it, in [0, 1].
struct Choice {
  int index;
  float within;
};

Choice choose(const float* cdf, int count, float u) {
  const int i = static_cast<int>(std::upper_bound(cdf, cdf + count - 1, u) - cdf);
  const float begin = i > 0 ? cdf[i - 1] : 0;
  return {i, (u - begin) / (cdf[i] - begin)};
}

}  // namespace

EnvironmentLight::EnvironmentLight(const Environment& environment)
    : pixels_(environment.picture.pixels.data()),
      width_(environment.picture.width),
      height_(environment.picture.height),
      factor_(environment.radiance),
      x_(toFloat(environment.to_world.x)),
      y_(toFloat(environment.to_world.y)),
      z_(toFloat(environment.to_world.z)) {
  if (environment.picture.pixels.empty()) pixels_ = &kOnePixel, width_ = height_ = 1;
  std::vector<double> rows, columns;  // running sums
  for (int row = 0; row <= height_; ++row) {
    columns.clear();
    for (int column = 0; column < width_; ++column)
      columns.push_back((columns.empty() ? 0 : columns.back()) +
                        saccade::meanLuminance(cornersOf(column, row)));
    const double of_sphere = static_cast<double>(shareAbove(row + 1) - shareAbove(row)) / width_;
    rows.push_back((rows.empty() ? 0 : rows.back()) + normalizeSums(columns, column_cdf_) * of_sphere);
  }
  mean_luminance_ = static_cast<float>(normalizeSums(rows, row_cdf_));
}

Rgb EnvironmentLight::corner(int column, int row) const {
  const int x = column < 0 ? width_ - 1 : column == width_ ? 0 : column, y = std::clamp(row, 0, height_ - 1);
  return pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                 static_cast<std::size_t>(x)] *
         factor_;
}

std::array<Rgb, 4> EnvironmentLight::cornersOf(int column, int row) const {
  return {corner(column, row - 1), corner(column + 1, row - 1), corner(column, row), corner(column + 1, row)};
}

// The share of the sphere above the upper edge of a row of cells: sin^2 of half the polar angle.
float EnvironmentLight::shareAbove(int row) const {
  const float v = std::clamp((static_cast<float>(row) - 0.5f) / static_cast<float>(height_), 0.f, 1.f);
  const float s = std::sin(kPi / 2 * v);
  return s * s;
}

EnvironmentLight::Cell EnvironmentLight::cellAt(Vec3 direction) const {
  const Vec3 d{dot(direction, x_), dot(direction, y_), dot(direction, z_)};
  const float azimuth = std::atan2(d.x, -d.z) / (2 * kPi);
  const float u = azimuth < 0 ? azimuth + 1 : azimuth;
  const float v =
      std::atan2(std::sqrt(d.x * d.x + d.z * d.z), d.y) / kPi;  // exact near the poles, unlike acos
  const float x = u * static_cast<float>(width_) - 0.5f, y = v * static_cast<float>(height_) + 0.5f;
  const int column = static_cast<int>(std::floor(x)), row = std::min(static_cast<int>(y), height_);
  return {cornersOf(column, row), x - static_cast<float>(column), y - static_cast<float>(row)};
}

Rgb EnvironmentLight::radianceIn(const Cell& cell) {
  const auto& [corners, x, y] = cell;
  const auto mix = [](Rgb a, Rgb b, float w) { return a * (1 - w) + b * w; };
  return mix(mix(corners[0], corners[1], x), mix(corners[2], corners[3], x), y);
}

float EnvironmentLight::pdfIn(const Cell& cell) const {
  return saccade::meanLuminance(cell.corners) / (4 * kPi * mean_luminance_);
}

Rgb EnvironmentLight::radiance(Vec3 direction) const {
  return radianceIn(cellAt(direction));
}

float EnvironmentLight::pdf(Vec3 direction) const {
  return mean_luminance_ > 0 ? pdfIn(cellAt(direction)) : 0;
}

EnvironmentSample EnvironmentLight::sample(float u1, float u2) const {
  if (mean_luminance_ <= 0) return {{0, 1, 0}, {}, 0};
  const Choice row = choose(row_cdf_.data(), height_ + 1, u1);
  const Choice column = choose(&column_cdf_[static_cast<std::size_t>(row.index * width_)], width_, u2);
  const float top = shareAbove(row.index), bottom = shareAbove(row.index + 1);
  const float share = top + (bottom - top) * row.within;  // of the sphere that lies above
  const float turn = (static_cast<float>(column.index) + 0.5f + column.within) / static_cast<float>(width_);
  const float azimuth = 2 * kPi * turn, r = 2 * std::sqrt(share * (1 - share));
  const Vec3 direction = x_ * (r * std::sin(azimuth)) + y_ * (1 - 2 * share) - z_ * (r * std::cos(azimuth));
  const Cell cell = cellAt(direction);
  return {direction, radianceIn(cell), pdfIn(cell)};
}

}  // namespace saccade
