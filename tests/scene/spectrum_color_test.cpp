// Colours of spectra against those of another program, and closed forms.
#include "scene/spectrum.h"

#include "scene/scratch.h"

namespace saccade {
namespace {

// XYZ = {1, 1, 1}, by the matrix of IEC 61966-2-1.
TEST(Spectrum, OfEqualEnergyIsNotWhiteAsALight) {
  expectNear(colorOfLight({{300, 1}, {900, 1}}), {1.2048f, 0.9483f, 0.9087f}, 2e-3);
}

TEST(Spectrum, OfAllLightIsWhiteAsASurface) {
  const Rgb white = colorUnderDaylight({{300, 1}, {900, 1}});
  expectNear(white, {1, 1, 1}, 1e-6);
}

// The values of spectrum_list_to_srgb() of Mitsuba 3, which has tables of 5 nm.
TEST(Spectrum, AgreesWithMitsuba) {
  const Rgb lamp = colorOfLight({{400, 0}, {500, 8}, {600, 15.6}, {700, 18.4}});
  expectNear(lamp / 20.f, Rgb{20.7108f, 10.8546f, 2.7712f} / 20.f, 2e-3);
  expectNear(colorUnderDaylight({{400, 0.78}, {700, 0.78}}), {0.7764f, 0.7798f, 0.7760f}, 2e-3);
  expectNear(colorUnderDaylight({{400, 0.04}, {500, 0.06}, {600, 0.3}, {700, 0.65}}),
             {0.4291f, 0.1529f, 0.0320f}, 2e-3);
  expectNear(colorUnderDaylight({{400, 0.1}, {500, 0.3}, {550, 0.42}, {600, 0.16}, {700, 0.16}}),
             {0.1249f, 0.3655f, 0.1931f}, 2e-3);
}

// A line of 1 nm at 520 nm has the luminance of its share of the observer's y.
TEST(Spectrum, HasTheLuminanceOfTheObserver) {
  const Rgb line = colorOfLight({{519, 0}, {520, 1}, {521, 0}});
  EXPECT_NEAR(luminance(line), 0.71 / 106.86, 2e-5);
  EXPECT_LT(line.x, 0);  // purer than Rec. 709 can show
}

}  // namespace
}  // namespace saccade
