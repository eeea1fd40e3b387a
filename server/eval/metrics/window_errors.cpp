#include "eval/metrics/window_errors.h"

#include <algorithm>
#include <cstdlib>
#include <tuple>
#include <vector>

namespace saccade::eval {
namespace {

struct Timed {
  std::uint64_t cell;  // pixel, polarity and window
  std::int64_t t_ns;
};

std::vector<Timed> sorted(const Events& events, double window_ns) {
  std::vector<Timed> all;
  all.reserve(events.size());
  for (const Event& e : events) {
    const std::uint64_t pixel = std::uint64_t(e.y) << 16 | e.x, place = pixel << 1 | e.p;
    all.push_back(
        {place << 31 | static_cast<std::uint64_t>(static_cast<double>(e.t_ns) / window_ns), e.t_ns});
  }
  std::ranges::sort(all, [](const Timed& a, const Timed& b) {
    return std::tie(a.cell, a.t_ns) < std::tie(b.cell, b.t_ns);
  });
  return all;
}

}  // namespace

WindowErrors windowErrors(const Events& x, const Events& reference, double window_ns) {
  const std::vector<Timed> ours = sorted(x, window_ns), theirs = sorted(reference, window_ns);
  double only_ours = 0, only_theirs = 0, common = 0, dt_ns = 0;
  auto a = ours.begin();
  auto b = theirs.begin();
  while (a != ours.end() || b != theirs.end()) {
    if (b == theirs.end() || (a != ours.end() && a->cell < b->cell)) {
      ++only_ours, ++a;
    } else if (a == ours.end() || b->cell < a->cell) {
      ++only_theirs, ++b;
    } else {
      dt_ns += static_cast<double>(std::abs(a->t_ns - b->t_ns));
      ++common, ++a, ++b;
    }
  }
  const auto events = static_cast<double>(reference.size());
  return {only_ours / events, only_theirs / events, dt_ns / common / window_ns};
}

}  // namespace saccade::eval
