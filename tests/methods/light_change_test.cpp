#include "methods/light_change.h"

#include <gtest/gtest.h>

#include "base/tile_pool.h"

namespace saccade {
namespace {

constexpr int kW = 24, kH = 16;
constexpr float kPixel = 0.01f;

// A camera before a wall, under lamps with several sets of strengths.
struct LightChangeTest : testing::Test {
  LightChangeTest() : cur(kW, kH, 1), prev(kW, kH, 1) {
    for (Frame* f : {&cur, &prev}) {
      f->g.z.fill(1), f->g.z_in_prev.fill(1), f->g.dz.fill(0.01f), f->g.albedo.fill(1);
      for (int y = 0; y < kH; ++y) std::fill_n(f->g.nz.row(y), kW, 1.f);
    }
  }

  // A frame that shows the wall from `left` pixels on, where light changes by `d`.
  void step(std::uint64_t strengths, float left, float d) {
    SurfaceSamples& on = *cur.surfaces;
    on.changes().resize(on.indexOf(0, kH));
    for (int y = 0; y < kH; ++y)
      for (int x = 0; x < kW; ++x) {
        const std::size_t i = on.indexOf(x, y);
        on[i] = {.share = 1, .kind = SurfaceKind::kDiffuse, .paths = 1};
        const Vec3 at{(left + float(x)) * kPixel, float(y) * kPixel, 0};
        on.place(i) = {at, {0, 0, 1}, kPixel, 0};
        on.light(i).residual = 1 + d, on.changes()[i] = d;
      }
    estimateChange(strengths);
  }
  // Of the samples of `cur`.
  void estimateChange(std::uint64_t strengths) {
    states.enter(strengths, frame++);
    Placement before;
    states.current().grid.place(*cur.surfaces, nullptr, pool, before, at);
    change.estimate({cur, prev}, at, states.current(), pool, times);
  }
  void expectChange(float d) const {
    for (int y = 0; y < kH; ++y)
      for (int x = 0; x < kW; ++x) EXPECT_NEAR(change.change().at(x, y), d, 1e-5) << x << ' ' << y;
  }

  Frame cur, prev;
  TilePool pool{2};
  LightStates states{{}, std::size_t{1} << 24};
  Placement at;
  LightChange change{kW, kH};
  StageTimes times;
  std::uint32_t frame = 0;
};

TEST_F(LightChangeTest, AnEvenChangeIsFoundExactly) {
  for (int t = 0; t < 4; ++t) step(1, 0.3f * float(t), 0.25f);
  expectChange(0.25f);
}

TEST_F(LightChangeTest, AFrameWithoutDifferencesHasNoChange) {
  for (int t = 0; t < 4; ++t) step(1, 0.3f * float(t), 0.25f);
  step(1, 1.2f, 0);
  expectChange(0);
}

// Equal noise of the change is a smaller share of brighter light.
TEST_F(LightChangeTest, TheErrorOfAChangeIsRelativeToTheLight) {
  const auto errorIn = [&](float light) {
    const auto strengths = static_cast<std::uint64_t>(100 * light);
    for (int t = 0; t < 8; ++t) {
      step(strengths, 0, 0);
      SurfaceSamples& on = *cur.surfaces;
      for (std::size_t i = 0; i < on.indexOf(0, kH); ++i) {
        on.light(i).residual = light;
        on.changes()[i] = (i / 3 + static_cast<std::size_t>(t)) % 2 ? -0.01f : 0.01f;
      }
      estimateChange(strengths);
      states.current().grid.add({on, cur.g, at}, pool);
    }
    ImageF error(kW, kH);
    const LightState& state = states.current();
    state.grid.errorOfChange({*cur.surfaces, cur.g, at}, state.changes, pool, error);
    return error.at(kW / 2, kH / 2);
  };
  const float bright = errorIn(1), dark = errorIn(0.1f);
  EXPECT_GT(bright, 0);
  EXPECT_NEAR(dark / bright, 10, 0.01);
}

// The grids of two sets of strengths have vertices of their own, in an order of their own.
TEST_F(LightChangeTest, EverySetOfStrengthsHasChangesOfItsOwn) {
  step(1, 0, 0.25f);
  step(2, 9, -0.5f);
  for (int t = 0; t < 4; ++t) {
    step(1, 0.3f * float(t), 0.25f);
    expectChange(0.25f);
    step(2, 9 - 0.3f * float(t), -0.5f);
    expectChange(-0.5f);
  }
}

}  // namespace
}  // namespace saccade
