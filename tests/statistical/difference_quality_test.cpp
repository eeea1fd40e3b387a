// EventSVGF does what the paper says. The error of dI after 21 frames is taken against a correlated
// reference of many paths. It stands beside that of path tracing and of EventSVGF with one part off (Figure
// 9).
//
// Quick by default: 96x96 and 1024 paths, the same motion in space. SACCADE_FULL=1 takes
// 256x256 and 4096 paths; its references are kept in $SACCADE_CACHE (default: ~/.cache/saccade).
#include <gtest/gtest.h>

#include <fstream>

#include "eval/bench/bench.h"
#include "eval/metrics/plane_error.h"
#include "statistical/outside_files.h"

namespace saccade::eval {
namespace {

constexpr int kFrame = 21;
const bool kFull = std::getenv("SACCADE_FULL") != nullptr;
const int kSize = kFull ? 256 : 96, kReferenceSpp = kFull ? 4096 : 1024;

std::string cacheFolder() {
  if (const char* cache = std::getenv("SACCADE_CACHE")) return cache;
  const char* home = std::getenv("HOME");
  return kFull && home ? std::string(home) + "/.cache/saccade" : ::testing::TempDir() + "saccade-cache";
}

class Errors {
 public:
  explicit Errors(const std::string& scene)
      : bench_({.scene = scene,
                .width = kSize,
                .height = kSize,
                .frame_rate_hz = 500,
                .first = kFrame,
                .last = kFrame,
                .reference_spp = kReferenceSpp,
                .cache = cacheFolder()},
               pool_) {
    std::printf("%s, %dx%d, right, frame %d; reference of %d spp, own error %.4f\n", scene.c_str(), kSize,
                kSize, kFrame, kReferenceSpp, bench_.referenceError());
  }

  // Relative L1 of dI.
  double of(const std::string& method, int spp, const ParamValues& given = {}) {
    std::string spec = method;
    for (const auto& [name, value] : given) spec += ":" + name + "=" + std::to_string(value);
    const double e =
        relativeL1(bench_.run(parseMethod(spec), spp, 1).changes.back().dI, bench_.truth().back().change.dI);
    std::printf("  %-14s %d spp %-24s %.4f\n", method.c_str(), spp,
                given.empty() ? "" : given.begin()->first.c_str(), e);
    return e;
  }

 private:
  TilePool pool_{2};
  Bench bench_;
};

void expectThePapersOrder(Errors& errors) {
  const double full = errors.of("event_svgf", 2);
  const double correlated = errors.of("pt-correlated", 4), independent = errors.of("pt", 4);
  // Coarse pixels see less of the surfaces that the filter could average, and their reference is noisier.
  EXPECT_LE(full, (kFull ? 0.30 : 0.45) * correlated);
  EXPECT_GE(independent, 4 * correlated);
  for (const char* part : {"correlated", "w_prev", "accumulate_difference", "correction"}) {
    EXPECT_GT(errors.of("event_svgf", 2, {{part, 0}}), full) << "without " << part;
  }
}

const char* kBunny = "/usr/share/glmark2/models/bunny.obj";  // Debian's glmark2-data

TEST(DifferenceQuality, CornellBunny) {
  SACCADE_NEEDS(kBunny);
  Errors errors("cornell-bunny");
  expectThePapersOrder(errors);
}

TEST(DifferenceQuality, BunnyInACornellBoxOfOthers) {
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
  Errors errors(path);
  expectThePapersOrder(errors);
}

TEST(DifferenceQuality, DemodulationKeepsTexture) {
  Errors errors("textured-cornell-box");
  const double full = errors.of("event_svgf", 2);
  EXPECT_GT(errors.of("event_svgf", 2, {{"demodulate", 0}}), full);
}

}  // namespace
}  // namespace saccade::eval
