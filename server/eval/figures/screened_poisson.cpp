#include "eval/figures/screened_poisson.h"

#include <cmath>

#include "base/log_ratio.h"
#include "eval/metrics/brightness_change.h"
#include "eval/metrics/for_each_pixel.h"

namespace saccade::eval {

// Thomas' algorithm for the tridiagonal equations.
std::vector<double> screenedPoisson(const std::vector<double>& prim, const std::vector<double>& dL,
                                    double alpha) {
  SACCADE_CHECK(prim.size() == dL.size() + 1);
  const double lambda = alpha * alpha;
  const std::size_t n = prim.size();
  std::vector<double> pivot(n), L(n);
  for (std::size_t t = 0; t < n; ++t) {
    const bool has_before = t > 0, has_next = t + 1 < n;
    pivot[t] = lambda + has_before + has_next;
    L[t] = lambda * prim[t] + (has_before ? dL[t - 1] : 0) - (has_next ? dL[t] : 0);
    if (has_before) pivot[t] -= 1 / pivot[t - 1], L[t] += L[t - 1] / pivot[t - 1];
  }
  L[n - 1] /= pivot[n - 1];
  for (std::size_t t = n - 1; t-- > 0;) L[t] = (L[t] + L[t + 1]) / pivot[t];
  return L;
}

BrightnessSequence screenedPoisson(const ChangeSequence& run, double bias, double alpha) {
  const ImageF& first = run.front()->I_prev;
  const auto added = static_cast<float>(bias);
  BrightnessSequence solved{ImageF(first.width(), first.height()), {}};
  for (const IntensityChange* change : run) solved.dL.push_back(brightnessChange(*change, added));
  const auto brightness = [&](float I) { return std::log(added + clampTo(I, 0, kMaxLuminance)); };
  forEachPixel(first, [&](int x, int y) {
    std::vector<double> prim{brightness(first.at(x, y))}, dL;
    for (std::size_t t = 0; t < run.size(); ++t) {
      prim.push_back(brightness(run[t]->I_now.at(x, y)));
      dL.push_back(solved.dL[t].at(x, y));
    }
    const std::vector<double> L = screenedPoisson(prim, dL, alpha);
    solved.L_start.at(x, y) = static_cast<float>(L[0]);
    for (std::size_t t = 0; t < run.size(); ++t) solved.dL[t].at(x, y) = static_cast<float>(L[t + 1] - L[t]);
  });
  return solved;
}

}  // namespace saccade::eval
