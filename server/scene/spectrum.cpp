#include "scene/spectrum.h"

#include <algorithm>
#include <iterator>

namespace saccade {
namespace {

// The CIE 1931 observer and daylight D65 at one wavelength.
struct Standard {
  double x, y, z, daylight;
};

// From 380 to 780 nm in steps of 10 nm [CIE 15:2004, tables T.4 and T.1].
constexpr double kFirst = 380, kStep = 10;
constexpr Standard kStandards[] = {
    {0.001368, 0.000039, 0.00645, 49.9755},
    {0.004243, 0.00012, 0.02005, 54.6482},
    {0.01431, 0.000396, 0.06785, 82.7549},
    {0.04351, 0.00121, 0.2074, 91.486},
    {0.13438, 0.004, 0.6456, 93.4318},
    {0.2839, 0.0116, 1.3856, 86.6823},
    {0.34828, 0.023, 1.74706, 104.865},
    {0.3362, 0.038, 1.77211, 117.008},
    {0.2908, 0.06, 1.6692, 117.812},
    {0.19536, 0.09098, 1.28764, 114.861},
    {0.09564, 0.13902, 0.81295, 115.923},
    {0.03201, 0.20802, 0.46518, 108.811},
    {0.0049, 0.323, 0.272, 109.354},
    {0.0093, 0.503, 0.1582, 107.802},
    {0.06327, 0.71, 0.07825, 104.79},
    {0.1655, 0.862, 0.04216, 107.689},
    {0.2904, 0.954, 0.0203, 104.405},
    {0.43345, 0.99495, 0.00875, 104.046},
    {0.5945, 0.995, 0.0039, 100},
    {0.7621, 0.952, 0.0021, 96.3342},
    {0.9163, 0.87, 0.00165, 95.788},
    {1.0263, 0.757, 0.0011, 88.6856},
    {1.0622, 0.631, 0.0008, 90.0062},
    {1.0026, 0.503, 0.00034, 89.5991},
    {0.85445, 0.381, 0.00019, 87.6987},
    {0.6424, 0.265, 0.00005, 83.2886},
    {0.4479, 0.175, 0.00002, 83.6992},
    {0.2835, 0.107, 0, 80.0268},
    {0.1649, 0.061, 0, 80.2146},
    {0.0874, 0.032, 0, 82.2778},
    {0.04677, 0.017, 0, 78.2842},
    {0.0227, 0.00821, 0, 69.7213},
    {0.011359, 0.004102, 0, 71.6091},
    {0.00579, 0.002091, 0, 74.349},
    {0.002899, 0.001047, 0, 61.604},
    {0.00144, 0.00052, 0, 69.8856},
    {0.00069, 0.000249, 0, 75.087},
    {0.000332, 0.00012, 0, 63.5927},
    {0.000166, 0.00006, 0, 46.4182},
    {0.000083, 0.00003, 0, 66.8054},
    {0.000042, 0.000015, 0, 63.3828},
};
constexpr int kNanometres = 10 * (static_cast<int>(std::size(kStandards)) - 1);  // to integrate over

double between(double a, double b, double t) {
  return a + (b - a) * t;
}

Standard standardAt(double wavelength) {
  const double at = (wavelength - kFirst) / kStep;
  const auto i = std::min(static_cast<std::size_t>(at), std::size(kStandards) - 2);
  const Standard &a = kStandards[i], &b = kStandards[i + 1];
  const double t = at - static_cast<double>(i);
  return {between(a.x, b.x, t), between(a.y, b.y, t), between(a.z, b.z, t),
          between(a.daylight, b.daylight, t)};
}

double valueAt(const std::vector<SpectrumSample>& spectrum, double wavelength) {
  const auto after = std::lower_bound(spectrum.begin(), spectrum.end(), wavelength,
                                      [](const SpectrumSample& s, double w) { return s.wavelength < w; });
  if (after == spectrum.end()) return 0;
  if (after->wavelength == wavelength) return after->value;
  if (after == spectrum.begin()) return 0;
  const SpectrumSample &a = *(after - 1), &b = *after;
  return between(a.value, b.value, (wavelength - a.wavelength) / (b.wavelength - a.wavelength));
}

// The integral of value(wavelength, standard) times the observer, over wavelengths, as a colour.
template <class Value>
Vec3d observed(Value value) {
  Vec3d sum;
  for (int i = 0; i <= kNanometres; ++i) {
    const Standard s = standardAt(kFirst + i);
    sum = sum + Vec3d{s.x, s.y, s.z} * value(kFirst + i, s);
  }
  return rec709(sum);
}

}  // namespace

Vec3d rec709(Vec3d c) {
  return {3.2406 * c.x - 1.5372 * c.y - 0.4986 * c.z, -0.9689 * c.x + 1.8758 * c.y + 0.0415 * c.z,
          0.0557 * c.x - 0.2040 * c.y + 1.0570 * c.z};
}

Rgb colorOfLight(const std::vector<SpectrumSample>& spectrum) {
  double y = 0;
  for (int i = 0; i <= kNanometres; ++i) y += standardAt(kFirst + i).y;
  return toFloat(observed([&](double w, const Standard&) { return valueAt(spectrum, w); }) / y);
}

Rgb colorUnderDaylight(const std::vector<SpectrumSample>& spectrum) {
  const Vec3d white = observed([](double, const Standard& s) { return s.daylight; });
  const Vec3d seen = observed([&](double w, const Standard& s) { return valueAt(spectrum, w) * s.daylight; });
  return toFloat(Vec3d{seen.x / white.x, seen.y / white.y, seen.z / white.z});
}

}  // namespace saccade
