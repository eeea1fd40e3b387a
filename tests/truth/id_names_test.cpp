#include "truth/id_names.h"

#include <gtest/gtest.h>

#include "base/text_cut.h"
#include "scene/motion/bodies.h"
#include "truth/object_numbers.h"

namespace saccade {
namespace {

using Names = std::vector<std::string>;

Names listOf(const google::protobuf::RepeatedPtrField<std::string>& names) {
  return {names.begin(), names.end()};
}

Mesh meshOf(const std::string& name) {
  Mesh mesh;
  mesh.name = name;
  return mesh;
}

Material materialOf(const std::string& name) {
  Material material;
  material.name = name;
  return material;
}

TEST(IdNames, AreInTheOrderOfTheNumbers) {
  Scene scene;
  scene.spheres.push_back({.name = "ball", .center = {}, .radiance = {}});
  for (const char* name : {"rectangle", "door", "rectangle", "ball"}) scene.meshes.push_back(meshOf(name));
  for (const char* name : {"diffuse", "paint", "diffuse"}) scene.materials.push_back(materialOf(name));
  const v1::IdNames names = idNames(scene);
  EXPECT_EQ(listOf(names.objects()), (Names{"rectangle_1", "door", "rectangle_3", "ball_4", "ball_5"}));
  EXPECT_EQ(listOf(names.materials()), (Names{"diffuse_1", "paint", "diffuse_3"}));
  EXPECT_EQ(names.further_objects(), 0u);
  EXPECT_EQ(names.further_materials(), 0u);
}

// It has poses, and no pixel shows it.
TEST(IdNames, OfALampThatMovesFollowThoseOfShapes) {
  Scene scene;
  for (const char* name : {"door", "arm"}) scene.meshes.push_back(meshOf(name));
  for (const char* name : {"spot", "arm", "sun"})
    scene.point_lights.push_back({.position = {}, .intensity = {}, .name = name});
  const std::vector<std::string> bodies{"arm", "spot"};
  setBodies(scene, bodies);
  EXPECT_EQ(listOf(idNames(scene).objects()), (Names{"door", "arm", "spot"}));
  EXPECT_EQ(bodyNumbers(scene), (std::vector<std::uint32_t>{2, 3}));
}

TEST(IdNames, AreBoundedAndTheRestIsCounted) {
  Scene scene;
  for (std::size_t i = 0; i < kMaxIdNames + 3; ++i) scene.meshes.push_back(meshOf("m" + std::to_string(i)));
  for (std::size_t i = 0; i < kMaxIdNames + 5; ++i) scene.materials.push_back(materialOf("grey"));
  const v1::IdNames names = idNames(scene);
  ASSERT_EQ(names.objects_size(), static_cast<int>(kMaxIdNames));
  ASSERT_EQ(names.materials_size(), static_cast<int>(kMaxIdNames));
  EXPECT_EQ(names.further_objects(), 3u);
  EXPECT_EQ(names.further_materials(), 5u);
  EXPECT_EQ(names.objects(kMaxIdNames - 1), "m4095");
  EXPECT_EQ(names.materials(kMaxIdNames - 1), "grey_4096");
}

// Two bytes for each character, and a byte that is none.
TEST(IdNames, AreValidTextOfBoundedLength) {
  std::string umlauts;
  for (int i = 0; i < 100; ++i) umlauts += "\xc3\xa4";
  Scene scene;
  for (const std::string& name : {umlauts, umlauts, std::string("a\xff")})
    scene.meshes.push_back(meshOf(name));
  const v1::IdNames names = idNames(scene);
  for (const std::string& name : names.objects()) {
    EXPECT_TRUE(isUtf8(name)) << name;
    EXPECT_LE(name.size(), kMaxIdNameBytes);
  }
  EXPECT_TRUE(names.objects(0).ends_with("..._1")) << names.objects(0);
  EXPECT_TRUE(names.objects(1).ends_with("..._2")) << names.objects(1);
}

}  // namespace
}  // namespace saccade
