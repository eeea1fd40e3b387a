#include "eval/bench/reference.h"

#include <cmath>
#include <filesystem>

#include "base/content_hash.h"
#include "eval/bench/interrupt.h"
#include "eval/metrics/for_each_pixel.h"
#include "eval/metrics/plane_error.h"
#include "eval/pictures/exr.h"
#include "eval/pictures/text.h"
#include "render/primary/sub_pixel.h"
#include "scene/scene_hash.h"

namespace saccade::eval {
namespace {

// Reads the frame kept at `path`. Returns its paths per pixel, 0 without a usable one.
int readKept(const std::string& path, ReferenceFrame& frame) {
  if (!std::filesystem::exists(path)) return 0;
  try {
    const ExrPicture kept = readExr(path);
    const ImageF &a = kept.planes.at("a"), &b = kept.planes.at("b");
    const int spp = kept.attributes.at("spp");
    if (a.width() != frame.a.width() || a.height() != frame.a.height()) return 0;
    frame.a.copyFrom(a), frame.b.copyFrom(b);
    return spp;
  } catch (const std::exception&) {  // unreadable, or without a plane
    return 0;
  }
}

constexpr std::uint64_t kSeed = 0x5ecade;  // of seed 0, whose frames older caches hold

float fraction(float v) {
  return v - std::floor(v);
}

}  // namespace

ReferenceChange::ReferenceChange(const ReferenceFrame& prev, const ReferenceFrame& cur)
    : change(cur.a.width(), cur.a.height()),
      half_a(cur.a.width(), cur.a.height()),
      half_b(cur.a.width(), cur.a.height()),
      prev_a(cur.a.width(), cur.a.height()),
      prev_b(cur.a.width(), cur.a.height()) {
  prev_a.copyFrom(prev.a), prev_b.copyFrom(prev.b);
  // Of the mean of two halves.
  const auto variance = [](float a, float b) { return 0.25f * (a - b) * (a - b); };
  forEachPixel(half_a, [&](int x, int y) {
    const float a = half_a.at(x, y) = cur.a.at(x, y) - prev.a.at(x, y);
    const float b = half_b.at(x, y) = cur.b.at(x, y) - prev.b.at(x, y);
    change.dI.at(x, y) = 0.5f * (a + b);
    change.I_prev.at(x, y) = prev.mean(x, y);
    change.I_now.at(x, y) = cur.mean(x, y);
    change.var_dI.at(x, y) = variance(a, b);
    change.var_I_prev.at(x, y) = variance(prev.a.at(x, y), prev.b.at(x, y));
  });
}

double ReferenceChange::error() const {
  return relativeL1(half_a, half_b) / 2;
}

ReferenceRenderer::ReferenceRenderer(std::shared_ptr<const RenderScene> scene, RenderSettings settings,
                                     int width, int height, double fov_x_deg, std::string cache,
                                     TilePool& pool, std::uint64_t seed,
                                     const std::vector<Trajectory>& body_paths)
    : posed_(std::move(scene), body_paths),
      renderer_({settings.bounces, settings.channels}),
      pool_(pool),
      whole_pixel_(settings.jitter),
      width_(width),
      height_(height),
      fov_x_deg_(fov_x_deg),
      cache_(std::move(cache)),
      seed_(seed == 0 ? kSeed : hashKey(kSeed, seed)) {
  ContentHash h;
  h.add(posed_.still().digest()), h.add(settings.bounces), h.add(width), h.add(height), h.add(fov_x_deg);
  if (settings.jitter) h.add(settings.jitter);
  if (seed != 0) {
    h.add(seed);
    first_shift_ = {toUnit(hashKey(seed_, 1)), toUnit(hashKey(seed_, 2))};
  }
  key_ = h.value;
}

std::string ReferenceRenderer::cachePath(const Pose& pose, int spp) const {
  ContentHash h{key_};
  h.add(pose.position), h.add(pose.rotation), h.add(posed_.strengths().factors()), h.add(spp);
  if (posed_.bodies()) h.add(posed_.state());
  const std::string name = format("%016llx.exr", static_cast<unsigned long long>(h.value));
  return (std::filesystem::path(cache_) / name).string();
}

Camera ReferenceRenderer::cameraAt(const Pose& pose, std::uint32_t chunk) const {
  Camera camera(posed_.still().inScene(pose), pinhole(fov_x_deg_, width_, height_));
  if (whole_pixel_)
    camera.shift(0.5f - fraction(halton(chunk, 2) + first_shift_.x),
                 0.5f - fraction(halton(chunk, 3) + first_shift_.y));
  return camera;
}

ReferenceFrame ReferenceRenderer::frame(const Pose& pose, TimeNs time, int spp, Progress& progress) {
  posed_.setTime(time);
  const std::string path = cachePath(pose, spp);
  ReferenceFrame out(width_, height_);
  int done = readKept(path, out);
  progress.add(std::min(done, spp));
  const auto keep = [&] { writeExr(path, {{"a", &out.a}, {"b", &out.b}}, {{"spp", done}}); };
  Frame chunk(width_, height_);
  chunk.time = time;
  auto kept_at = std::chrono::steady_clock::now();
  while (done < spp) {
    // Every frame of every path shares the seeds.
    const Camera camera = cameraAt(pose, static_cast<std::uint32_t>(done / kChunk));
    SeedPlan seeds{hashKey(seed_, 0), hashKey(seed_, 1), kChunk / 2, kChunk / 2};
    seeds.before = done / 2, seeds.all = spp / 2;
    renderer_.render(PixelContext({posed_, camera}), seeds, pool_, chunk);
    done += kChunk;
    const float share = static_cast<float>(kChunk) / static_cast<float>(done);
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        out.a.at(x, y) += share * (chunk.samples.I1.at(x, y) - out.a.at(x, y));
        out.b.at(x, y) += share * (chunk.samples.I2.at(x, y) - out.b.at(x, y));
      }
    }
    progress.add(kChunk);
    const auto now = std::chrono::steady_clock::now();
    if (interrupted() || done >= spp || now - kept_at > std::chrono::seconds(10)) {
      keep();
      kept_at = now;
    }
    if (interrupted()) throw Interrupted{};
  }
  return out;
}

}  // namespace saccade::eval
