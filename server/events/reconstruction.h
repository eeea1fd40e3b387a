// Brightness reconstruction (paper, 4.6 and Fig. 7): estimates the change of brightness from difference and
// primal.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "events/sensor_config.h"
#include "frame/intensity_change.h"

namespace saccade {

// dL is precise from frame to frame, but its small errors add up to a drift. The primal picture does not
// drift, but is noisy. A reconstruction weighs the two:
//
//   direct         L^_t = L^_{t-1} + dL_t [E (22)]. Drifts without bound. A static scene, whose dL is 0,
//   gives
//                  exactly no change.
//   complementary  L^_t = L- + k (L^prim_t - L-), L- = L^_{t-1} + dL_t, k = 1 - exp(-2 pi cutoff dt).
//                  An error b per frame in dL adds up to b (1 - k) / k and no further.
//   kalman         the same with k of each pixel from the variances of dL and L^prim (see kalman.cpp). The
//                  default. Compared with direct, EventSVGF has 10 to 33 % fewer false events, 0 to 11 % more
//                  missed ones, and at most half the drift (saccade-eval figure 7).
//
// Some methods know no variance of the primal: var_I_prev is 0 for pt and pt-correlated. Then kalman equals
// direct, but keeps L^ within the brightness that a pixel can have.
//
// L^prim = log(I_eps + I_now). L^_0 is that of the first I_prev; its error decays like a drift.
//
// A static scene under complementary does change: it passes the noise of the primal through a low-pass.
// Primal noise of variance s^2 and correlation rho^n between frames n apart leaves in L^ the variance
//
//   s^2 k / (2 - k) (1 + (1 - k) rho) / (1 - (1 - k) rho),
//
// which is 0.24^2 s^2 at 500 frames per second and the defaults (rho = 0.9). A pixel then fires now and then
// where 0.24 s is close to C. Under kalman a static scene gives exactly no change if the variance of dL is 0.
// Where motion ends, that variance and k decay as fast as the method forgets.
class Reconstruction {
 public:
  virtual ~Reconstruction() = default;
  // Replaces `dL`, the finite response of `change`, by L^_t - L^_{t-1}, finite. Call it for every interval,
  // in order. Does not touch the border, and does not allocate.
  virtual void reconstruct(const IntensityChange& change, ImageF& dL) = 0;
  // Whether it may change `dL`. The correction of an interval with updates is spread evenly over it.
  virtual bool corrects() const { return true; }
  // From the next interval on, dL and L^ are those of this I_eps. L^ stays the brightness of the same
  // intensity.
  virtual void setBias(double bias) = 0;
};

struct ReconstructionInfo {
  std::string name, description;
  std::unique_ptr<Reconstruction> (*make)(const SensorConfig& config, int width, int height);
};

// THE list of reconstructions. SensorConfig says which is the default.
const std::vector<ReconstructionInfo>& reconstructionTable();
const ReconstructionInfo* findReconstruction(const std::string& name);  // nullptr if there is none
std::string reconstructionNames();                                      // "direct, ..." for messages

}  // namespace saccade
