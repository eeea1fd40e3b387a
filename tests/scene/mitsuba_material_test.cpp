#include "scene/conductors.h"
#include "scene/mitsuba_scratch.h"

namespace saccade {
namespace {

// The material of a rectangle with this bsdf in it.
Material material(const std::string& bsdf, const std::string& version = "3.0.0") {
  const Scratch files;
  files.write("bump.ppm", "P3 2 1 255  0 0 0  255 255 255");
  return loadBody(files, "<shape type='rectangle'>" + bsdf + "</shape>", version).materials.at(0);
}

void expectBsdfError(const std::string& bsdf, const std::string& part) {
  const std::string error = errorOfBody("<shape type='rectangle'>" + bsdf + "</shape>");
  expectContains(error, "scene.xml:3: ");
  expectContains(error, part);
}

// Both dialects say the same.
struct Dialect {
  std::string version, int_ior, ext_ior, ext_eta, diffuse, specular, transmittance;
};
const Dialect kDialects[] = {{"0.5.0", "intIOR", "extIOR", "extEta", "diffuseReflectance",
                              "specularReflectance", "specularTransmittance"},
                             {"3.0.0", "int_ior", "ext_ior", "ext_eta", "diffuse_reflectance",
                              "specular_reflectance", "specular_transmittance"}};

// As exporters write AlSb, a colour that Rec. 709 does not hold.
TEST(MitsubaMaterial, AnIndexBelow0Is0) {
  const std::string k = "<rgb name='k' value='1, 1, 1'/>";
  const Material m = material("<bsdf type='conductor'><rgb name='eta' value='-0.0485, 4, 5'/>" + k +
                              "<float name='ext_eta' value='1'/></bsdf>");
  EXPECT_EQ(m.model.eta, (Rgb{0, 4, 5}));
  expectContains(errorOfBody("<shape type='disk'><bsdf type='conductor'><rgb name='eta' value='-2, 4, 5'/>" +
                             k + "</bsdf></shape>"),
                 "'eta' must be at least -1");
}

TEST(MitsubaMaterial, ASmoothSurfaceMayHaveARoughnessThatMitsubaDoesNotRead) {
  const Scratch files;
  for (const std::string kind : {"conductor", "dielectric"}) {
    const Scene s = loadBody(files, "<shape type='disk'><bsdf type='" + kind +
                                        "'><string name='distribution' value='phong'/>"
                                        "<float name='alpha' value='0.3'/></bsdf></shape>");
    EXPECT_EQ(traitsOf(s.materials.at(0).model.kind).name, kind);
  }
}

TEST(MitsubaMaterial, PlasticsAreReadInBothDialects) {
  for (const Dialect& d : kDialects) {
    const std::string properties = "<float name='" + d.int_ior + "' value='1.8'/><float name='" + d.ext_ior +
                                   "' value='1.2'/>" + "<boolean name='nonlinear' value='true'/><rgb name='" +
                                   d.diffuse + "' value='0.1, 0.2, 0.3'/>" + "<spectrum name='" + d.specular +
                                   "' value='0.25'/>";
    const Material smooth = material("<bsdf type='plastic'>" + properties + "</bsdf>", d.version);
    EXPECT_EQ(smooth.model.kind, BsdfKind::kPlastic);
    EXPECT_FLOAT_EQ(smooth.model.ior, 1.5f);
    EXPECT_TRUE(smooth.model.nonlinear);
    expectNear(smooth.reflectance.color0, {0.1f, 0.2f, 0.3f}, 0);
    expectNear(smooth.specular.color0, {0.25f, 0.25f, 0.25f}, 0);
    const Material rough = material("<bsdf type='roughplastic'>" + properties +
                                        "<float name='alpha' value='0.3'/>"
                                        "<string name='distribution' value='ggx'/></bsdf>",
                                    d.version);
    EXPECT_EQ(rough.model.kind, BsdfKind::kRoughPlastic);
    EXPECT_FLOAT_EQ(rough.model.alpha, 0.3f);
    EXPECT_EQ(rough.model.microfacets, MicrofacetKind::kGgx);
    EXPECT_FLOAT_EQ(rough.model.ior, 1.5f);
  }
}

TEST(MitsubaMaterial, MetalsAreReadInBothDialects) {
  for (const Dialect& d : kDialects) {
    const Material metal = material(
        "<bsdf type='roughconductor'><rgb name='eta' value='1, 2, 3'/><rgb name='k' value='4, 5, 6'/>"
        "<float name='" +
            d.ext_eta + "' value='2'/><rgb name='" + d.specular + "' value='0.5, 0.6, 0.7'/></bsdf>",
        d.version);
    EXPECT_EQ(metal.model.kind, BsdfKind::kRoughConductor);
    expectNear(metal.model.eta, {0.5f, 1, 1.5f}, 1e-7);
    expectNear(metal.model.k, {2, 2.5f, 3}, 1e-7);
    expectNear(metal.specular.color0, {0.5f, 0.6f, 0.7f}, 0);
    EXPECT_EQ(metal.model.microfacets, MicrofacetKind::kBeckmann);
  }
}

TEST(MitsubaMaterial, MetalsHaveNames) {
  const auto named = [](const std::string& name) {
    return material("<bsdf type='conductor'><string name='material' value='" + name + "'/></bsdf>").model;
  };
  EXPECT_EQ(named("Au").eta, findConductor("Au")->eta);
  EXPECT_EQ(named("Au").k, findConductor("Au")->k);
  EXPECT_EQ(named("none").eta, (Rgb{0, 0, 0}));
  // Mitsuba's default.
  EXPECT_EQ(material("<bsdf type='conductor'/>", "3.5.0").model.eta, findConductor("none")->eta);
  EXPECT_EQ(material("<bsdf type='conductor'/>", "0.6.0").model.eta, findConductor("Cu")->eta);
}

TEST(MitsubaMaterial, GlassIsReadInBothDialects) {
  for (const Dialect& d : kDialects) {
    for (const std::string type : {"dielectric", "thindielectric"}) {
      const Material glass = material(
          "<bsdf type='" + type + "'><float name='" + d.int_ior + "' value='1.5'/><float name='" + d.ext_ior +
              "' value='1'/><rgb name='" + d.transmittance + "' value='0.2, 0.4, 0.6'/></bsdf>",
          d.version);
      EXPECT_EQ(glass.model.kind, type == "dielectric" ? BsdfKind::kDielectric : BsdfKind::kThinDielectric);
      EXPECT_FLOAT_EQ(glass.model.ior, 1.5f);
      expectNear(glass.transmittance.color0, {0.2f, 0.4f, 0.6f}, 0);
      expectNear(glass.specular.color0, {1, 1, 1}, 0);
    }
  }
}

TEST(MitsubaMaterial, RoughGlassIsRead) {
  const Material glass = material(
      "<bsdf type='roughdielectric'><float name='alpha' value='0.2'/><string name='distribution' "
      "value='ggx'/>"
      "<string name='intIOR' value='diamond'/><rgb name='specularTransmittance' value='0.2, 0.4, "
      "0.6'/></bsdf>");
  EXPECT_EQ(glass.model.kind, BsdfKind::kRoughDielectric);
  EXPECT_EQ(glass.model.microfacets, MicrofacetKind::kGgx);
  EXPECT_FLOAT_EQ(glass.model.alpha, 0.2f);
  EXPECT_FLOAT_EQ(glass.model.ior, 2.419f / 1.000277f);
  expectNear(glass.transmittance.color0, {0.2f, 0.4f, 0.6f}, 0);
  expectBsdfError("<bsdf type='roughdielectric'><string name='intIOR' value='air'/></bsdf>",
                  "must differ by 0.001 at least");
}

// The indices of BK7 glass, polypropylene and air that Mitsuba's manual gives.
TEST(MitsubaMaterial, DefaultsAreThoseOfMitsuba) {
  EXPECT_FLOAT_EQ(material("<bsdf type='dielectric'/>").model.ior, 1.5046f / 1.000277f);
  EXPECT_FLOAT_EQ(material("<bsdf type='plastic'/>").model.ior, 1.49f / 1.000277f);
  const Material rough = material("<bsdf type='roughplastic'/>");
  EXPECT_FLOAT_EQ(rough.model.alpha, 0.1f);
  EXPECT_EQ(rough.model.microfacets, MicrofacetKind::kBeckmann);
  EXPECT_FALSE(rough.model.nonlinear);
  expectNear(rough.reflectance.color0, {0.5f, 0.5f, 0.5f}, 0);
  expectNear(rough.specular.color0, {1, 1, 1}, 0);
}

// The indices of Hecht's Optics, as Mitsuba's manual lists them.
TEST(MitsubaMaterial, IndicesHaveNames) {
  const auto ior = [](const std::string& type, const std::string& inside, const std::string& outside) {
    return material("<bsdf type='" + type + "'><string name='intIOR' value='" + inside +
                    "'/><string name='ext_ior' value='" + outside + "'/></bsdf>")
        .model.ior;
  };
  EXPECT_FLOAT_EQ(ior("dielectric", "diamond", "water"), 2.419f / 1.333f);
  EXPECT_FLOAT_EQ(ior("thindielectric", "Water Ice", "vacuum"), 1.31f);
  EXPECT_FLOAT_EQ(ior("plastic", "acrylic glass", "air"), 1.49f / 1.000277f);
  const Material metal = material(
      "<bsdf type='conductor'><rgb name='eta' value='2, 2, 2'/><rgb name='k' value='3, 3, 3'/>"
      "<string name='extEta' value='water'/></bsdf>");
  EXPECT_FLOAT_EQ(metal.model.eta.x, 2 / 1.333f);
}

TEST(MitsubaMaterial, RoughnessMayBeGivenAlongBothAxes) {
  EXPECT_FLOAT_EQ(material("<bsdf type='roughconductor'><float name='alphaU' value='0.3'/>"
                           "<float name='alphaV' value='0.3'/></bsdf>")
                      .model.alpha,
                  0.3f);
}

// Mitsuba 0.6 reads both names, and prefers the first.
TEST(MitsubaMaterial, TheColourOfADiffuseSurfaceHasTwoNames) {
  const std::string other = "<rgb name='diffuseReflectance' value='0.1, 0.2, 0.3'/>";
  expectNear(material("<bsdf type='diffuse'>" + other + "</bsdf>").reflectance.color0, {0.1f, 0.2f, 0.3f}, 0);
  expectNear(material("<bsdf type='diffuse'>" + other + "<float name='reflectance' value='0.7'/></bsdf>")
                 .reflectance.color0,
             {0.7f, 0.7f, 0.7f}, 0);
}

std::string wrapped(const std::vector<std::string>& wrappers, const std::string& inner) {
  if (wrappers.empty()) return inner;
  const std::string inside = wrapped({wrappers.begin() + 1, wrappers.end()}, inner);
  const std::string bump =
      "<texture type='bitmap' name='map'><string name='filename' value='bump.ppm'/></texture>";
  return "<bsdf type='" + wrappers[0] + "'>" +
         (wrappers[0] == "mask"      ? "<spectrum name='opacity' value='0.25'/>"
          : wrappers[0] == "bumpmap" ? bump + "<float name='scale' value='3'/>"
                                     : "") +
         inside + "</bsdf>";
}

TEST(MitsubaMaterial, WrappersMayStandInAnyOrder) {
  std::vector<std::string> wrappers = {"bumpmap", "mask", "twosided"};
  do {
    const Material m = material(wrapped(wrappers, "<bsdf type='plastic'/>"));
    EXPECT_EQ(m.model.kind, BsdfKind::kPlastic);
    EXPECT_TRUE(m.twosided);
    EXPECT_TRUE(isBumpy(m));
    EXPECT_FLOAT_EQ(m.height_scale, 3);
    EXPECT_FALSE(isOpaque(m));
    EXPECT_FLOAT_EQ(m.opacity.color0.y, 0.25f);
  } while (std::next_permutation(wrappers.begin(), wrappers.end()));
  const Material plain = material("<bsdf type='plastic'/>");
  EXPECT_FALSE(plain.twosided || isBumpy(plain));
  EXPECT_TRUE(isOpaque(plain));
}

// A bsdf at the top that has no id is meant by the id of its inner one. One that has an id is not.
TEST(MitsubaMaterial, AnIdWithinAWrapperNamesTheWhole) {
  const Scratch files;
  files.write("bump.ppm", "P3 2 1 255  0 0 0  255 255 255");
  const auto load = [&](const std::string& bsdf) {
    return loadBody(files, bsdf + "<shape type='rectangle'><ref id='metal'/></shape>").materials.at(0);
  };
  const std::string metal = "<bsdf type='twosided' id='metal'><bsdf type='conductor'/></bsdf>";
  const Material bumpy = load(wrapped({"bumpmap"}, metal));
  EXPECT_TRUE(isBumpy(bumpy));
  EXPECT_TRUE(bumpy.twosided);
  EXPECT_EQ(bumpy.name, "metal");
  std::string named = wrapped({"bumpmap"}, metal);
  named.insert(named.find('>'), " id='bumpy'");
  EXPECT_FALSE(isBumpy(load(named)));
}

TEST(MitsubaMaterial, FaultsNameWhatIsValid) {
  expectBsdfError("<bsdf type='conductor'><string name='material' value='Unobtainium'/></bsdf>",
                  "the metal 'Unobtainium' is not known; known: none, a-C, Ag");
  expectBsdfError("<bsdf type='conductor'><rgb name='eta' value='1, 1, 1'/></bsdf>", "needs eta and k");
  expectBsdfError("<bsdf type='roughplastic'><string name='distribution' value='as'/></bsdf>",
                  "'as' is not supported; supported: beckmann, ggx, phong");
  expectBsdfError("<bsdf type='roughplastic'><float name='alpha' value='1.5'/></bsdf>", "within [0, 1]");
  expectBsdfError("<bsdf type='roughplastic'><float name='alphaU' value='0.5'/></bsdf>",
                  "alpha_u and alpha_v must be equal");
  expectBsdfError("<bsdf type='dielectric'><float name='intIOR' value='0'/></bsdf>",
                  "int_ior must be within");
  expectBsdfError("<bsdf type='dielectric'><string name='int_ior' value='gin'/></bsdf>",
                  "int_ior: the material 'gin' is not known; known: vacuum, helium");
  expectBsdfError("<bsdf type='plastic'><rgb name='diffuse_reflectance' value='1, 2, 1'/></bsdf>",
                  "'diffuse_reflectance' must be at least 0 and at most 1");
  expectBsdfError("<bsdf type='mask'/>", "a mask bsdf needs a <bsdf> in it");
  expectBsdfError("<bsdf type='bumpmap'><bsdf type='diffuse'/></bsdf>", "needs a <texture>");
  expectBsdfError("<bsdf type='mask'><bsdf type='mask'><bsdf type='diffuse'/></bsdf></bsdf>",
                  "a mask within a mask");
}

TEST(MitsubaMaterial, ChainsOfReferencesEnd) {
  std::string body = "<bsdf type='diffuse' id='b0'/>";
  for (int i = 1; i < 1000; ++i)
    body += "<bsdf type='twosided' id='b" + std::to_string(i) + "'><ref id='b" + std::to_string(i - 1) +
            "'/></bsdf>";
  expectContains(errorOfBody(body + "<shape type='cube'><ref id='b999'/></shape>"),
                 "nested more than 16 deep");
}

// Our own: the material of glTF.
TEST(MitsubaMaterial, MetallicRoughnessHasItsDefaults) {
  const Material plain = material("<bsdf type='metallicroughness'/>");
  EXPECT_EQ(plain.metallic_roughness.color0, (Rgb{0, 0.5f, 0}));
  EXPECT_EQ(plain.reflectance.color0, (Rgb{0.5f, 0.5f, 0.5f}));
  const Material metal = material(
      "<bsdf type='metallicroughness'><rgb name='base_color' value='0.9, 0.5, 0.2'/>"
      "<float name='metallic' value='1'/><float name='roughness' value='0.25'/></bsdf>");
  EXPECT_EQ(metal.metallic_roughness.color0, (Rgb{0, 0.25f, 1}));
  EXPECT_EQ(metal.reflectance.color0, (Rgb{0.9f, 0.5f, 0.2f}));
  expectBsdfError("<bsdf type='metallicroughness'><float name='metallic' value='2'/></bsdf>",
                  "within [0, 1]");
}

const std::string kBright = "<bsdf type='diffuse'><rgb name='reflectance' value='0.8'/></bsdf>",
                  kDark = "<bsdf type='diffuse'><rgb name='reflectance' value='0.4'/></bsdf>",
                  kMetal = "<bsdf type='conductor'/>";

std::string blend(const std::string& weight, const std::string& parts) {
  return "<bsdf type='blendbsdf'><float name='weight' value='" + weight + "'/>" + parts + "</bsdf>";
}

TEST(MitsubaMaterial, ABlendOfDiffuseSurfacesHasTheirMean) {
  EXPECT_FLOAT_EQ(material(blend("0.25", kBright + kDark)).reflectance.color0.x, 0.7f);
  EXPECT_FLOAT_EQ(material("<bsdf type='mixturebsdf'><string name='weights' value='0.5, 0.25'/>" + kBright +
                           kDark + "</bsdf>")
                      .reflectance.color0.y,
                  0.5f);
  EXPECT_TRUE(material("<bsdf type='twosided'>" + blend("0.25", kBright + kDark) + "</bsdf>").twosided);
}

TEST(MitsubaMaterial, ABlendOfWeight1IsOneOfItsBsdfs) {
  EXPECT_EQ(material(blend("1", kBright + kMetal)).model.kind, BsdfKind::kConductor);
  EXPECT_EQ(material(blend("0", kBright + kMetal)).model.kind, BsdfKind::kDiffuse);
}

TEST(MitsubaMaterial, OtherBlendsAreRefused) {
  expectBsdfError(blend("0.5", kBright + kMetal), "are blended with weights of 0 and 1 alone");
  expectBsdfError(blend("0.5", kBright), "has 1 bsdfs for 2 weights");
  expectBsdfError(blend("1.5", kBright + kDark), "must be at least 0, and their sum at most 1");
  expectBsdfError(blend("0.5", kBright + blend("0.5", kBright + kDark)), "a blend within a blend");
  expectBsdfError(blend("0.5", kBright + "<bsdf type='twosided'>" + kDark + "</bsdf>"),
                  "two sides all or none");
}

}  // namespace
}  // namespace saccade
