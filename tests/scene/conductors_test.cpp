#include "scene/conductors.h"

#include <gtest/gtest.h>

namespace saccade {
namespace {

// Reflectance at normal incidence.
double reflectance(double eta, double k) {
  return ((eta - 1) * (eta - 1) + k * k) / ((eta + 1) * (eta + 1) + k * k);
}

// Colours of metals that others have published: Akenine-Moeller, Haines, Hoffman, Real-Time Rendering, 4th
// edition, table 9.2. They fold the reflectance, not the index, with the observer.
TEST(Conductors, HaveTheColoursOfTheirMetals) {
  const struct {
    const char* name;
    Rgb color;
  } metals[] = {{"Ag", {0.972f, 0.960f, 0.915f}}, {"Al", {0.913f, 0.922f, 0.924f}},
                {"Au", {1.000f, 0.766f, 0.336f}}, {"Cu", {0.955f, 0.638f, 0.538f}},
                {"Hg", {0.781f, 0.780f, 0.778f}}, {"none", {1, 1, 1}}};
  for (const auto& metal : metals) {
    const ComplexIndex* index = findConductor(metal.name);
    ASSERT_TRUE(index) << metal.name;
    EXPECT_NEAR(reflectance(index->eta.x, index->k.x), metal.color.x, 0.05) << metal.name;
    EXPECT_NEAR(reflectance(index->eta.y, index->k.y), metal.color.y, 0.05) << metal.name;
    EXPECT_NEAR(reflectance(index->eta.z, index->k.z), metal.color.z, 0.05) << metal.name;
  }
}

// K: the reflectance of potassium is about 0.93 at 600 nm [Palik]. Glassy carbon is dark.
TEST(Conductors, AlsoHaveTheNamesOfPalik) {
  EXPECT_EQ(findConductor("W_palik"), findConductor("W"));
  EXPECT_NE(findConductor("Cu_palik"), findConductor("Cu"));
  EXPECT_FALSE(findConductor("steel_palik"));
  EXPECT_NEAR(reflectance(findConductor("K")->eta.x, findConductor("K")->k.x), 0.95, 0.04);
  EXPECT_LT(reflectance(findConductor("a-C")->eta.y, findConductor("a-C")->k.y), 0.25);
}

TEST(Conductors, AnUnknownNameIsNotFoundAndTheKnownOnesCanBeListed) {
  EXPECT_FALSE(findConductor("cu"));
  EXPECT_NE(conductorNames().find("none, a-C, Ag, Al"), std::string::npos);
}

}  // namespace
}  // namespace saccade
