#include "feed/refined_tile.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>

#include "base/log_ratio.h"
#include "base/scratch.h"
#include "filter/demodulation.h"

namespace saccade {
namespace {

constexpr int kBlock = 4;  // edge of the blocks of pixels whose rays follow each other

// A part of the interval of one pixel, between two moments of known log brightness.
struct Piece {
  std::uint8_t x, y;          // within the tile
  std::uint8_t middle, half;  // moments; half: from the middle to either end
  float from, to;
  float off;  // how far the middle of the piece that this is half of is off its line; 0: this is a whole one
  RaysAround rays = {};  // at both moments
  bool sharp = false;    // see RefinedInterval

  float line() const { return 0.5f * (from + to); }
};

// The updates of a tile, in their order.
class UpdateGrid {
 public:
  void clear(int moments) {
    for (int m = 0; m < moments; ++m) set_[m] = {};
  }
  void set(const Piece& at, float I) {
    set_[at.middle][at.y] |= 1u << at.x;
    I_[at.middle][at.y][at.x] = I;
  }
  // f(moment, x, y, I), by moment, then by row.
  void forEach(int moments, const auto& f) const {
    for (int m = 0; m < moments; ++m)
      for (int y = 0; y < kRefinedTile; ++y)
        for (std::uint32_t row = set_[m][y]; row != 0; row &= row - 1) {
          const int x = std::countr_zero(row);
          f(m, x, y, I_[m][y][x]);
        }
  }

 private:
  std::array<TileMask, RefinedInterval::kMostPieces> set_;
  float I_[RefinedInterval::kMostPieces][kRefinedTile][kRefinedTile];
};

// Looks up the brightness in the middle of pieces.
class PieceSampler {
 public:
  static constexpr std::size_t kMost = PointSampler::kMost;

  // Sets I() and rays() of at most kMost pieces, all of one scene. Returns how many rays it has traced.
  std::size_t look(const RefinedInterval& interval, Tile tile, std::span<const Piece> pieces,
                   KnownRays& known) {
    const std::size_t count = pieces.size();
    for (std::size_t k = 0; k < count; ++k) {
      asked_[k] = {static_cast<std::uint16_t>(tile.x0 + pieces[k].x),
                   static_cast<std::uint16_t>(tile.y0 + pieces[k].y), pieces[k].middle};
      rays_[k] = pieces[k].rays;
    }
    const auto asked = std::span(asked_).first(count);
    const PosedScene& scene = *interval.scenes[interval.scenes.size() == 1 ? 0 : pieces[0].middle];
    const PointView view{scene, interval.cameras, interval.motion};
    const auto samples = std::span(samples_).first(count);
    const auto light = std::span(light_).first(count);
    sampler_.look(view, asked, samples);
    interval.light.readPoints(samples, light);
    const LookedAt at{asked, samples, std::span(rays_).first(count)};
    return sampler_.traceShadows(view, at, interval.shadows, known, light);
  }
  const RaysAround& rays(std::size_t k) const { return rays_[k]; }
  // NaN where no look-up tells it.
  float I(std::size_t k) const {
    const PointSample& s = samples_[k];
    const PlaceLight& light = light_[k];
    if (s.albedo <= 0) return s.emission;
    if (!light.known) return std::nanf("");
    const float i = light.residual + s.place.unoccluded * light.visibility;
    return std::max(0.f, modulationAlbedo(s.albedo, Demodulation::kAlbedo) * i + s.emission);
  }

