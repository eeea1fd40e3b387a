#include "scene/mesh/mesh.h"

#include <cmath>
#include <numbers>

#include "scene/scratch.h"

namespace saccade {
namespace {

constexpr Affine kMirror{{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {}};

Vec3 faceNormal(const Mesh& mesh, std::size_t triangle) {
  const auto& t = mesh.triangles[triangle];
  const Vec3 a = mesh.positions[t[0]];
  return normalize(cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a));
}

double area(const Mesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]];
    sum += 0.5 * length(cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a));
  }
  return sum;
}

TEST(Rectangle, FacesUpZWithUvOverItsCorners) {
  const Mesh mesh = makeRectangle();
  EXPECT_NEAR(area(mesh), 4, 1e-6);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_FLOAT_EQ(mesh.uvs[i].x, (mesh.positions[i].x + 1) / 2);
    EXPECT_FLOAT_EQ(mesh.uvs[i].y, (mesh.positions[i].y + 1) / 2);
  }
  expectNear(faceNormal(mesh, 0), {0, 0, 1}, 1e-6);
  expectNear(faceNormal(mesh, 1), {0, 0, 1}, 1e-6);
}

TEST(Cube, FacesOutwardsOnAllSides) {
  const Mesh mesh = makeCube();
  EXPECT_NEAR(area(mesh), 24, 1e-5);
  EXPECT_EQ(mesh.uvs.size(), 24u);
  Vec3 sum;
  for (std::size_t i = 0; i < 12; ++i) {
    const Vec3 n = faceNormal(mesh, i);
    EXPECT_FLOAT_EQ(dot(n, mesh.positions[mesh.triangles[i][0]]), 1);  // the face lies at distance 1 along n
    sum = sum + n;
  }
  expectNear(sum, {0, 0, 0}, 1e-6);
}

// Mitsuba's parametrisation: for each side its normal, and the directions in which u and v grow.
TEST(Cube, HasMitsubasTextureCoordinates) {
  struct Side {
    Vec3 normal, u, v;
  };
  const Side sides[] = {{{0, -1, 0}, {0, 0, 1}, {1, 0, 0}}, {{0, 1, 0}, {-1, 0, 0}, {0, 0, -1}},
                        {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}, {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}},
                        {{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 0, -1}, {0, -1, 0}, {1, 0, 0}}};
  const Mesh mesh = makeCube();
  for (const Side& side : sides) {
    int corners = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      if (dot(faceNormal(mesh, i), side.normal) < 0.5f) continue;
      for (const std::uint32_t k : mesh.triangles[i]) {
        ++corners;
        EXPECT_FLOAT_EQ(mesh.uvs[k].x, (dot(mesh.positions[k], side.u) + 1) / 2);
        EXPECT_FLOAT_EQ(mesh.uvs[k].y, (dot(mesh.positions[k], side.v) + 1) / 2);
      }
    }
    EXPECT_EQ(corners, 6);
  }
}

// Mitsuba's uv: the radius, and the angle in turns.
TEST(Disk, FacesUpZWithPolarUv) {
  const Mesh mesh = makeDisk();
  EXPECT_NEAR(area(mesh), std::numbers::pi, 1.1e-4 * std::numbers::pi);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) expectNear(faceNormal(mesh, i), {0, 0, 1}, 1e-4);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const double r = mesh.uvs[i].x, angle = 2 * std::numbers::pi * mesh.uvs[i].y;
    expectNear(mesh.positions[i], toFloat(Vec3d{r * std::cos(angle), r * std::sin(angle), 0}), 1e-6);
  }
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t i : t) EXPECT_NEAR(mesh.uvs[i].y, mesh.uvs[t[0]].y, 1.0 / kDiskCorners);
}

TEST(PlaceMesh, LeavesASparePositionThatNoTriangleUses) {
  Mesh mesh = makeCube();
  placeMesh(mesh, {}, true);
  EXPECT_EQ(mesh.positions.size(), 25u);
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t i : t) EXPECT_LT(i, 24u);
}

TEST(PlaceMesh, AMirrorKeepsTheFrontInFront) {
  Mesh rectangle = makeRectangle(), cube = makeCube();
  placeMesh(rectangle, kMirror, true);
  expectNear(faceNormal(rectangle, 0), {0, 0, 1}, 1e-6);
  placeMesh(cube, kMirror, true);
  for (std::size_t i = 0; i < 12; ++i)
    EXPECT_FLOAT_EQ(dot(faceNormal(cube, i), cube.positions[cube.triangles[i][0]]), 1);
}

// A plane with normal n keeps normal to its image: the inverse transpose, whatever the map.
TEST(PlaceMesh, NormalsStayNormalToTheSurface) {
  for (const Affine& map : {Affine{{1, 0, 0}, {0.5, 3, 0}, {0, -1, 0.2}, {5, 6, 7}},
                            Affine{{-1, 0, 0}, {0.5, 3, 0}, {0, -1, 0.2}, {5, 6, 7}}}) {
    Mesh mesh = makeRectangle();
    mesh.normals.assign(4, {0, 0, 2});
    placeMesh(mesh, map, false);
    EXPECT_NEAR(length(mesh.normals[0]), 1, 1e-6);
    expectNear(mesh.normals[0], faceNormal(mesh, 0), 1e-6);
  }
}

TEST(PlaceMesh, FaceNormalsDropTheGivenOnes) {
  Mesh mesh = makeRectangle();
  mesh.normals.assign(4, {0, 1, 0});
  placeMesh(mesh, {}, true);
  EXPECT_TRUE(mesh.normals.empty());
}

// A corner of a cube whose three faces are cut into different numbers of triangles: only weighting by angle
// gives the diagonal.
TEST(PlaceMesh, SmoothNormalsWeighFacesByTheirAngle) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {5, 5, 0}};
  mesh.triangles = {{0, 1, 4}, {0, 4, 2}, {0, 2, 3}, {0, 3, 1}};
  placeMesh(mesh, {}, false);
  const float d = 1 / std::sqrt(3.0f);
  expectNear(mesh.normals[0], {d, d, d}, 1e-6);
}

TEST(PlaceMesh, DegenerateTrianglesStillGiveUnitNormals) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  mesh.triangles = {{0, 1, 2}, {1, 1, 1}};
  placeMesh(mesh, {}, false);
  for (const Vec3 n : mesh.normals) EXPECT_FLOAT_EQ(length(n), 1);
}

}  // namespace
}  // namespace saccade
