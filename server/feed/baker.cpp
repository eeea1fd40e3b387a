#include "feed/baker.h"

#include <algorithm>
#include <limits>

#include "cache/grid/grid_bytes.h"
#include "render/primary/sub_pixel.h"

namespace saccade {
namespace {

constexpr int kSpp = 8;                            // of a pixel in each pass, until its light is known
constexpr int kLeastPasses = 4, kMostPasses = 64;  // the first ones give a path to each pixel
constexpr double kEnough = 0.99;                   // of the pixels of a pass
constexpr std::uint64_t kSeed = 0xba4e;
constexpr std::size_t kMiB = 1 << 20;

// Finest cells of half the size of a feed's, or of the same. It never drops vertices.
GridParams gridOf(bool larger_cells) {
  return {.cell_px = GridParams{}.cell_px * (larger_cells ? 1.f : 0.5f),
          .max_vertices = std::numeric_limits<std::size_t>::max()};
}

// Vertices of surfaces that no pass has seen yet may take half of the memory. The rest is for what the gaps
// between the pixels show.
constexpr std::size_t kFirstPassShare = 2;

}  // namespace

Baker::Baker(std::shared_ptr<const RenderScene> scene, BakePlan plan)
    : posed_(std::move(scene)),
      plan_(std::move(plan)),
      lens_(plan_.camera),
      renderer_({plan_.bounces, plan_.channels}),
      pass_{.poses = plan_.poses.size()},
      max_vertices_(static_cast<std::size_t>(plan_.memory) * kMiB / SurfaceGrid::kBytesPerVertex),
      grid_(gridOf(pass_.larger_cells)),
      bounces_(BounceGrid::cellsBeside(static_cast<std::size_t>(plan_.memory) * kMiB)),
      frame_(plan_.camera.width, plan_.camera.height, 1),
      estimate_(plan_.camera.width, plan_.camera.height),
      uncertainty_(plan_.camera.width, plan_.camera.height) {
  lens_.tabulate();
}

bool Baker::isDone() const {
  return passes() >= kMostPasses || (passes() >= kLeastPasses && known() >= kEnough);
}

double Baker::share() const {
  return isDone() ? 1 : std::max(static_cast<double>(passes()) / kMostPasses, pass_.done);
}

void Baker::pass(const PoolHandle& pool) {
  pixels_ = below_ = progress_ = 0;
  for (std::size_t pose = 0; pose < pass_.poses; ++pose) {
    const auto next = look(pose, pool);
    if (!next) {
      if (useLargerCells()) return pass(pool);
      break;
    }
    const SeedPlan seeds = SeedPlan::independent(hashKey(kSeed, pass_.count), pose, 0);
    const Camera camera = cameraAt(pose);
    renderer_.renderPaths({posed_, camera}, seeds, *next, &bounces_, pool);
    const SurfaceGrid::Added added = grid_.add({*frame_.surfaces, frame_.g, at_}, pool);
    grid_.learn(grid_.readAdded(added, pool, estimate_), pool);
    bounces_.add(*frame_.surfaces);
  }
  ++pass_.count;
  if (pixels_ > 0)
    pass_.known = below_ / pixels_, pass_.done = std::max(pass_.done, progress_ / pixels_);
  else if (!isFull())
    pass_.known = pass_.done = 1;  // there is nothing to see
}

// Every pass shifts the pixels, so that all vertices between them are reached. Once memory is full, passes
// repeat the shifts whose vertices are there.
Camera Baker::cameraAt(std::size_t pose) const {
  Camera camera(posed_.still().inScene(plan_.poses[pose]), lens_);
  const auto i = static_cast<std::uint32_t>(isFull() ? pass_.count % pass_.shifts : pass_.count);
  camera.shift(0.5f - halton(i + 1, 2), 0.5f - halton(i + 1, 3));
  return camera;
}

bool Baker::useLargerCells() {
  if (passes() > 0 || pass_.larger_cells) return false;
  pass_.larger_cells = 1, pass_.poses = plan_.poses.size();
  grid_ = SurfaceGrid(gridOf(pass_.larger_cells));
  return true;
}

std::optional<SurfaceFrame> Baker::look(std::size_t pose, const PoolHandle& pool) {
  const Camera camera = cameraAt(pose);
  const SurfaceFrame next = renderer_.renderSurfaces(PixelContext({posed_, camera}), pool, frame_);
  const SurfaceSamples& on = *frame_.surfaces;
  grid_.place(on, &next.obstacles, pool, none_, at_);
  if (passes() == 0 && pose > 0 && vertices() > max_vertices_ / kFirstPassShare) {
    pass_.poses = pose;
    return {};
  }
  if (passes() > 0 && !isFull() && vertices() > max_vertices_) {
    pass_.shifts = pass_.count;
    return {};
  }
  grid_.uncertainty({on, frame_.g, at_}, pool, uncertainty_);
  planPaths();
  return next;
}

void Baker::planPaths() {
  SurfaceSamples& on = *frame_.surfaces;
  for (int y = 0; y < frame_.height(); ++y) {
    for (int x = 0; x < frame_.width(); ++x) {
      const float u = uncertainty_.at(x, y);
      SurfacePoint& point = on.at(x, y);
      if (point.kind == SurfaceKind::kNone) continue;
      point.paths = u > plan_.error ? kSpp : passes() < kLeastPasses ? 1 : 0;
      const float share = plan_.error / std::max(u, plan_.error);
      pixels_ += 1, below_ += u <= plan_.error, progress_ += share * share;
    }
  }
}

std::string Baker::state() const {
  ByteWriter out;
  out.add(pass_), writeLevels(grid_.levels(), out), writeBounces(bounces_, out);
  return out.take();
}

void Baker::restore(std::string_view state) {
  ByteReader in(state);
  pass_ = in.get<Passes>();
  if (pass_.poses > plan_.poses.size()) throw std::runtime_error("it has more poses than its plan");
  grid_ = SurfaceGrid(gridOf(pass_.larger_cells));
  grid_.levels() = readLevels(in);
  readBounces(in, bounces_);
}

std::shared_ptr<const BakedLight> Baker::light(const PoolHandle& pool) const {
  return std::make_shared<const BakedLight>(grid_.levels(), gridOf(pass_.larger_cells), pool);
}

}  // namespace saccade
