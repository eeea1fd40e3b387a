#include "scene/mesh/round_shapes.h"

#include <cmath>
#include <numbers>

#include "scene/mitsuba_scratch.h"

namespace saccade {
namespace {

constexpr double kPi = std::numbers::pi;

Vec3 normalOf(const Mesh& mesh, std::size_t triangle) {
  const auto& t = mesh.triangles[triangle];
  const Vec3 a = mesh.positions[t[0]];
  return cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a);
}

double area(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) sum += 0.5 * length(normalOf(mesh, i));
  return sum;
}

void expectTurnedTo(const Mesh& mesh, float side) {
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    ASSERT_GT(length(normalOf(mesh, i)), 0);
    ASSERT_GT(side * dot(normalOf(mesh, i), mesh.normals[mesh.triangles[i][0]]), 0);
  }
}

TEST(RoundShapes, HaveTheirAreaAndFaceOutwards) {
  const Mesh cylinder = makeCylinder(), sphere = makeSphere();
  EXPECT_NEAR(area(cylinder), 2 * kPi, 1e-3);
  EXPECT_NEAR(area(sphere), 4 * kPi, 2e-3);
  expectTurnedTo(cylinder, 1), expectTurnedTo(sphere, 1);
  for (std::size_t i = 0; i < sphere.positions.size(); ++i) EXPECT_EQ(sphere.normals[i], sphere.positions[i]);
}

TEST(RoundShapes, ACylinderStandsBetweenItsPoints) {
  const Scratch files;
  const Scene s = loadBody(files,
                           "<shape type='cylinder'><point name='p0' value='1, 2, 3'/><point name='p1' "
                           "value='1, 2, 8'/><float name='radius' value='0.5'/></shape>"
                           "<shape type='cylinder'><boolean name='flip_normals' value='true'/></shape>");
  const Mesh& mesh = s.meshes.at(0);
  EXPECT_EQ(mesh.name, "cylinder");
  EXPECT_NEAR(area(mesh), kPi * 5, 3e-3);
  expectTurnedTo(mesh, 1);
  for (std::size_t i = 0; i + 1 < mesh.positions.size(); ++i) {
    const Vec3 p = mesh.positions[i] - Vec3{1, 2, 3};
    EXPECT_NEAR(std::hypot(p.x, p.y), 0.5, 1e-6);
    EXPECT_NEAR(p.z, 5 * mesh.uvs[i].y, 1e-6);
  }
  const Mesh& turned = s.meshes.at(1);
  for (std::size_t i = 0; i < turned.triangles.size(); ++i) {
    const Vec3 p = turned.positions[turned.triangles[i][0]];
    ASSERT_LT(dot(normalOf(turned, i), {p.x, p.y, 0}), 0);
  }
}

// A room that shines from all around, as authors make skies.
TEST(RoundShapes, ASphereThatFacesInwardsIsAMesh) {
  const Scratch files;
  const Scene s = loadBody(files,
                           "<shape type='sphere'><boolean name='flipNormals' value='true'/><point "
                           "name='center' value='0, 1, 0'/><float name='radius' value='3'/>"
                           "<emitter type='area'/></shape>");
  EXPECT_TRUE(s.spheres.empty());
  const Mesh& mesh = s.meshes.at(0);
  EXPECT_EQ(mesh.radiance, (Rgb{1, 1, 1}));
  EXPECT_NEAR(area(mesh), 36 * kPi, 0.02);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Vec3 p = mesh.positions[mesh.triangles[i][0]] - Vec3{0, 1, 0};
    EXPECT_NEAR(length(p), 3, 1e-5);
    ASSERT_LT(dot(normalOf(mesh, i), p), 0);
  }
}

}  // namespace
}  // namespace saccade
