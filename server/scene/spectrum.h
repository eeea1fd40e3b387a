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

// The colour of a surface that reflects, or lets through, this share of each wavelength, under daylight D65.
// All of it is {1, 1, 1}. Parts may be outside of [0, 1] where the colour is purer than Rec. 709 can show.
Rgb colorUnderDaylight(const std::vector<SpectrumSample>& spectrum);

}  // namespace saccade
