// Lenses against the formulas of OpenCV, written here on their own, and their inverses.
#include "scene/camera/lens.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace saccade {
namespace {

const Distortion kBarrel{LensModel::kRadTan, {-0.33, 0.12, 0.0015, -0.0008, -0.02}};
const Distortion kPincushion{LensModel::kRadTan, {0.25, 0.08, -0.001, 0.002, 0}};
const Distortion kFisheye{LensModel::kEquidistant, {-0.02, 0.006, -0.003, 0.0005, 0}};

CameraModel camera(const Distortion& distortion, double fx = 330, double fy = 325) {
  return {
      .width = 346, .height = 260, .fx = fx, .fy = fy, .cx = 170.5, .cy = 133.25, .distortion = distortion};
}

// As the documentation of cv2.projectPoints has it.
PlanePoint openCvPixel(const CameraModel& c, double X, double Y, double Z) {
  const auto& k = c.distortion.k;
  const double a = X / Z, b = Y / Z, r2 = a * a + b * b;
  if (c.distortion.model == LensModel::kEquidistant) {
    const double r = std::sqrt(r2), t = std::atan(r);
    const double d = t * (1 + k[0] * std::pow(t, 2) + k[1] * std::pow(t, 4) + k[2] * std::pow(t, 6) +
                          k[3] * std::pow(t, 8));
    return {c.fx * (d / r) * a + c.cx, c.fy * (d / r) * b + c.cy};
  }
  const double radial = 1 + k[0] * r2 + k[1] * r2 * r2 + k[4] * r2 * r2 * r2;
  return {c.fx * (a * radial + 2 * k[2] * a * b + k[3] * (r2 + 2 * a * a)) + c.cx,
          c.fy * (b * radial + k[2] * (r2 + 2 * b * b) + 2 * k[3] * a * b) + c.cy};
}

TEST(Lens, ShowsPointsWhereOpenCvDoes) {
  for (const Distortion& distortion : {Distortion{}, kBarrel, kPincushion, kFisheye}) {
    const CameraModel model = camera(distortion);
    const Lens lens(model);
    for (double X = -1.1; X < 1.2; X += 0.37) {
      for (double Y = -0.8; Y < 0.9; Y += 0.23) {
        const PlanePoint expected = openCvPixel(model, X, Y, 2), found = lens.pixelOf({X / 2, Y / 2});
        EXPECT_NEAR(found.x, expected.x, 1e-9);
        EXPECT_NEAR(found.y, expected.y, 1e-9);
      }
    }
  }
}

// Over the whole picture with its corners, at the centres of pixels and between them.
TEST(Lens, TheInverseLeadsBackToThePixel) {
  for (const Distortion& distortion : {Distortion{}, kBarrel, kPincushion, kFisheye}) {
    for (const double f : {140.0, 330.0, 900.0}) {
      const CameraModel model = camera(distortion, f, 0.98 * f);
      if (!lensFault(model).empty()) continue;
      Lens lens(model), solved(model);
      lens.tabulate();
      double largest = 0;
      const auto add = [&](float x, float y) {
        for (const Lens* l : {&lens, &solved}) {
          const Vec2 p = l->planePoint(x, y);
          const PlanePoint back = l->pixelOf({p.x, p.y});
          largest = std::max({largest, std::abs(back.x - x), std::abs(back.y - y)});
        }
      };
      for (int y = 0; y < model.height; y += 13)
        for (int x = 0; x < model.width; x += 11) add(x, y), add(x + 0.37f, y - 0.41f);
      for (const float y : {0.f, 259.f})
        for (const float x : {0.f, 345.f}) add(x, y), add(x + 0.5f, y + 0.5f), add(x - 0.5f, y - 0.5f);
      EXPECT_LT(largest, 1e-4) << f;
    }
  }
}

TEST(Lens, SlopeIsTheDifferenceOfPixels) {
  constexpr double kStep = 1e-6;
  for (const Distortion& distortion : {kBarrel, kPincushion, kFisheye}) {
    const Lens lens(camera(distortion));
    for (const PlanePoint p : {PlanePoint{}, PlanePoint{0.31, -0.2}, PlanePoint{-0.5, 0.42}}) {
      const PlaneMap slope = lens.pixelSlope(p);
      const PlanePoint at = lens.pixelOf(p), right = lens.pixelOf({p.x + kStep, p.y}),
                       down = lens.pixelOf({p.x, p.y + kStep});
      EXPECT_NEAR(slope.xx, (right.x - at.x) / kStep, 1e-2);
      EXPECT_NEAR(slope.yx, (right.y - at.y) / kStep, 1e-2);
      EXPECT_NEAR(slope.xy, (down.x - at.x) / kStep, 1e-2);
      EXPECT_NEAR(slope.yy, (down.y - at.y) / kStep, 1e-2);
    }
  }
}

// r (1 - 0.4 r^2) is largest at r = 0.913, where it is 0.609: a picture that goes further is not shown.
TEST(Lens, ThatFoldsBackIsAFault) {
  const Distortion folding{LensModel::kRadTan, {-0.4, 0, 0, 0, 0}};
  const auto corner = [&](double at) {
    const double f = std::hypot(51, 51) / at;
    return CameraModel{
        .width = 101, .height = 101, .fx = f, .fy = f, .cx = 50, .cy = 50, .distortion = folding};
  };
  EXPECT_EQ(lensFault(corner(0.60)), "");
  EXPECT_NE(lensFault(corner(0.62)), "");
}

TEST(Lens, AFisheyeReaches85Degrees) {
  const auto corner = [&](double degrees) {
    const double f = std::hypot(51, 51) / (degrees * std::acos(-1.0) / 180);
    return CameraModel{.width = 101,
                       .height = 101,
                       .fx = f,
                       .fy = f,
                       .cx = 50,
                       .cy = 50,
                       .distortion = {LensModel::kEquidistant, {}}};
  };
  EXPECT_EQ(lensFault(corner(84.9)), "");
  EXPECT_NE(lensFault(corner(85.1)), "");
}

// The polynomial of this lens comes back to the centre at r = 1.58.
TEST(Lens, APointBeyondTheCornersStaysOutside) {
  const Lens lens({.width = 101,
                   .height = 101,
                   .fx = 150,
                   .fy = 150,
                   .cx = 50,
                   .cy = 50,
                   .distortion = {LensModel::kRadTan, {-0.4, 0, 0, 0, 0}}});
  for (const double r : {1.0, 1.5, 1.58, 2.0, 30.0}) EXPECT_GT(lens.pixelOf({r, 0}).x, 110) << r;
}

TEST(CameraModel, HasTheFocalLengthOfItsFieldOfView) {
  const CameraModel model = pinhole(90, 200, 100);
  EXPECT_NEAR(model.fx, 100, 1e-12);
  EXPECT_EQ(model.cx, 99.5);
  EXPECT_EQ(model.cy, 49.5);
  EXPECT_NEAR(fovXDeg(model), 90, 1e-12);
  EXPECT_EQ(resized(model, 64, 48).cy, 23.5);
  EXPECT_NEAR(resized(model, 64, 48).fx, 32, 1e-12);
}

}  // namespace
}  // namespace saccade
