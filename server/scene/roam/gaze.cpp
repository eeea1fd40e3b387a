#include "scene/roam/gaze.h"

#include <algorithm>
#include <limits>
#include <span>

#include "base/hash_rng.h"
#include "base/quantile.h"

namespace saccade {
namespace {

constexpr std::size_t kViews = Panorama::kPans * Panorama::kTilts;
constexpr int kMostPan = 3, kMostTilt = 1;  // steps from place to place
// Of a view of nothing, and of a plane, in squared steps.
constexpr double kBlindCost = 80, kBlankCost = 12;
constexpr double kEnough = 0.9;        // of the best share around: a view that shows more is as good
constexpr double kRich = 0.8;          // of all views, this share has less relief than is enough
constexpr std::uint64_t kChoices = 6;  // of an aim
// How often an aim looks down or up: from the lowest row on.
constexpr double kTiltOdds[Panorama::kTilts] = {0.03, 0.07, 0.15, 0.2, 0.25, 0.15, 0.08, 0.05, 0.02};

struct View {
  int pan = 0, tilt = 0;
  std::size_t index() const { return static_cast<std::size_t>(tilt * Panorama::kPans + pan); }
};

View viewOf(std::size_t i) {
  return {static_cast<int>(i) % Panorama::kPans, static_cast<int>(i) / Panorama::kPans};
}

// Costs of views that show little.
class Dullness {
 public:
  explicit Dullness(const std::vector<Panorama>& around) {
    std::vector<double> reliefs;
    for (const Panorama& p : around)
      for (std::size_t i = 0; i < kViews; ++i) reliefs.push_back(p.relief(viewOf(i).pan, viewOf(i).tilt));
    relief_ = quantile(reliefs, kRich);
  }

  // By view.
  std::vector<double> costs(const Panorama& p) const {
    const double enough = kEnough * p.bestShare();
    std::vector<double> costs;
    for (std::size_t i = 0; i < kViews; ++i) {
      const auto [pan, tilt] = viewOf(i);
      costs.push_back(kBlindCost * lack(p.share(pan, tilt), enough) +
                      kBlankCost * lack(p.relief(pan, tilt), relief_));
    }
    return costs;
  }

 private:
  static double lack(double value, double enough) {
    return enough > 0 ? std::max(0.0, 1 - value / enough) : 0;
  }

  double relief_;  // that is enough
};

// Of some views that the seed draws, all of which show enough, the one that costs least.
View drawAim(const Panorama& p, const std::vector<double>& costs, std::uint64_t seed) {
  std::vector<double> odds(kViews);  // of this view or one before it
  double sum = 0;
  for (std::size_t i = 0; i < kViews; ++i) {
    const View view = viewOf(i);
    const bool shows = p.share(view.pan, view.tilt) >= kEnough * p.bestShare();
    odds[i] = sum += shows ? kTiltOdds[view.tilt] : 0;
  }
  std::size_t aim = kViews;
  for (std::uint64_t i = 0; i < kChoices; ++i) {
    const double drawn = toUnit(hashKey(seed, i)) * sum;
    const auto view = static_cast<std::size_t>(std::ranges::upper_bound(odds, drawn) - odds.begin());
    if (aim == kViews || costs[view] < costs[aim]) aim = view;
  }
  return viewOf(aim);
}

// The cheapest views between two aims, by dynamic programming: Viterbi's.
class Turn {
 public:
  // `costs` of the views of each place from the first on.
  explicit Turn(std::span<const std::vector<double>> costs) : costs_(costs) {}

  // One view for each place; the turn ends at `to`, one place later.
  std::vector<View> cheapest(View from, View to) {
    std::vector<double> sums(kViews, std::numeric_limits<double>::infinity());
    sums[from.index()] = 0;
    for (const std::vector<double>& costs : costs_) sums = advance(sums, costs);
    std::vector<View> views(costs_.size());
    std::size_t view = to.index();
    for (std::size_t i = views.size(); i-- > 0;) {
      view = before_[i][view];
      views[i] = viewOf(view);
    }
    return views;
  }

 private:
  // `costs` are those of the views that the step leaves.
  std::vector<double> advance(const std::vector<double>& sums, const std::vector<double>& costs) {
    std::vector<double> next(kViews, std::numeric_limits<double>::infinity());
    std::vector<std::size_t>& before = before_.emplace_back(kViews, 0);
    for (std::size_t i = 0; i < kViews; ++i) {
      const View view = viewOf(i);
      const int lowest = std::max(0, view.tilt - kMostTilt);
      const int highest = std::min(Panorama::kTilts - 1, view.tilt + kMostTilt);
      for (int tilt = lowest; tilt <= highest; ++tilt)
        for (int turn = -kMostPan; turn <= kMostPan; ++turn) {
          const View last{(view.pan + turn + Panorama::kPans) % Panorama::kPans, tilt};
          const int rise = tilt - view.tilt;
          const double sum = sums[last.index()] + costs[last.index()] + turn * turn + rise * rise;
          if (sum < next[i]) next[i] = sum, before[i] = last.index();
        }
    }
    return next;
  }

  std::span<const std::vector<double>> costs_;
  std::vector<std::vector<std::size_t>> before_;  // by step and view
};

}  // namespace

std::vector<Vec3d> drawGaze(const std::vector<Panorama>& around, const Level& level, std::size_t aims,
                            std::uint64_t seed) {
  const Dullness dullness(around);
  std::vector<std::vector<double>> costs;
  for (const Panorama& p : around) costs.push_back(dullness.costs(p));
  const std::size_t step = around.size() / aims;
  std::vector<View> aim;
  for (std::size_t i = 0; i < aims; ++i)
    aim.push_back(drawAim(around[i * step], costs[i * step], hashKey(seed, i)));
  std::vector<Vec3d> gaze;
  for (std::size_t i = 0; i < aims; ++i)
    for (const View view :
         Turn(std::span(costs).subspan(i * step, step)).cheapest(aim[i], aim[(i + 1) % aims]))
      gaze.push_back(level.direction(Panorama::panOf(view.pan), Panorama::tiltOf(view.tilt)));
  return gaze;
}

}  // namespace saccade