 private:
  std::array<PixelMoment, kMost> asked_;
  std::array<PointSample, kMost> samples_;
  std::array<PlaceLight, kMost> light_;
  std::array<RaysAround, kMost> rays_;
  PointSampler sampler_;
};

// The pixels of a mask, block by block, each with the whole interval.
void listPieces(const RefinedInterval& interval, Tile tile, const TileMask& mask, std::vector<Piece>& out) {
  const auto half = static_cast<std::uint8_t>((1 << interval.levels) / 2);
  for (int y0 = 0; y0 < kRefinedTile; y0 += kBlock)
    for (int x0 = 0; x0 < kRefinedTile; x0 += kBlock)
      for (int y = y0; y < y0 + kBlock; ++y)
        for (std::uint32_t row = mask[y] >> x0 & 0xfu; row != 0; row &= row - 1) {
          const int x = x0 + std::countr_zero(row);
          out.push_back({static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), half, half,
                         interval.L0.at(tile.x0 + x, tile.y0 + y), interval.L1.at(tile.x0 + x, tile.y0 + y),
                         0});
        }
}

// Sorts pieces by their moments; those of one moment keep their order.
void sortByMoment(const std::vector<Piece>& pieces, std::vector<Piece>& sorted) {
  std::array<std::size_t, RefinedInterval::kMostPieces + 1> first{};
  for (const Piece& piece : pieces) ++first[piece.middle + 1u];
  for (std::size_t m = 1; m < first.size(); ++m) first[m] += first[m - 1];
  sorted.resize(pieces.size());
  for (const Piece& piece : pieces) sorted[first[piece.middle]++] = piece;
}

// f(pieces) for a few that follow each other, all of one scene.
void forEachChunk(std::span<const Piece> pieces, bool of_one_moment, const auto& f) {
  while (!pieces.empty()) {
    std::size_t count = std::min(pieces.size(), PieceSampler::kMost);
    if (of_one_moment)
      for (std::size_t k = 1; k < count; ++k)
        if (pieces[k].middle != pieces[0].middle) count = k;
    f(pieces.first(count));
    pieces = pieces.subspan(count);
  }
}

struct Memory {
  TileRanges ranges;
  std::vector<Piece> level, next;
  std::vector<float> off;
  UpdateGrid grid;
  PieceSampler sampler;
  KnownRays known;
  std::size_t rays;  // traced
};

// Looks up all pieces of `level`. Sets `next` to the halves of those whose middle is off the line.
void splitLevel(const RefinedInterval& interval, Tile tile, Memory& m) {
  const bool moves = interval.scenes.size() > 1;
  if (moves) sortByMoment(m.level, m.next), std::swap(m.level, m.next);
  m.next.clear();
  forEachChunk(m.level, moves, [&](std::span<const Piece> pieces) {
    m.rays += m.sampler.look(interval, tile, pieces, m.known);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const float I = m.sampler.I(k);
      if (!std::isfinite(I)) continue;
      const Piece& whole = pieces[k];
      m.grid.set(whole, I);
      const float L = logBrightness(I, interval.bias);
      const float off = std::abs(L - whole.line());
      if (off < interval.enough && !whole.sharp) continue;
      const auto half = static_cast<std::uint8_t>(whole.half / 2);
      const auto first = static_cast<std::uint8_t>(whole.middle - half);
      const auto second = static_cast<std::uint8_t>(whole.middle + half);
      const RaysAround rays = interval.every_ray ? RaysAround{} : m.sampler.rays(k);
      m.next.push_back({whole.x, whole.y, first, half, whole.from, L, off, {rays.before, rays.own}});
      m.next.push_back({whole.x, whole.y, second, half, L, whole.to, off, {rays.own, rays.after}});
    }
  });
}

// Keeps at most `room` pieces of m.level: those whose lines were furthest off, in their order.
void keepFurthest(std::size_t room, Memory& m) {
  m.off.clear();
  for (const Piece& piece : m.level) m.off.push_back(piece.off);
  const auto cut = m.off.begin() + static_cast<std::ptrdiff_t>(room);
  std::nth_element(m.off.begin(), cut, m.off.end(), std::greater<>());
  std::erase_if(m.level, [least = *cut](const Piece& piece) { return piece.off <= least; });
}

}  // namespace

void RefinedTile::refine(const RefinedInterval& interval, Tile tile, int levels, int reach) {
  updates_.clear(), samples_ = unsplit_ = rays_ = 0;
  const Scratch<Memory> memory;
  Memory& m = *memory;
  m.level.clear();
  m.ranges.find(interval.L0, interval.L1, tile, reach);
  listPieces(interval, tile, m.ranges.above(interval.contrast), m.level);
  if (m.level.empty()) return;
  const TileMask sharp = m.ranges.above(interval.sharp);
  for (Piece& piece : m.level) piece.sharp = sharp[piece.y] >> piece.x & 1u;
  m.known.clear(), m.rays = 0;
  const int moments = 1 << interval.levels;
  m.grid.clear(moments);
  const auto most =
      static_cast<std::size_t>(interval.most_updates * (tile.x1 - tile.x0) * (tile.y1 - tile.y0));
  for (int level = 0; level < levels && !m.level.empty(); ++level, std::swap(m.level, m.next)) {
    if (const std::size_t asked = m.level.size(), room = most - samples_; asked > room) {
      keepFurthest(room, m);
      unsplit_ += (asked - m.level.size()) / 2;
    }
    samples_ += m.level.size();
    splitLevel(interval, tile, m);
  }
  rays_ = m.rays;
  const int width = interval.L0.width();
  m.grid.forEach(moments, [&](int moment, int x, int y, float I) {
    updates_.push_back({static_cast<std::uint32_t>((tile.y0 + y) * width + tile.x0 + x),
                        static_cast<float>(moment) / static_cast<float>(moments), I});
  });
}

}  // namespace saccade
