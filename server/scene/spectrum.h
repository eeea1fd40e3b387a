// Colours of spectra, which scene files give as lists of wavelengths.
#pragma once

#include <vector>

#include "base/vec.h"

namespace saccade {

struct SpectrumSample {
  double wavelength, value;  // nm
};

// Both take samples whose wavelengths increase. The spectrum is linear between them, and 0 outside.

// The linear Rec. 709 colour of a spectrum, as of a lamp. It is folded with the CIE 1931 observer. Its
// luminance is the mean of the spectrum, weighted by the observer's y. An even spectrum is not white. Parts
// may be below 0.
Rgb colorOfLight(const std::vector<SpectrumSample>& spectrum);

// The integral of the CIE 1931 observer's y over nanometres.
inline constexpr double kObserverY = 106.857;

// From CIE XYZ to linear Rec. 709, whose white is daylight D65 [IEC 61966-2-1].
Vec3d rec709(Vec3d xyz);

// The colour of a surface that reflects, or lets through, this share of each wavelength, under daylight D65.
// All of it is {1, 1, 1}. Parts may be outside of [0, 1] where the colour is purer than Rec. 709 can show.
Rgb colorUnderDaylight(const std::vector<SpectrumSample>& spectrum);

}  // namespace saccade
