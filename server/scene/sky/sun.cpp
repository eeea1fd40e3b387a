#include "scene/sky/sun.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "scene/spectrum.h"

namespace saccade {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

// Days since noon of 1 January 2000, universal time, at the beginning of a day of the Gregorian calendar.
double daysSince2000(int year, int month, int day) {
  const int early = (month - 14) / 12;
  const int julian = 1461 * (year + 4800 + early) / 4 + 367 * (month - 2 - 12 * early) / 12 -
                     3 * ((year + 4900 + early) / 100) / 4 + day - 32075;
  return julian - 0.5 - 2451545.0;
}

// The radiance of the sun at one wavelength, outside of the air, in W / (m^2 sr nm). The others are the
// absorption of ozone and of water vapour [P A.1 and its tables].
struct SunSample {
  double radiance, ozone, vapour;
};
constexpr double kFirst = 380, kStep = 10;  // nm
constexpr SunSample kSun[] = {
    {16559.0, 0, 0},         {16233.7, 0, 0},          {21127.5, 0, 0},     {25888.2, 0, 0},
    {25829.1, 0, 0},         {24232.3, 0, 0},          {26760.5, 0, 0},     {29658.3, 0.003, 0},
    {30545.4, 0.006, 0},     {30057.5, 0.009, 0},      {30663.7, 0.014, 0}, {28830.4, 0.021, 0},
    {28712.1, 0.03, 0},      {27825.0, 0.04, 0},       {27100.6, 0.048, 0}, {27233.6, 0.063, 0},
    {26361.3, 0.075, 0},     {25503.8, 0.085, 0},      {25060.2, 0.103, 0}, {25311.6, 0.12, 0},
    {25355.9, 0.12, 0},      {25134.2, 0.115, 0},      {24631.5, 0.125, 0}, {24173.2, 0.12, 0},
    {23685.3, 0.105, 0},     {23212.1, 0.09, 0},       {22827.7, 0.079, 0}, {22339.8, 0.067, 0},
    {21970.2, 0.057, 0},     {21526.7, 0.048, 0},      {21097.9, 0.036, 0}, {20728.3, 0.028, 0.016},
    {20240.4, 0.023, 0.024}, {19870.8, 0.018, 0.0125}, {19427.2, 0.014, 1}, {19072.4, 0.011, 0.87},
    {18628.9, 0.01, 0.061},  {18259.2, 0.009, 0.001},
};

// The share of light that the air lets through [P A.1]. `mass` is that of the air along the path, over that
// above.
double transmittance(const SunSample& at, double wavelength, double mass, double turbidity) {
  const double micrometres = wavelength / 1000, beta = 0.04608 * turbidity - 0.04586;
  constexpr double kOzone = 0.35, kVapour = 2;  // cm
  const double vapour = at.vapour * kVapour * mass;
  return std::exp(-mass * (0.008735 * std::pow(micrometres, -4.08) + beta * std::pow(micrometres, -1.3) +
                           at.ozone * kOzone) -
                  0.2385 * vapour / std::pow(1 + 20.07 * vapour, 0.45));
}

}  // namespace

SunPlace sunPlace(const SunTime& t) {
  const double hours = t.hour - t.timezone + (t.minute + t.second / 60) / 60;
  const double days = daysSince2000(t.year, t.month, t.day) + hours / 24;
  const double omega = 2.1429 - 0.0010394594 * days, anomaly = 6.2400600 + 0.0172019699 * days;
  const double ecliptic = 4.8950630 + 0.017202791698 * days + 0.03341607 * std::sin(anomaly) +
                          0.00034894 * std::sin(2 * anomaly) - 0.0001134 - 0.0000203 * std::sin(omega);
  const double obliquity = 0.4090928 - 6.2140e-9 * days + 0.0000396 * std::cos(omega);
  const double ascension = std::atan2(std::cos(obliquity) * std::sin(ecliptic), std::cos(ecliptic));
  const double declination = std::asin(std::sin(obliquity) * std::sin(ecliptic));
  const double sidereal = ((6.6974243242 + 0.0657098283 * days + hours) * 15 + t.longitude) * kDegree;
  const double hour_angle = sidereal - ascension, latitude = t.latitude * kDegree;
  const double zenith = std::acos(std::cos(latitude) * std::cos(hour_angle) * std::cos(declination) +
                                  std::sin(declination) * std::sin(latitude));
  const double azimuth = std::atan2(-std::sin(hour_angle), std::tan(declination) * std::cos(latitude) -
                                                               std::sin(latitude) * std::cos(hour_angle));
  constexpr double kParallax = 6371.01 / 149597890;  // radius of the earth over the distance of the sun
  return {zenith + kParallax * std::sin(zenith), azimuth};
}

Rgb sunIrradiance(double turbidity, double zenith) {
  constexpr double kRadius = 0.2679 * kDegree;  // of the sun as it is seen
  const double solid_angle = 2 * std::numbers::pi * (1 - std::cos(kRadius));
  const double mass = 1 / (std::cos(zenith) + 0.15 * std::pow(93.885 - zenith / kDegree, -1.253));
  std::vector<SpectrumSample> spectrum;
  for (const SunSample& at : kSun) {
    const double wavelength = kFirst + kStep * static_cast<double>(spectrum.size());
    spectrum.push_back(
        {wavelength, at.radiance * transmittance(at, wavelength, mass, turbidity) * solid_angle});
  }
  const Rgb color = colorOfLight(spectrum);  // of a low sun more red than Rec. 709 can show
  return {std::max(color.x, 0.f), std::max(color.y, 0.f), std::max(color.z, 0.f)};
}

}  // namespace saccade
