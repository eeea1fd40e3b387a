#include "feed/refinement.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/log_ratio.h"

namespace saccade {
namespace {

// Of the least threshold. A pixel can have changed where the range around it exceeds kRange of it. A middle
// that is off the line by less than kOffLine of it ends the search, unless the range exceeds kSharp. The
// latter looks up 3 % more in rooms, and misses half as many events under a tree in the sun.
constexpr double kRange = 1, kOffLine = 0.025, kSharp = 8;
// Pixels beyond the motion that count: 1 looks up 7 % more, with 2 % less error.
constexpr float kBeside = 0.5f;
constexpr float kMostMotion = kMostReach - kBeside;

}  // namespace

std::string refinementFault(const FeedConfig& config) {
  if (!findMethod(config.method)->refines)
    return config.method + " has whole frames only: it knows no light between them";
  if (config.jitter) return "jitter has whole frames only";
  return "";
}

Refinement::Refinement(const FeedConfig& config, std::shared_ptr<const RenderScene> scene)
    : settings_(*config.refinement),
      spp_(config.spp),
      width_(config.camera.width),
      height_(config.camera.height),
      across_((width_ + kTileEdge - 1) / kTileEdge),
      down_((height_ + kTileEdge - 1) / kTileEdge),
      motion_px_(static_cast<std::size_t>(across_ * down_)),
      L0_(width_, height_),
      L1_(width_, height_),
      tiles_(motion_px_.size()),
      joined_(motion_px_.size()) {
  SACCADE_CHECK(refinementFault(config).empty());
  if (config.body_paths.empty()) return;
  for (int k = 0; k < RefinedInterval::kMostPieces; ++k) posed_.emplace_back(scene, config.body_paths);
}

void Refinement::steer(const FeedKeys& keys) {
  for (PosedScene& posed : posed_)
    for (const BodyKey& body : keys.bodies) posed.append(body.body, body.key);
}

std::chrono::nanoseconds Refinement::refine(const Interval& interval, const PoolHandle& pool,
                                            IntensityChange& change) {
  auto time = measureMotion(interval.frames, pool);
  const float fastest =
      std::min(kMostMotion, std::max(*std::ranges::max_element(motion_px_), interval.reach_px));
  // Shadows of bodies move over surfaces that stand.
  if (interval.motion.moved.any()) std::ranges::fill(motion_px_, fastest);
  const int levels = levelsFor(fastest);
  change.updates.clear(), counts_ = {};
  if (levels == 0) return time;
  time += findBrightness(change, pool);
  setMoments(interval, levels, change);
  const EndShadows shadows{*interval.frames.cur.surfaces, *interval.frames.prev.surfaces, interval.rays,
                           spp_};
  const RefinedInterval refined{.levels = levels,
                                .cameras = cameras_,
                                .scenes = scenes_,
                                .motion = interval.scene.bodies() ? &interval.motion : nullptr,
                                .L0 = L0_,
                                .L1 = L1_,
                                .light = interval.light,
                                .shadows = shadows,
                                .bias = static_cast<float>(settings_.bias),
                                .contrast = static_cast<float>(kRange * settings_.threshold),
                                .sharp = static_cast<float>(kSharp * settings_.threshold),
                                .enough = static_cast<float>(kOffLine * settings_.threshold),
                                .most_updates = settings_.most_updates,
                                .every_ray = settings_.every_ray};
  time += pool.run(across_ * down_, [&](int i) {
    const int x = i % across_ * kTileEdge, y = i / across_ * kTileEdge;
    const Tile tile{x, y, std::min(x + kTileEdge, width_), std::min(y + kTileEdge, height_)};
    const float motion = motionAround(i);
    tiles_[static_cast<std::size_t>(i)].refine(refined, tile, levelsFor(motion),
                                               static_cast<int>(std::ceil(motion + kBeside)));
  });
  return time + pool.run(1, [&](int) { join(change); });
}

std::chrono::nanoseconds Refinement::measureMotion(const FramePair& frames, const PoolHandle& pool) {
  const GBuffer& g = frames.cur.g;
  return pool.run(down_, [&](int j) {
    for (int i = 0; i < across_; ++i) {
      float most2 = 0;
      for (int y = j * kTileEdge; y < std::min((j + 1) * kTileEdge, height_); ++y)
        for (int x = i * kTileEdge; x < std::min((i + 1) * kTileEdge, width_); ++x) {
          const float mx = g.motion_x.at(x, y), my = g.motion_y.at(x, y);
          most2 = std::max(most2, mx * mx + my * my);
        }
      motion_px_[static_cast<std::size_t>(j * across_ + i)] = std::min(kMostMotion, std::sqrt(most2));
    }
  });
}

std::chrono::nanoseconds Refinement::findBrightness(const IntensityChange& change, const PoolHandle& pool) {
  const auto bias = static_cast<float>(settings_.bias);
  return pool.forEachRow(height_, [&](int y) {
    const float *I_prev = change.I_prev.row(y), *dI = change.dI.row(y);
    float *L0 = L0_.row(y), *L1 = L1_.row(y);
    for (int x = 0; x < width_; ++x) {
      L0[x] = logBrightness(I_prev[x], bias);
      L1[x] = logBrightness(I_prev[x] + dI[x], bias);
    }
  });
}

// Of a tile and its neighbours, whose surfaces may come into it.
float Refinement::motionAround(int tile) const {
  const int x = tile % across_, y = tile / across_;
  float most = 0;
  for (int j = std::max(0, y - 1); j <= std::min(down_ - 1, y + 1); ++j)
    for (int i = std::max(0, x - 1); i <= std::min(across_ - 1, x + 1); ++i)
      most = std::max(most, motion_px_[static_cast<std::size_t>(j * across_ + i)]);
  return most;
}

// So that 2^levels pieces have about the finest motion each.
int Refinement::levelsFor(float motion_px) const {
  const double pieces = motion_px / settings_.finest_px;
  if (pieces < 1) return 0;
  return std::min(RefinedInterval::kMostLevels, static_cast<int>(std::lround(std::log2(pieces))));
}

void Refinement::setMoments(const Interval& interval, int levels, const IntensityChange& change) {
  const int pieces = 1 << levels;
  cameras_.clear(), scenes_.clear();
  for (int k = 0; k < pieces; ++k) {
    const TimeNs time = change.t0 + (change.t1 - change.t0) * k / pieces;
    cameras_.push_back(interval.cameraAt(time));
    if (posed_.empty()) continue;
    posed_[static_cast<std::size_t>(k)].setTime(time);
    scenes_.push_back(&posed_[static_cast<std::size_t>(k)]);
  }
  if (posed_.empty()) scenes_.push_back(&interval.scene);
}

// The updates of all tiles, by time and then by pixel, as those of each tile are.
void Refinement::join(IntensityChange& change) {
  for (const RefinedTile& tile : tiles_) {
    counts_.samples += tile.samples(), counts_.unsplit += tile.unsplit();
    counts_.rays += tile.rays();
  }
  std::ranges::fill(joined_, 0);
  const auto pieces = static_cast<float>(cameras_.size());
  for (std::size_t moment = 1; moment < cameras_.size(); ++moment) {
    const float at = static_cast<float>(moment) / pieces;
    for (int y = 0; y < height_; ++y) {
      const auto end = static_cast<std::uint32_t>((y + 1) * width_);
      for (int i = y / kTileEdge * across_; i < (y / kTileEdge + 1) * across_; ++i) {
        const auto& updates = tiles_[static_cast<std::size_t>(i)].updates();
        std::size_t& next = joined_[static_cast<std::size_t>(i)];
        for (; next < updates.size() && updates[next].at == at && updates[next].pixel < end; ++next)
          change.updates.push_back(updates[next]);
      }
    }
  }
}

}  // namespace saccade
