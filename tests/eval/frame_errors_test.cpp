#include "eval/metrics/frame_errors.h"

#include <gtest/gtest.h>

#include <cmath>

#include "eval/planes.h"

namespace saccade::eval {
namespace {

using test::plane;

IntensityChange change(ImageF dI, ImageF I_prev) {
  IntensityChange c(dI.width(), dI.height());
  c.dI = std::move(dI);
  c.I_prev = std::move(I_prev);
  return c;
}

TEST(FrameErrors, AreZeroForTheReferenceItself) {
  const IntensityChange c = change(plane({0.5f, -0.3f, 0}), plane({1, 1, 2}));
  const FrameErrors e = frameErrors(c, c, 1e-3f, 0.2);
  for (double figure :
       {e.dI_l1, e.dI_mape, e.dL_l1, e.dL_mape, e.rates.false_events, e.rates.missed_events}) {
    EXPECT_EQ(figure, 0);
  }
}

// The change is right on a denominator that is twice too dark: dI has no error, but dL and the events have.
TEST(FrameErrors, TakeEachChangeWithItsOwnBrightness) {
  const float bias = 0.5f;
  const double C = 0.2, dL = std::log(1.25 / 1.0), dL_ref = std::log(1.75 / 1.5);  // 0.223 and 0.154
  const FrameErrors e =
      frameErrors(change(plane({0.25f}), plane({0.5f})), change(plane({0.25f}), plane({1})), bias, C);
  EXPECT_EQ(e.dI_l1, 0);
  EXPECT_EQ(e.dI_mape, 0);
  EXPECT_NEAR(e.dL_l1, (dL - dL_ref) / dL_ref, 1e-6);
  EXPECT_NEAR(e.dL_mape, (dL - dL_ref) / (1.01 * dL_ref), 1e-6);
  // Ours crosses a threshold at every phase. The reference crosses it at the phases above C - 0.154. So there
  // is one event where the reference has none.
  EXPECT_NEAR(e.rates.false_events, 1 - dL_ref / C, 1e-6);
  EXPECT_EQ(e.rates.missed_events, 0);
}

}  // namespace
}  // namespace saccade::eval
