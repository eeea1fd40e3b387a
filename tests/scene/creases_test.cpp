// Normals that stop at edges.
#include "scene/mesh/creases.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "scene/mesh/mesh.h"
#include "scene/mitsuba_scratch.h"

namespace saccade {
namespace {

// Two squares that meet at the z axis: one lies, and the other leans by this angle, in degrees.
Mesh roof(double degrees) {
  const double a = degrees * std::numbers::pi / 180;
  const Vec3 up = toFloat(Vec3d{-std::cos(a), std::sin(a), 0});
  Mesh mesh;
  mesh.positions = {{1, 0, 0}, {0, 0, 0}, {0, 0, 1}, {1, 0, 1}, up, up + Vec3{0, 0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}};
  return mesh;
}

// The normals at the edge, as multiples of the angle of the roof.
std::set<int> turnsAtEdge(double degrees, double most, const Affine& to_world = {}) {
  Mesh mesh = roof(degrees);
  splitAtCreases(mesh, to_world, most);
  placeMesh(mesh, to_world, false);
  std::set<int> turns;
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t i : t)
      if (mesh.positions[i].x == 0)
        turns.insert(static_cast<int>(std::lround(
            std::atan2(std::abs(mesh.normals[i].x), std::abs(mesh.normals[i].y)) * 180 / std::numbers::pi)));
  return turns;
}

TEST(Creases, StayBetweenFacesThatMeetAtMore) {
  EXPECT_EQ(turnsAtEdge(40, 30), (std::set<int>{0, 40}));
}

TEST(Creases, AreSmoothBetweenFacesThatMeetAtLess) {
  EXPECT_EQ(turnsAtEdge(40, 50), std::set<int>{20});
}

// Twice as high a roof of 40 degrees leans by atan(2 tan 40), which is 59 degrees.
TEST(Creases, AreThoseOfThePlacedMesh) {
  const Affine twice{{1, 0, 0}, {0, 2, 0}, {0, 0, 1}, {}};
  EXPECT_EQ(turnsAtEdge(40, 50, twice), (std::set<int>{0, 59}));
}

// Of a cube, each corner has three faces and one vertex for each of them.
TEST(Creases, JoinVerticesOfEqualPlace) {
  Mesh cube = makeCube();
  cube.uvs.clear();
  splitAtCreases(cube, {}, 120);
  EXPECT_EQ(cube.positions.size(), 8u);
  cube = makeCube();
  splitAtCreases(cube, {}, 30);
  EXPECT_EQ(cube.positions.size(), 24u);
  EXPECT_EQ(cube.uvs.size(), 24u);
}

TEST(Creases, AreReadOfMeshFiles) {
  const Scratch files;
  files.write("roof.obj", "v 1 0 0\nv 0 0 0\nv 0 0 1\nv 0 1 0\nf 1 2 3\nf 2 4 3\n");
  const auto vertices = [&](const std::string& more) {
    const Scene scene =
        loadBody(files, "<shape type='obj'><string name='filename' value='roof.obj'/>" + more + "</shape>");
    return scene.meshes.at(0).positions.size() - 1;  // without the spare one
  };
  EXPECT_EQ(vertices(""), 4u);
  EXPECT_EQ(vertices("<float name='maxSmoothAngle' value='40'/>"), 6u);
  EXPECT_EQ(vertices("<float name='max_smooth_angle' value='120'/>"), 4u);
  expectContains(errorOf([&] { vertices("<float name='maxSmoothAngle' value='200'/>"); }), "within [0, 180]");
  expectContains(
      errorOf([&] {
        vertices("<float name='maxSmoothAngle' value='9'/><boolean name='faceNormals' value='true'/>");
      }),
      "no max_smooth_angle beside face_normals");
}

}  // namespace
}  // namespace saccade
