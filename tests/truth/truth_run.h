// Runs truth channels on a feed of a small scene.
#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <numbers>

#include "feed/feed.h"
#include "methods/method_spec.h"
#include "truth/truth_source.h"

namespace saccade::test {

inline constexpr double kFrameRate = 100;
inline constexpr TimeNs kFrameTime{10'000'000};

// A picture, or a row, of a channel.
struct Planes {
  int width = 1, height = 1;
  std::vector<float> values;

  float at(int plane, int x, int y) const {
    return values.at((static_cast<std::size_t>(plane) * height + y) * width + x);
  }
};

template <class T>
std::vector<T> elementsOf(const TruthSample& sample) {
  std::vector<T> values(sample.elements.size() / sizeof(T));
  std::memcpy(values.data(), sample.elements.data(), values.size() * sizeof(T));
  return values;
}

// A feed at kFrameRate that traces one path per pixel.
class TruthRun {
 public:
  // `bodies`: the paths of the bodies of the scene.
  TruthRun(Scene scene, Trajectory path, int width, int height, double fov_x_deg,
           const std::vector<Trajectory>& bodies = {})
      : width_(width),
        height_(height),
        feed_(std::make_shared<RenderScene>(std::move(scene)), std::move(path),
              config(width, height, fov_x_deg, bodies), pool_) {}

  FeedInterval step() {
    feed_.step(pool_);
    return feed_.interval();
  }
  std::unique_ptr<TruthSource> source(const std::string& name) const {
    return findTruth(name)->make(
        {.name = name, .frames = FrameSelection(), .width = width_, .height = height_});
  }
  Planes planesOf(const TruthSample& sample) const { return {width_, height_, elementsOf<float>(sample)}; }
  // The channel's picture of frame 0, or that which the first interval completes.
  Planes first(const std::string& name) {
    return planesOf(source(name)->sample(feed_.change().frame > 0 ? feed_.interval() : step()).front());
  }

 private:
  static FeedConfig config(int width, int height, double fov_x_deg, const std::vector<Trajectory>& bodies) {
    FeedConfig c;
    c.body_paths = bodies;
    c.camera = pinhole(fov_x_deg, width, height), c.frame_rate_hz = kFrameRate;
    c.method = "pt-correlated", c.spp = 2, c.bounces = 0;
    std::string name;
    EXPECT_EQ(resolveParams(*findMethod(c.method), {}, c.params, name), "");
    return c;
  }

  int width_, height_;
  TilePool pool_{2};
  Feed feed_;
};

// Rays of a pinhole camera in closed form: 1 along the viewing axis, in its own axes.
struct Pinhole {
  int width, height;
  double fov_x_deg;

  double focal() const { return width / (2 * std::tan(fov_x_deg * std::numbers::pi / 360)); }
  Vec3d direction(double x, double y) const {
    return {(x - (width - 1) / 2.0) / focal(), (y - (height - 1) / 2.0) / focal(), 1};
  }
  double columnOf(Vec3d d) const { return d.x / d.z * focal() + (width - 1) / 2.0; }
  double rowOf(Vec3d d) const { return d.y / d.z * focal() + (height - 1) / 2.0; }
};

}  // namespace saccade::test
