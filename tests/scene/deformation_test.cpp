// Forms of meshes over time, against formulas.
#include "scene/deformation/deformation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/counting_new.h"
#include "scene/scratch.h"

namespace saccade {
namespace {

using namespace std::chrono_literals;
constexpr double kPi = std::numbers::pi;

// A node that turns about z by a quarter in a second, and one that stands.
std::vector<MovingNode> turningNode() {
  const auto half = static_cast<float>(std::sqrt(0.5));
  KeyTrack turn{KeyInterpolation::kLinear, true, 4, {0, 1}, {0, 0, 0, 1, 0, 0, half, half}};
  return {{{}, {}}, {0, {}, {{NodeTrack::Property::kRotation, turn}}}};
}

struct Shape {
  std::vector<Vec3> positions, normals;
};

Shape shapeAt(const Deformation& d, const std::vector<MovingNode>& nodes, TimeNs t) {
  NodePoses poses(nodes);
  MeshForm form;
  setForm(d, poses, t, form);
  Shape shape{d.positions, d.normals};
  deform(d, form, shape.positions, shape.normals);
  return shape;
}

void expectNear(Vec3 a, Vec3 b) {
  EXPECT_LT(length(a - b), 1e-6f) << a.x << " " << a.y << " " << a.z;
}

// The vertex goes halfway between where the joints would put it, and its normal is that of the mean map.
TEST(Skin, IsTheWeightedMeanOfWhereJointsPutAVertex) {
  const std::vector<MovingNode> nodes = turningNode();
  Deformation d{{{2, 0, 0}, {2, 0, 0}, {2, 0, 0}}, {{0, 1, 0}, {0, 1, 0}, {0, 1, 0}}};
  d.joints = {{0, {}}, {1, {}}};
  d.influences = {
      {{0, 1, 0, 0}, {1, 0, 0, 0}}, {{0, 1, 0, 0}, {0.5f, 0.5f, 0, 0}}, {{0, 1, 0, 0}, {0, 1, 0, 0}}};
  const Shape shape = shapeAt(d, nodes, 500ms);
  const auto c = static_cast<float>(std::cos(kPi / 4));
  expectNear(shape.positions[0], {2, 0, 0});
  expectNear(shape.positions[1], {1 + c, c, 0});
  expectNear(shape.positions[2], {2 * c, 2 * c, 0});
  expectNear(shape.normals[2], {-c, c, 0});
  expectNear(shape.normals[1], normalize(Vec3{-c / 2, (1 + c) / 2, 0}));
}

// x goes to 3 x: a normal at 45 degrees leans towards y.
TEST(Skin, TurnsNormalsByTheInverseTranspose) {
  std::vector<MovingNode> nodes{{{}, {}}};
  nodes[0].rest.scale = {3, 1, 1};
  Deformation d{{{1, 0, 0}}, {normalize(Vec3{1, 1, 0})}};
  d.joints = {{0, {}}};
  const Shape shape = shapeAt(d, nodes, 0ns);
  expectNear(shape.positions[0], {3, 0, 0});
  expectNear(shape.normals[0], normalize(Vec3{1 / 3.f, 1, 0}));
}

TEST(Morph, AddsTargetsByTheirWeights) {
  Deformation d{{{1, 0, 0}}, {{0, 0, 1}}};
  d.targets = {{{{0, 2, 0}}, {}}, {{{0, 0, 4}}, {{1, 0, 0}}}};
  d.weights = {0, 0};
  d.weight_keys = {KeyInterpolation::kLinear, false, 2, {0, 1}, {0, 0, 1, 0.5f}};
  d.joints = {{{}, {}}};
  const Shape shape = shapeAt(d, {}, 500ms);
  expectNear(shape.positions[0], {1, 1, 1});
  expectNear(shape.normals[0], normalize(Vec3{0.25f, 0, 1}));
}

TEST(Deformation, BeyondAllNumbersIsAtTheOrigin) {
  std::vector<MovingNode> nodes{{{}, {}}};
  nodes[0].rest.scale = {1e30, 1e30, 1e300};
  Deformation d{{{1, 1, 1}}, {{0, 0, 1}}};
  d.joints = {{0, {}}};
  const Shape shape = shapeAt(d, nodes, 0ns);
  EXPECT_EQ(shape.positions[0], Vec3{});
  EXPECT_NEAR(length(shape.normals[0]), 1, 1e-6);
}

TEST(Deformation, RepeatsWithItsPeriod) {
  const std::vector<MovingNode> nodes = turningNode();
  Deformation d{{{1, 0, 0}}, {}};
  d.joints = {{1, {}}};
  expectNear(shapeAt(d, nodes, 2300ms).positions[0], {0, 1, 0});  // at its end
  d.period = 1s;
  expectNear(shapeAt(d, nodes, 2300ms).positions[0], shapeAt(d, nodes, 300ms).positions[0]);
}

// Also where one MeshForm is used for deformations of several sizes.
TEST(Deformation, AllocatesNothingAfterItsFirstForm) {
  const std::vector<MovingNode> nodes = turningNode();
  Deformation small{{{1, 0, 0}}, {}}, large = small;
  small.joints = {{1, {}}}, large.joints.assign(9, {1, {}});
  large.influences = {{}};
  NodePoses poses(nodes);
  MeshForm form;
  std::vector<Vec3> positions(1);
  int before = 0;
  for (int t = 0; t < 4; ++t) {
    if (t == 1) before = test::allocations();
    for (const Deformation* d : {&large, &small}) {
      setForm(*d, poses, t * 100ms, form);
      deform(*d, form, positions, {});
    }
  }
  EXPECT_EQ(test::allocations(), before);
}

// Four weights are no quaternion: between keys they are a line.
TEST(KeyTrack, OfFourWeightsIsALine) {
  const KeyTrack keys{KeyInterpolation::kLinear, false, 4, {0, 1}, {1, 0, 0, 0, 0, 1, 0, 0}};
  double v[4];
  keys.at(0.25, v);
  EXPECT_DOUBLE_EQ(v[0], 0.75);
  EXPECT_DOUBLE_EQ(v[1], 0.25);
}

}  // namespace
}  // namespace saccade
