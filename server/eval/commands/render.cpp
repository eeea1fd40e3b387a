// `saccade-eval render` renders one picture.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>

#include "base/number_in.h"
#include "base/thread_time.h"
#include "eval/bench/arguments.h"
#include "eval/bench/lens_options.h"
#include "eval/bench/open_scene.h"
#include "eval/bench/progress.h"
#include "eval/commands/commands.h"
#include "eval/pictures/exr.h"
#include "render/renderer.h"
#include "saccade/wire/ranges.h"

namespace saccade::eval {
namespace {

struct RenderOptions {
  std::string scene, animation, size, output;
  std::vector<double> offset{0, 0, 0};
  LensOptions lens;
  int spp = 64;
  std::optional<int> bounces;  // none: those of the scene
  std::uint64_t seed = 0;
  bool grey = false;
};

// The pose moved by right, up, forward in scene units along the camera's axes.
Pose moved(const Pose& pose, const std::vector<double>& o) {
  return pose * Pose{{o[0], -o[1], o[2]}, {}};
}

int bouncesOf(const RenderOptions& o, const Scene& scene) {
  const int of_scene = scene.bounces.value_or(RenderSettings{}.bounces);
  return o.bounces.value_or(std::min(of_scene, ranges::kBounces.max));
}

void runRender(const RenderOptions& o) {
  checkOutputFile(o.output, {".exr", ".png"});
  const auto scene = openScene(o.scene, o.animation);
  const Scene& s = scene->description();
  const Size size = o.size.empty() ? Size{s.width, s.height} : parseSize(o.size);
  TilePool pool(hardwareThreads());
  Lens lens(withLens(pinhole(s.fov_x_deg, size.width, size.height), o.lens));
  lens.tabulate();
  const Camera camera(scene->inScene(moved(s.T_world_camera, o.offset)), lens);
  const PosedScene posed(scene);
  const int bounces = bouncesOf(o, s);
  Renderer renderer({bounces, 3});

  ImageF sum[3] = {{size.width, size.height}, {size.width, size.height}, {size.width, size.height}};
  ImageF part[3] = {{size.width, size.height}, {size.width, size.height}, {size.width, size.height}};
  Frame frame(size.width, size.height);
  Progress progress(o.scene, o.spp);
  const auto started = processCpuTime();
  constexpr int kChunk = 16;
  for (int done = 0; done < o.spp;) {
    const int n = std::min(kChunk, o.spp - done);
    SeedPlan seeds = SeedPlan::independent(o.seed, 0, n);
    seeds.before = done, seeds.all = o.spp;
    renderer.renderStill(PixelContext({posed, camera}), seeds, pool, frame, part);
    done += n;
    for (int c = 0; c < 3; ++c) {
      for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
          sum[c].at(x, y) +=
              (part[c].at(x, y) - sum[c].at(x, y)) * static_cast<float>(n) / static_cast<float>(done);
        }
      }
    }
    progress.add(n);
  }
  const double cpu_s = std::chrono::duration<double>(processCpuTime() - started).count();
  if (!o.grey) {
    writeExr(o.output, {{"R", &sum[0]}, {"G", &sum[1]}, {"B", &sum[2]}});
  } else {
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        part[0].at(x, y) = luminance({sum[0].at(x, y), sum[1].at(x, y), sum[2].at(x, y)});
      }
    }
    writeExr(o.output, {{"Y", &part[0]}});
  }
  std::printf("%s: %dx%d, %d spp, %d indirect bounces\n", o.output.c_str(), size.width, size.height, o.spp,
              bounces);
  std::printf("CPU time %.3g s, %.3g million paths per CPU second\n", cpu_s,
              1e-6 * size.width * size.height * o.spp / cpu_s);
}

}  // namespace

void addRenderCommand(CLI::App& app) {
  auto o = std::make_shared<RenderOptions>();
  auto* command =
      app.add_subcommand("render", "render one picture: linear 32-bit floats (.exr) or 8 bits (.png)");
  command->add_option("scene", o->scene, "a scene by name, or by the path of its file or folder")->required();
  addAnimationOption(*command, o->animation);
  command->add_option("--size", o->size, "WIDTHxHEIGHT, pixels; default: that of the scene");
  command->add_option("--spp", o->spp, "paths per pixel")->check(NumberIn(1, 1 << 20))->capture_default_str();
  command->add_option("--bounces", o->bounces, "indirect bounces; default: those of the scene file, else 3")
      ->check(NumberIn(ranges::kBounces.min, ranges::kBounces.max));
  command->add_option("--offset", o->offset, "move the camera: right,up,forward in scene units")
      ->delimiter(',')
      ->expected(3);
  addLensOptions(*command, o->lens);
  command->add_option("--seed", o->seed, "seed of the random numbers")
      ->check(wholeNumber())
      ->capture_default_str();
  command->add_flag("--grey", o->grey, "the luminance Y instead of colours");
  command->add_option("-o,--output", o->output, "picture to write, .exr or .png, in a folder that exists")
      ->required();
  command->callback([o] { runRender(*o); });
}

}  // namespace saccade::eval
