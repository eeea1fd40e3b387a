#include "scene/sky/preetham_sky.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/spectrum.h"

namespace saccade {
namespace {

// Factor and summand by the turbidity, of A to E [P A.2].
constexpr double kLuminance[5][2] = {
    {0.1787, -1.4630}, {-0.3554, 0.4275}, {-0.0227, 5.3251}, {0.1206, -2.5771}, {-0.0670, 0.3703}};
constexpr double kX[5][2] = {
    {-0.0193, -0.2592}, {-0.0665, 0.0008}, {-0.0004, 0.2125}, {-0.0641, -0.8989}, {-0.0033, 0.0452}};
constexpr double kY[5][2] = {
    {-0.0167, -0.2608}, {-0.0950, 0.0092}, {-0.0079, 0.2102}, {-0.0441, -1.6537}, {-0.0109, 0.0529}};

// Of the chromaticity at the zenith [P A.2]. Rows are for the powers of the turbidity from 2 down, and
// columns for those of the sun's angle from 3 down.
constexpr double kZenithX[3][4] = {{0.00166, -0.00375, 0.00209, 0},
                                   {-0.02903, 0.06377, -0.03202, 0.00394},
                                   {0.11693, -0.21196, 0.06052, 0.25886}};
constexpr double kZenithY[3][4] = {{0.00275, -0.00610, 0.00317, 0},
                                   {-0.04214, 0.08970, -0.04153, 0.00516},
                                   {0.15346, -0.26756, 0.06670, 0.26688}};

double polynomial(const double (&rows)[3][4], double turbidity, double angle) {
  double sum = 0;
  for (const auto& row : rows) {
    double of_angle = 0;
    for (const double factor : row) of_angle = of_angle * angle + factor;
    sum = sum * turbidity + of_angle;
  }
  return sum;
}

// In kcd / m^2 [P A.2].
double zenithLuminance(double turbidity, double sun_zenith) {
  const double chi = (4.0 / 9 - turbidity / 120) * (std::numbers::pi - 2 * sun_zenith);
  return (4.0453 * turbidity - 4.9710) * std::tan(chi) - 0.2155 * turbidity + 2.4192;
}

// The radiance of 1 kcd / m^2: 683 lm / W, and the integral of the observer's y over nanometres.
constexpr double kPerKilocandela = 1000 / (683 * kObserverY);

}  // namespace

// [P (3)], the formula of Perez.
double PreethamSky::Quantity::at(double cos_zenith, double from_sun) const {
  const double cos_sun = std::cos(from_sun);
  return scale * (1 + a * std::exp(b / cos_zenith)) *
         (1 + c * std::exp(d * from_sun) + e * cos_sun * cos_sun);
}

PreethamSky::Quantity PreethamSky::quantity(const double (&k)[5][2], double turbidity, double sun_zenith,
                                            double at_zenith) {
  const auto value = [&](int i) { return k[i][0] * turbidity + k[i][1]; };
  Quantity q{value(0), value(1), value(2), value(3), value(4), 1};
  q.scale = at_zenith / q.at(1, sun_zenith);  // [P (4)]
  return q;
}

PreethamSky::PreethamSky(double turbidity, double sun_zenith)
    : luminance_(quantity(kLuminance, turbidity, sun_zenith, zenithLuminance(turbidity, sun_zenith))),
      x_(quantity(kX, turbidity, sun_zenith, polynomial(kZenithX, turbidity, sun_zenith))),
      y_(quantity(kY, turbidity, sun_zenith, polynomial(kZenithY, turbidity, sun_zenith))) {}

Rgb PreethamSky::radiance(double cos_zenith, double from_sun) const {
  constexpr double kHorizon = 1e-3;
  const double c = std::max(cos_zenith, kHorizon);
  const double x = x_.at(c, from_sun), y = y_.at(c, from_sun);
  const double luminance = luminance_.at(c, from_sun) * kPerKilocandela;
  const Vec3d xyz = Vec3d{x, y, 1 - x - y} * (luminance / y);
  const Rgb color = toFloat(rec709(xyz));
  return {std::max(color.x, 0.f), std::max(color.y, 0.f), std::max(color.z, 0.f)};
}

}  // namespace saccade
