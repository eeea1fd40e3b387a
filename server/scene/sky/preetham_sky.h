// The light of a clear sky by day [P: A. J. Preetham, P. Shirley, B. Smits, A Practical Analytic Model for
// Daylight, SIGGRAPH 1999].
#pragma once

#include "base/vec.h"

namespace saccade {

inline constexpr double kLeastTurbidity = 2, kMostTurbidity = 10;  // where the model is fit for use

class PreethamSky {
 public:
  // `turbidity` is that of the air, within [kLeastTurbidity, kMostTurbidity]; 3 is a clear day. The sun is
  // `sun_zenith` from the zenith, in radians within [0, pi/2].
  PreethamSky(double turbidity, double sun_zenith);

  // The linear Rec. 709 radiance from a direction with the cosine `cos_zenith` above the horizon, and the
  // angle `from_sun` away from the sun, in radians. At the horizon and below it is that of the horizon. The
  // luminance of the colour is the mean spectral radiance, weighted by the observer's y: W / (m^2 sr nm). No
  // part is below 0.
  Rgb radiance(double cos_zenith, double from_sun) const;

 private:
  // Luminance Y in kcd / m^2 and chromaticities x, y.
  struct Quantity {
    double a, b, c, d, e;  // of [P (3)]
    double scale;          // the value at the zenith over that of the formula
    double at(double cos_zenith, double from_sun) const;
  };
  static Quantity quantity(const double (&coefficients)[5][2], double turbidity, double sun_zenith,
                           double at_zenith);

  Quantity luminance_, x_, y_;
};

}  // namespace saccade
