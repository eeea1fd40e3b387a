// Where the sun stands, and its light.
#pragma once

#include "base/vec.h"

namespace saccade {

// A time at a place on the earth.
struct SunTime {
  int year = 2010, month = 7, day = 10;
  double hour = 15, minute = 0, second = 0;         // local time; hours may have parts
  double latitude = 35.6894, longitude = 139.6917;  // degrees, north and east
  double timezone = 9;                              // hours that the local time is ahead of UTC
};

// Both in radians. The azimuth is 0 in the north, and grows to the east.
struct SunPlace {
  double zenith, azimuth;
};

// To about 0.01 degrees from 1999 to 2015 [M. Blanco-Muriel et al., Computing the Solar Vector, Solar Energy
// 70(5), 2001].
SunPlace sunPlace(const SunTime& time);

// The linear Rec. 709 irradiance of the sun on a surface at a right angle to its light, below a clear sky
// [P A.1]. `turbidity` and `zenith` as for PreethamSky. Units: W / (m^2 nm), as the luminance of the colour
// is the mean over wavelengths, weighted by the observer's y.
Rgb sunIrradiance(double turbidity, double zenith);

}  // namespace saccade
