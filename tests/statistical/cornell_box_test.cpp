// The Cornell box against another program's render: Cycles, 3 indirect bounces, 8192 paths, pixel centres,
// two poses 0.01 apart to the right, standard errors beside.
//
// Quick by default. SACCADE_FULL=1 takes as many paths as make our standard error of the difference no larger
// than the reference's.
#include <gtest/gtest.h>

#include <cmath>

#include "render/renderer.h"
#include "scene/mitsuba/mitsuba_xml.h"
#include "statistical/npy.h"
#include "statistical/outside_files.h"

namespace saccade {
namespace {

constexpr int kSize = 128, kBlock = 8, kBatches = 16, kBounces = 3;
using Plane = std::vector<double>;  // luminance, row by row

Plane readLuminance(const std::string& name) {
  const auto rgb = test::readNpy(test::referenceRender("cornell-box-128/cornell_128_b3_" + name + ".npy"),
                                 kSize * kSize * 3);
  Plane y;
  for (std::size_t i = 0; i < rgb.size(); i += 3) y.push_back(luminance({rgb[i], rgb[i + 1], rgb[i + 2]}));
  return y;
}

// Standard error of the reference's luminance; its channels share their paths, so the errors add up.
Plane readError(const std::string& name) {
  return readLuminance(name + "_se");
}

Plane toPlane(const ImageF& image) {
  Plane y;
  for (int row = 0; row < kSize; ++row) y.insert(y.end(), image.row(row), image.row(row) + kSize);
  return y;
}

Plane blockMeans(const Plane& y) {
  constexpr int kAcross = kSize / kBlock;
  Plane means(kAcross * kAcross);
  for (int i = 0; i < kSize * kSize; ++i)
    means[i / kSize / kBlock * kAcross + i % kSize / kBlock] += y[i] / (kBlock * kBlock);
  return means;
}

double mean(const Plane& y) {
  double sum = 0;
  for (double v : y) sum += v;
  return sum / static_cast<double>(y.size());
}

struct Ours {
  Plane p0, p1, d01, block_error;  // block_error: standard error of d01's block means, from the batches
  double pixel_error;              // mean standard error of d01 per pixel
  std::vector<bool> smooth;        // block without a depth edge in either pose
};

// A block has an edge where a pixel's neighbour does not lie on its tangent plane.
void markEdges(const GBuffer& g, std::vector<bool>& smooth) {
  const auto block = [](int x, int y) {
    return static_cast<std::size_t>(y / kBlock * (kSize / kBlock) + x / kBlock);
  };
  const auto differ = [&](int x, int y, int qx, int qy) {
    const float cosine =
        g.nx.at(x, y) * g.nx.at(qx, qy) + g.ny.at(x, y) * g.ny.at(qx, qy) + g.nz.at(x, y) * g.nz.at(qx, qy);
    const float limit = 2 * g.dz.at(x, y) + 0.005f * g.z.at(x, y);
    return cosine < 0.99f || std::abs(g.z.at(qx, qy) - g.z.at(x, y)) > limit;
  };
  for (int y = 0; y + 1 < kSize; ++y) {
    for (int x = 0; x + 1 < kSize; ++x) {
      if (differ(x, y, x + 1, y)) smooth[block(x, y)] = smooth[block(x + 1, y)] = false;
      if (differ(x, y, x, y + 1)) smooth[block(x, y)] = smooth[block(x, y + 1)] = false;
    }
  }
}

Ours renderOurs(int spp) {
  auto scene = std::make_shared<RenderScene>(loadMitsubaXml(test::realScene("cornell-box/scene.xml")));
  const Scene& s = scene->description();
  TilePool pool(2);
  const PosedScene posed(scene);
  Renderer renderer({kBounces, 3});
  const Camera camera[2] = {{s.T_world_camera, pinhole(s.fov_x_deg, kSize, kSize)},
                            {s.T_world_camera * Pose{{0.01, 0, 0}, {}}, pinhole(s.fov_x_deg, kSize, kSize)}};
  Frame frame(kSize, kSize);
  Ours out{Plane(kSize * kSize),
           Plane(kSize * kSize),
           {},
           {},
           0,
           std::vector<bool>(kSize * kSize / kBlock / kBlock, true)};
  std::vector<Plane> batches;
  for (int b = 0; b < kBatches; ++b) {
    const SeedPlan seeds = SeedPlan::independent(1, static_cast<FrameIndex>(b), spp / kBatches);
    Plane p[2];
    for (int k : {0, 1}) {
      renderer.render(PixelContext({posed, camera[k]}), seeds, pool, frame);
      p[k] = toPlane(frame.samples.I2);
      if (b == 0) markEdges(frame.g, out.smooth);
    }
    for (int i = 0; i < kSize * kSize; ++i) {
      out.p0[i] += p[0][i] / kBatches, out.p1[i] += p[1][i] / kBatches, p[1][i] -= p[0][i];
    }
    batches.push_back(p[1]);
  }
  for (int i = 0; i < kSize * kSize; ++i) out.d01.push_back(out.p1[i] - out.p0[i]);

  const auto spread = [&](auto&& of, std::size_t count) {
    Plane sum(count), square(count);
    for (const Plane& batch : batches) {
      const Plane v = of(batch);
      for (std::size_t i = 0; i < count; ++i) sum[i] += v[i] / kBatches, square[i] += v[i] * v[i] / kBatches;
    }
    for (std::size_t i = 0; i < count; ++i)
      sum[i] = std::sqrt(std::max(0.0, square[i] - sum[i] * sum[i]) / (kBatches - 1));
    return sum;
  };
  out.block_error = spread(blockMeans, out.smooth.size());
  out.pixel_error = mean(spread([](const Plane& p) { return p; }, kSize * kSize));
  return out;
}

TEST(CornellBox, EqualsCyclesInBothPosesAndInTheirDifference) {
  SACCADE_NEEDS(test::realScene("cornell-box/scene.xml"));
  SACCADE_NEEDS(test::referenceRender("cornell-box-128/cornell_128_b3_p0.npy"));
  const bool full = std::getenv("SACCADE_FULL") != nullptr;
  const Ours ours = renderOurs(full ? 10240 : 512);

  // Mean ratio within 0.3 % for both poses.
  EXPECT_NEAR(mean(ours.p0) / mean(readLuminance("p0")), 1, 0.003);
  EXPECT_NEAR(mean(ours.p1) / mean(readLuminance("p1")), 1, 0.003);

  // The difference is unbiased over blocks without depth edges.
  const Plane reference = readLuminance("d01"), error = readError("d01");
  Plane squares;
  for (double e : error) squares.push_back(e * e);
  const Plane d_ref = blockMeans(reference), d = blockMeans(ours.d01), variance_ref = blockMeans(squares);
  double z2 = 0;
  int blocks = 0;
  for (std::size_t i = 0; i < d.size(); ++i) {
    if (!ours.smooth[i]) continue;
    const double block_variance_ref = variance_ref[i] / (kBlock * kBlock);  // pixels are independent
    z2 += std::pow(d[i] - d_ref[i], 2) / (block_variance_ref + ours.block_error[i] * ours.block_error[i]);
    ++blocks;
  }
  const double rms = std::sqrt(z2 / blocks);
  std::printf(
      "ratios %.5f %.5f; d01: z rms %.3f over %d blocks; mean standard error per pixel %.3g, reference "
      "%.3g\n",
      mean(ours.p0) / mean(readLuminance("p0")), mean(ours.p1) / mean(readLuminance("p1")), rms, blocks,
      ours.pixel_error, mean(error));
  EXPECT_GT(blocks, 60);
  EXPECT_LE(rms, 1.3);
  if (full) {
    EXPECT_LE(ours.pixel_error, mean(error));
  }
}

}  // namespace
}  // namespace saccade
