// Colours of Mitsuba files in all their notations.
#include "scene/mitsuba_scratch.h"
#include "scene/spectrum.h"

namespace saccade {
namespace {

std::string rectangle(const std::string& tag, const std::string& value) {
  return "<shape type='rectangle'><bsdf type='diffuse'><" + tag + " name='reflectance' value='" + value +
         "'/></bsdf></shape>";
}

Rgb reflectance(const std::string& tag, const std::string& value) {
  const Scratch files;
  return loadBody(files, rectangle(tag, value)).materials.at(0).reflectance.color0;
}

void expectFault(const std::string& tag, const std::string& value, const std::string& part) {
  const std::string error = errorOfBody(rectangle(tag, value));
  expectContains(error, "scene.xml:3: ");
  expectContains(error, part);
}

TEST(MitsubaColor, HexIsLinearAsRgbAndEncodedAsSrgb) {
  expectNear(reflectance("rgb", "#336699"), {0.2f, 0.4f, 0.6f}, 1e-6);
  expectNear(reflectance("rgb", "#FF00ff"), {1, 0, 1}, 0);
  // ((0.2 + 0.055) / 1.055)^2.4 and so on.
  expectNear(reflectance("srgb", "#336699"), {0.033105f, 0.132868f, 0.318547f}, 1e-6);
  expectNear(reflectance("srgb", "0.2, 0.4 0.6"), {0.033105f, 0.132868f, 0.318547f}, 1e-6);
  expectNear(reflectance("srgb", "0.02"), {0.02f / 12.92f, 0.02f / 12.92f, 0.02f / 12.92f}, 1e-8);
}

TEST(MitsubaColor, SharesOfASpectrumAreSeenUnderDaylight) {
  expectNear(reflectance("spectrum", "400:0.04, 500:0.06 600:0.3,700:0.65"),
             colorUnderDaylight({{400, 0.04}, {500, 0.06}, {600, 0.3}, {700, 0.65}}), 0);
}

TEST(MitsubaColor, QuantitiesOfASpectrumAreNot) {
  const Scratch files;
  const Scene lamp = loadBody(files,
                              "<shape type='rectangle'><emitter type='area'><spectrum name='radiance' "
                              "value='400:0, 700:18'/></emitter></shape>");
  expectNear(lamp.meshes[0].radiance, colorOfLight({{400, 0}, {700, 18}}), 0);
  const Scene metal =
      loadBody(files,
               "<shape type='rectangle'><bsdf type='conductor'><spectrum name='eta' "
               "value='380:2, 780:2'/><spectrum name='k' value='380:4 780:3'/></bsdf></shape>");
  expectNear(metal.materials[0].model.eta, colorOfLight({{380, 2}, {780, 2}}), 0);
}

TEST(MitsubaColor, PurerThanCanBeShownIsCut) {
  EXPECT_EQ(reflectance("spectrum", "519:0, 520:1, 521:0").x, 0);
  expectNear(reflectance("spectrum", "300:9, 900:9"), {1, 1, 1}, 0);
}

TEST(MitsubaColor, Faults) {
  expectFault("spectrum", "400:0.5, 500", "'500' is not nm:value");
  expectFault("spectrum", "400:0.5, x:1", "'x:1' is not nm:value");
  expectFault("spectrum", "400:-1", "'400:-1' is not nm:value");
  expectFault("spectrum", "500:1, 400:1", "'400:1' is not above the one before it");
  expectFault("spectrum", "500:1, 500:1", "not above");
  expectFault("rgb", "#12345", "'#12345' is not a colour #rrggbb");
  expectFault("rgb", "#12345g", "not a colour #rrggbb");
  expectFault("rgb", "400:0.5", "'400:0.5' is not a finite number");
  expectFault("srgb", "1.5", "must be within [0, 1]");
  expectFault("rgb", "1.5", "'reflectance' must be");
}

}  // namespace
}  // namespace saccade
