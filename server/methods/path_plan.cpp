#include "methods/path_plan.h"

#include <algorithm>
#include <atomic>

#include "base/hash_rng.h"

namespace saccade {
namespace {

constexpr float kMostOfPoint = 8, kMostForOthers = 4;  // times `asked`
constexpr float kLeastForOthers = 0.5f;
constexpr double kMostForNew = 8;     // times those of other points of kNone
constexpr double kShareForNew = 0.1;  // of `asked`, at most
constexpr double kOfPair = 2;         // paths: the one of the frame, and its partner in the frame before

// In [0, 1), spread evenly over any few neighbours in space and time. It is the R2 sequence (Roberts 2018) in
// x and y, moved on by the golden ratio in every frame.
float ditherAt(int x, int y, std::uint32_t frame) {
  const std::uint32_t bits = static_cast<std::uint32_t>(x) * 0xc13fa9a9u +
                             static_cast<std::uint32_t>(y) * 0x91e10da5u + frame * 0x9e3779b9u;
  return toUnit(bits);
}

// An error that is large takes paths by its square. Where light depends on the view the error stays, whatever
// the paths: it takes no more than those asked. A change is small beside its noise in few places, and there
// it takes many paths: by the cube of its error.
float wantedPaths(const PathPlan& plan, SurfaceKind kind, float error, float error_of_change) {
  const float r = error / plan.target, c = error_of_change / plan.target_of_change;
  const float of_light = plan.usual * r * std::max(1.f, r), of_change = plan.usual * c * c * c;
  const float most_of_light = kind == SurfaceKind::kDiffuse ? kMostOfPoint * plan.asked : plan.asked;
  return std::max(std::min(most_of_light, of_light), std::min(kMostOfPoint * plan.asked, of_change));
}

// The number of pairs of each of `others` points of kNone, once `planned` paths are those of all other
// points.
std::uint32_t pathsForOthers(const PathPlan& plan, const SurfaceSamples& on, std::uint64_t others,
                             std::uint64_t planned) {
  const double pixels = static_cast<double>(on.columns() / on.perPixel()) * on.height();
  const double left = plan.usual * pixels - static_cast<double>(planned);
  const double paths = std::clamp(left / (kOfPair * static_cast<double>(others)),
                                  double{kLeastForOthers * plan.asked}, double{kMostForOthers * plan.asked});
  return static_cast<std::uint32_t>(std::max(paths, 1.0));
}

// The number of paths of each of `newly` points of kNone, in pixels that showed none before.
std::uint32_t pathsForNew(const PathPlan& plan, const SurfaceSamples& on, std::uint32_t paths,
                          std::uint64_t newly) {
  const double most = kShareForNew * plan.asked * on.columns() / on.perPixel() * on.height();
  const double times = 1 + most / (paths * static_cast<double>(std::max<std::uint64_t>(newly, 1)));
  return static_cast<std::uint32_t>(paths * std::min(times, kMostForNew));
}

// Of points of a frame.
struct Counts {
  std::atomic<std::uint64_t> others, newly;  // of kNone; those in pixels that showed none before
  std::atomic<std::uint64_t> planned;        // paths of all other points
};

// Which pixels of the frame before showed points of kNone.
class ShownBefore {
 public:
  ShownBefore(std::vector<char>& of_pixels, const SurfaceSamples& on)
      : of_pixels_(of_pixels), per_pixel_(on.perPixel()), width_(on.columns() / on.perPixel()) {
    if (of_pixels_.empty()) of_pixels_.assign(static_cast<std::size_t>(width_) * on.height(), 1);
  }
  bool at(int column, int y) const { return of_pixels_[pixel(column / per_pixel_, y)] != 0; }
  void set(const SurfaceSamples& on, int y) {
    for (int x = 0; x < width_; ++x) of_pixels_[pixel(x, y)] = on.hasUncacheable(x, y);
  }

 private:
  std::size_t pixel(int x, int y) const { return static_cast<std::size_t>(y) * width_ + x; }

  std::vector<char>& of_pixels_;
  int per_pixel_, width_;
};

// The whole pixel is sampled, if another method is to estimate it.
std::uint32_t leastPaths(const SurfaceSamples& on, int column, int y) {
  return on.hasUncacheable() && on.hasUncacheable(column / on.perPixel(), y) ? 1 : 0;
}

// Gives `share` of what they want to the points of a row that are not of kNone, and counts all of them.
void planRow(const PathPlan& plan, const PathErrors& errors, std::uint32_t frame, float share, int y,
             const ShownBefore& before, SurfaceSamples& on, Counts& counts) {
  std::uint64_t others = 0, newly = 0, planned = 0;
  for (int column = 0; column < on.columns(); ++column) {
    SurfacePoint& p = on.at(column, y);
    if (p.isUncacheable()) {
      ++others, newly += !before.at(column, y);
      continue;
    }
    p.paths = 0;
    const float change = errors.change ? errors.change->at(column, y) : 0;
    if (const float e = errors.light.at(column, y); e > 0)
      p.paths = static_cast<std::uint32_t>(share * p.share * wantedPaths(plan, p.kind, e, change) +
                                           ditherAt(column, y, frame));
    p.paths = std::max(p.paths, leastPaths(on, column, y));
    planned += p.paths;
  }
  counts.others += others, counts.newly += newly, counts.planned += planned;
}

}  // namespace

std::chrono::nanoseconds planPaths(const PathPlan& plan, const PathErrors& errors, std::uint32_t frame,
                                   const PoolHandle& pool, std::vector<char>& had_others,
                                   SurfaceSamples& on) {
  ShownBefore before(had_others, on);
  Counts counts;
  const auto planShare = [&](float share) {
    counts.others = counts.newly = counts.planned = 0;
    return pool.forEachRow(on.height(),
                           [&](int y) { planRow(plan, errors, frame, share, y, before, on, counts); });
  };
  auto time = planShare(1);
  const float most = plan.most * static_cast<float>(on.columns() / on.perPixel() * on.height());
  if (const auto all = static_cast<float>(counts.planned); all > most) time += planShare(most / all);
  if (counts.others == 0) return std::ranges::fill(had_others, 0), time;
  const std::uint32_t paths = pathsForOthers(plan, on, counts.others, counts.planned);
  const std::uint32_t for_new = pathsForNew(plan, on, paths, counts.newly);
  return time + pool.forEachRow(on.height(), [&](int y) {
    for (int column = 0; column < on.columns(); ++column)
      if (SurfacePoint& p = on.at(column, y); p.isUncacheable())
        p.paths = before.at(column, y) ? paths : for_new;
    before.set(on, y);
  });
}

}  // namespace saccade
