#include "eval/sensor/queue.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace saccade::eval {
namespace {

// P(A > m) for m = 0, 1, ... of a Poisson number A of mean rho, without what is below 1e-18.
std::vector<double> poissonTails(double rho) {
  std::vector<double> terms;
  double term = std::exp(-rho);
  for (int m = 0; m <= rho || term > 1e-18; term *= rho / ++m) terms.push_back(term);
  std::vector<double> tails(terms.size());
  for (std::size_t m = terms.size() - 1; m > 0; --m) tails[m - 1] = tails[m] + terms[m];
  return tails;
}

// How often a departure leaves 0, 1, ... `waiting` behind, up to a factor. The chain goes up across a level
// as often as down; no term is negative, so that nothing cancels.
std::vector<double> leftBehind(double rho, int waiting) {
  constexpr double kLarge = 1e100;
  const std::vector<double> above = poissonTails(rho);
  const auto tail = [&](int m) { return m < static_cast<int>(above.size()) ? above[m] : 0.0; };
  std::vector<double> left{1};
  for (int level = 0; level < waiting; ++level) {
    double up = left[0] * tail(level);
    for (int i = std::max(1, level + 2 - static_cast<int>(above.size())); i <= level; ++i)
      up += left[i] * tail(level + 1 - i);
    left.push_back(up / std::exp(-rho));
    if (left.back() < kLarge) continue;
    for (double& share : left) share /= kLarge;
  }
  return left;
}

}  // namespace

QueueLoad expectedQueue(double offered_hz, double service_hz, int waiting) {
  const double rho = offered_hz / service_hz;
  const std::vector<double> left = leftBehind(rho, waiting);
  double sum = 0, queued = 0;
  for (std::size_t n = 0; n < left.size(); ++n) {
    sum += left[n];
    if (n > 0) queued += static_cast<double>(n - 1) * left[n];
  }
  const double idle = left[0] / sum + rho;  // the time between two departures, in services
  const double lost = std::max(0.0, 1 - 1 / idle);
  const double waits = queued / sum / idle + waiting * lost;  // how many wait, at any time
  return {lost, waits / (offered_hz * (1 - lost))};
}

}  // namespace saccade::eval
