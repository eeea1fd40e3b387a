// EventSVGF does what the paper says: error of dI after 21 frames against a correlated reference of many
// paths, beside path tracing and beside itself with one part switched off (Fig. 9).
//
// Quick by default: 96x96 and 1024 paths, the same motion in space. SACCADE_FULL=1 takes
// 256x256 and 4096 paths; its references are kept in $SACCADE_CACHE (default: ~/.cache/saccade).
#include <gtest/gtest.h>

#include <fstream>
#include <memory>

#include "app/feed.h"
#include "eval/metrics.h"
#include "eval/open_scene.h"
#include "eval/reference.h"
#include "scene/mitsuba_xml.h"
#include "statistical/outside_files.h"

namespace saccade {
namespace {

constexpr int kFrame = 21;
const bool kFull = std::getenv("SACCADE_FULL") != nullptr;
const int kSize = kFull ? 256 : 96, kReferenceSpp = kFull ? 4096 : 1024;
const double kRate = 500;

std::string cacheFolder() {
  if (const char* cache = std::getenv("SACCADE_CACHE")) return cache;
  const char* home = std::getenv("HOME");
  return kFull && home ? std::string(home) + "/.cache/saccade" : ::testing::TempDir() + "saccade-cache";
}

class Bench {
 public:
  Bench(std::string name, std::shared_ptr<const RenderScene> scene)
      : name_(std::move(name)), scene_(std::move(scene)), path_(openTrajectory(name_, "right", *scene_)) {
    ReferenceRenderer renderer(scene_, 3, kSize, kSize, scene_->description().fov_x_deg, cacheFolder(),
                               pool_);
    Progress progress("reference of " + name_, 2.0 * kReferenceSpp);
    const auto at = [&](int t) {
      return renderer.frame(path_.at(frameTime(t, kRate)), kReferenceSpp, progress);
    };
    truth_ = std::make_unique<ReferenceChange>(at(kFrame - 1), at(kFrame));
    std::printf("%s, %dx%d, right, frame %d; reference of %d spp, own error %.4f\n", name_.c_str(), kSize,
                kSize, kFrame, kReferenceSpp, truth_->error());
  }

  // Relative L1 of dI.
  double error(const std::string& method, int spp, const ParamValues& given = {}) {
    FeedConfig c;
    c.width = c.height = kSize, c.fov_x_deg = scene_->description().fov_x_deg, c.frame_rate_hz = kRate;
    c.method = method, c.spp = spp, c.seed = 1;
    std::string bad;
    EXPECT_EQ(resolveParams(*findMethod(method), given, c.params, bad), "");
    Feed feed(scene_, path_, c, pool_);
    for (int t = 1; t <= kFrame; ++t) feed.step();
    const double e = relativeL1(feed.change().dI, truth_->dI);
    std::printf("  %-14s %d spp %-24s %.4f\n", method.c_str(), spp,
                given.empty() ? "" : given.begin()->first.c_str(), e);
    return e;
  }

 private:
  std::string name_;
  TilePool pool_{2};
  std::shared_ptr<const RenderScene> scene_;
  Trajectory path_;
  std::unique_ptr<ReferenceChange> truth_;
};

void expectThePapersOrder(Bench& bench) {
  const double full = bench.error("event_svgf", 2);
  const double correlated = bench.error("pt-correlated", 4), independent = bench.error("pt", 4);
  // Coarse pixels see less of the surfaces that the filter could average, and their reference is noisier.
  EXPECT_LE(full, (kFull ? 0.30 : 0.45) * correlated);
  EXPECT_GE(independent, 5 * correlated);
  for (const char* part : {"correlated", "w_prev", "accumulate_difference", "correction"}) {
    EXPECT_GT(bench.error("event_svgf", 2, {{part, 0}}), full) << "without " << part;
  }
}

const char* kBunny = "/usr/share/glmark2/models/bunny.obj";  // Debian's glmark2-data

TEST(DifferenceQuality, CornellBunny) {
  SACCADE_NEEDS(kBunny);
  Bench bench("cornell-bunny", openScene("cornell-bunny"));
  expectThePapersOrder(bench);
}

TEST(DifferenceQuality, BunnyInSomebodyElsesCornellBox) {
  SACCADE_NEEDS(kBunny);
  const std::string box = test::realScene("cornell-box/scene.xml");
  SACCADE_NEEDS(box);
  std::ifstream file(box);
  std::string xml((std::istreambuf_iterator<char>(file)), {});
  xml.replace(xml.rfind("</scene>"), 8,
              std::string("<shape type=\"obj\"><string name=\"filename\" value=\"") + kBunny +
                  "\"/><transform name=\"to_world\"><scale value=\"0.42\"/><translate x=\"-0.45\" "
                  "y=\"0.416\" z=\"0.5\"/>"
                  "</transform><ref id=\"FloorBSDF\"/></shape></scene>");
  const std::string path = ::testing::TempDir() + "bunny_in_box.xml";
  std::ofstream(path) << xml;
  Bench bench("bunny in the box", std::make_shared<RenderScene>(loadMitsubaXml(path)));
  expectThePapersOrder(bench);
}

TEST(DifferenceQuality, DemodulationKeepsTexture) {
  Bench bench("textured-cornell-box", openScene("textured-cornell-box"));
  const double full = bench.error("event_svgf", 2);
  EXPECT_GT(bench.error("event_svgf", 2, {{"demodulate", 0}}), full);
}

}  // namespace
}  // namespace saccade
