// The bsdfs of Mitsuba 0.6 alone, and coats.
#include <gtest/gtest.h>

#include "scene/mitsuba_scratch.h"

namespace saccade {
namespace {

Scene sceneOf(const std::string& bsdf) {
  const Scratch files;
  files.write("bump.ppm", "P3 2 1 255  0 0 0  255 255 255");
  return loadBody(files, "<shape type='rectangle'>" + bsdf + "</shape>", "0.6.0");
}
Material material(const std::string& bsdf) {
  return sceneOf(bsdf).materials.at(0);
}
void expectBsdfError(const std::string& bsdf, const std::string& part) {
  expectContains(errorOfBody("<shape type='rectangle'>" + bsdf + "</shape>"), part);
}
std::string coat(const std::string& inner, const std::string& more = {},
                 const std::string& type = "coating") {
  return "<bsdf type='" + type + "'>" + more + inner + "</bsdf>";
}
const std::string kDiffuse = "<bsdf type='diffuse'><rgb name='reflectance' value='0.8, 0.4, 0.2'/></bsdf>";

TEST(MitsubaGloss, PhongHasAnExponent) {
  const Material plain = material("<bsdf type='phong'/>");
  EXPECT_EQ(plain.model.kind, BsdfKind::kPhong);
  EXPECT_FLOAT_EQ(plain.model.alpha, 0.25f);  // of 30
  EXPECT_EQ(plain.reflectance.color0, (Rgb{0.5f, 0.5f, 0.5f}));
  EXPECT_EQ(plain.specular.color0, (Rgb{0.2f, 0.2f, 0.2f}));
  const Material tile = material(
      "<bsdf type='phong'><float name='exponent' value='198'/><spectrum name='specularReflectance' "
      "value='0.1'/>"
      "<rgb name='diffuseReflectance' value='0.6, 0.5, 0.4'/></bsdf>");
  EXPECT_FLOAT_EQ(tile.model.alpha, 0.1f);
  EXPECT_EQ(tile.specular.color0, (Rgb{0.1f, 0.1f, 0.1f}));
  EXPECT_EQ(tile.reflectance.color0, (Rgb{0.6f, 0.5f, 0.4f}));
  expectBsdfError("<bsdf type='phong'><float name='exponent' value='-1'/></bsdf>", "within [0, 1e6]");
}

// As Mitsuba scales them: to 0.99 together.
TEST(MitsubaGloss, ReflectsNoMoreThanItGets) {
  const auto phong = [](const std::string& base, const std::string& gloss) {
    return "<bsdf type='phong'><rgb name='diffuseReflectance' value='" + base +
           "'/><rgb name='specularReflectance' value='" + gloss + "'/></bsdf>";
  };
  const Material bright = material(phong("1, 0.5, 0.25", "0.5, 0.5, 0.5"));
  expectNear(bright.reflectance.color0, Rgb{1, 0.5f, 0.25f} * 0.66f, 1e-6);
  expectNear(bright.specular.color0, Rgb{1, 1, 1} * 0.33f, 1e-6);
  EXPECT_EQ(material(phong("0.5", "0.5")).specular.color0.x, 0.5f);
  EXPECT_NEAR(material(phong("0", "9")).specular.color0.x, 0.99f, 1e-6);
  expectBsdfError(
      "<bsdf type='phong'><rgb name='specularReflectance' value='9'/>"
      "<texture type='checkerboard' name='diffuseReflectance'/></bsdf>",
      "a reflectance above 1 is not supported beside a texture");
}

TEST(MitsubaGloss, WardIsTheBalancedOne) {
  const Material ward = material(
      "<bsdf type='ward'><float name='alpha' value='0.4'/><string name='variant' value='balanced'/></bsdf>");
  EXPECT_EQ(ward.model.kind, BsdfKind::kWard);
  EXPECT_FLOAT_EQ(ward.model.alpha, 0.4f);
  expectBsdfError("<bsdf type='ward'><string name='variant' value='ward-duer'/></bsdf>",
                  "the variant 'ward-duer' is not supported; supported: balanced");
  expectBsdfError("<bsdf type='ward'><float name='alphaU' value='0.2'/></bsdf>", "must be equal");
}

// 1 - 0.5 * 0.5 / 0.83 of a diffuse surface is reflected straight back.
TEST(MitsubaGloss, ARoughDiffuseIsToldToBeDiffuse) {
  const Scene rough = sceneOf("<bsdf type='roughdiffuse'><float name='alpha' value='1'/></bsdf>");
  EXPECT_EQ(rough.materials.at(0).model.kind, BsdfKind::kDiffuse);
  ASSERT_FALSE(rough.unread.empty());
  expectContains(rough.unread.at(0), "a roughdiffuse is shown as diffuse, which is up to 43 % brighter");
  const Scene smooth = sceneOf("<bsdf type='roughdiffuse'><float name='alpha' value='0'/></bsdf>");
  for (const std::string& told : smooth.unread) EXPECT_EQ(told.find("roughdiffuse"), told.npos);
}

TEST(MitsubaGloss, MicrofacetsOfPhongAreToldToBeBeckmanns) {
  const Scene scene = sceneOf("<bsdf type='roughplastic'><string name='distribution' value='phong'/></bsdf>");
  EXPECT_EQ(scene.materials.at(0).model.microfacets, MicrofacetKind::kBeckmann);
  expectContains(scene.unread.at(0), "shown as beckmann");
}

TEST(MitsubaCoat, OverDiffuseIsAPlasticThatScattersOnce) {
  const Material smooth = material("<bsdf type='twosided'>" +
                                   coat(kDiffuse,
                                        "<float name='intIOR' value='1.7'/><float name='extIOR' value='1'/>"
                                        "<rgb name='sigmaA' value='0'/><float name='thickness' value='3'/>"
                                        "<spectrum name='specularReflectance' value='0.3'/>") +
                                   "</bsdf>");
  EXPECT_EQ(smooth.model.kind, BsdfKind::kPlastic);
  EXPECT_TRUE(smooth.model.scatters_once && smooth.twosided);
  EXPECT_FLOAT_EQ(smooth.model.ior, 1.7f);
  EXPECT_EQ(smooth.reflectance.color0, (Rgb{0.8f, 0.4f, 0.2f}));
  EXPECT_EQ(smooth.specular.color0, (Rgb{0.3f, 0.3f, 0.3f}));
  const Material rough = material(coat(kDiffuse, "<float name='alpha' value='0.3'/>", "roughcoating"));
  EXPECT_EQ(rough.model.kind, BsdfKind::kRoughPlastic);
  EXPECT_TRUE(rough.model.scatters_once);
  EXPECT_FLOAT_EQ(rough.model.alpha, 0.3f);
}

TEST(MitsubaCoat, OverAConductorIsPartOfIt) {
  const Material metal = material(coat("<bsdf type='conductor'/>", "<string name='intIOR' value='pet'/>"));
  EXPECT_EQ(metal.model.kind, BsdfKind::kConductor);
  EXPECT_FLOAT_EQ(metal.model.coat_ior, 1.575f / 1.000277f);
  EXPECT_EQ(material("<bsdf type='conductor'/>").model.coat_ior, 0);
}

TEST(MitsubaCoat, OverARoughConductorHasARoughnessOfItsOwn) {
  const std::string metal =
      "<bsdf type='roughconductor'><float name='alpha' value='0.2'/>"
      "<string name='distribution' value='ggx'/></bsdf>";
  const BsdfModel smooth = material(coat(metal, "<float name='intIOR' value='1.7'/>")).model;
  EXPECT_EQ(smooth.kind, BsdfKind::kCoatedConductor);
  EXPECT_FLOAT_EQ(smooth.coat_ior, 1.7f / 1.000277f);
  EXPECT_EQ(smooth.coat_alpha, 0);
  const BsdfModel rough = material(coat(metal, "<float name='alpha' value='0.3'/>", "roughcoating")).model;
  EXPECT_EQ(rough.kind, BsdfKind::kCoatedConductor);
  EXPECT_FLOAT_EQ(rough.alpha, 0.2f);
  EXPECT_EQ(rough.microfacets, MicrofacetKind::kGgx);
  EXPECT_FLOAT_EQ(rough.coat_alpha, 0.3f);
  EXPECT_EQ(rough.coat_microfacets, MicrofacetKind::kBeckmann);
  expectBsdfError(coat(metal, "<float name='intIOR' value='1'/><float name='extIOR' value='1.3'/>"),
                  "must be at least its ext_ior");
  expectBsdfError(coat(metal, "<float name='alpha' value='0.3'/>"),
                  "<float name=\"alpha\"> is not supported");
}

TEST(MitsubaCoat, OfOtherKindsIsRefused) {
  expectBsdfError(
      coat("<bsdf type='dielectric'/>"),
      "a coating over dielectric is not supported; supported: coating over diffuse, conductor and "
      "roughconductor, roughcoating over diffuse and roughconductor; leave out the coat");
  expectBsdfError(coat("<bsdf type='conductor'/>", "", "roughcoating"), "a roughcoating over conductor");
  expectBsdfError(coat(kDiffuse, "<rgb name='sigmaA' value='0.1, 0.2, 0.3'/>"), "a coat that absorbs light");
  expectBsdfError(coat("<bsdf type='conductor'/>", "<float name='specularReflectance' value='0.5'/>"),
                  "'specular_reflectance' is supported at 1 alone");
  expectBsdfError(coat("<bsdf type='mask'>" + kDiffuse + "</bsdf>"), "a mask below a coat is not supported");
  expectBsdfError(coat(""), "a coating bsdf needs a <bsdf> in it");
  expectBsdfError(coat(kDiffuse, "<float name='gloss' value='1'/>"),
                  "<float name=\"gloss\"> is not supported");
}

}  // namespace
}  // namespace saccade
