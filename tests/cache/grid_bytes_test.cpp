#include "cache/grid/grid_bytes.h"

#include <gtest/gtest.h>

#include "cache/wall.h"

namespace saccade {
namespace {

using namespace test;

BounceGrid someBounces() {
  BounceGrid bounces(100);
  SurfaceSamples samples(50, 2, 1);
  for (std::size_t i = 0; i < 2 * 50; ++i) {
    samples[i].paths = 1;
    samples.light(i).bounce = {1 + i % 50 % 20, {1, static_cast<float>(i % 50), 3}};
  }
  bounces.add(samples);
  return bounces;
}

std::string bytesOf(const GridLevels& levels, const BounceGrid& bounces) {
  ByteWriter out;
  writeLevels(levels, out), writeBounces(bounces, out);
  return out.take();
}

bool hasCuts(const GridLevels& levels) {
  bool any = false;
  levels.forEach([&](int, const GridLevel& level) { level.cuts.forEach([&](const Cut&) { any = true; }); });
  return any;
}

struct GridBytesTest : testing::Test, View {
  GridBytesTest() {
    wall.noise = 1;
    wall.obstacles = &curtain;
    for (int t = 0; t < 3; ++t) look(wall, 0.7f * t, t);
  }
  Wall wall;
  Curtain curtain;
};

TEST_F(GridBytesTest, AGridGoesOnAsTheOneItWasWrittenFrom) {
  const std::string bytes = bytesOf(grid.levels(), someBounces());
  View other;
  BounceGrid bounces(100);
  ByteReader in(bytes);
  other.grid.levels() = readLevels(in);
  readBounces(in, bounces);
  EXPECT_TRUE(in.left().empty());
  EXPECT_EQ(bytesOf(other.grid.levels(), bounces), bytes);
  EXPECT_TRUE(hasCuts(other.grid.levels()));
  look(wall, 9, 9), other.look(wall, 9, 9);
  EXPECT_EQ(bytesOf(other.grid.levels(), bounces), bytesOf(grid.levels(), bounces));
  EXPECT_NE(bytesOf(grid.levels(), bounces), bytes);
}

TEST_F(GridBytesTest, RefusesBytesThatEndTooEarly) {
  const std::string bytes = bytesOf(grid.levels(), someBounces());
  for (std::size_t size = 0; size < bytes.size(); size += 1 + size / 8) {
    ByteReader in(std::string_view(bytes).substr(0, size));
    BounceGrid bounces(100);
    EXPECT_THROW(readLevels(in), std::runtime_error) << size;
  }
}

TEST_F(GridBytesTest, RefusesWhatIsNoGrid) {
  const auto read = [](const auto&... values) {
    ByteWriter out;
    (out.add(values), ...);
    ByteReader in(out.bytes());
    readLevels(in);
  };
  using Keys = std::vector<VertexKey>;
  const std::vector<Quad> light(2);
  const std::vector<Octet> evidence(2);
  const std::uint32_t one = 1;
  struct CutBytes {
    std::array<std::uint32_t, 4> vertices;
    std::array<CutPlane, 2> planes{{{{1, 0, 0}}}};
  };
  using Cuts = std::vector<CutBytes>;
  EXPECT_NO_THROW(read(one, 5, Keys{7, 8}, light, evidence, Cuts{}));
  EXPECT_NO_THROW(read(one, 5, Keys{7, 8}, light, evidence, Cuts{{{0, 1}}}));
  EXPECT_THROW(read(one, 5, Keys{7, 8}, light, evidence, Cuts{{{0, 2}}}), std::runtime_error);
  EXPECT_THROW(read(one, 5, Keys{7, 8}, light, evidence, Cuts{{{1, 1}}}), std::runtime_error);
  EXPECT_THROW(read(one, 5, Keys{7, 8}, light, evidence, Cuts{{{0, 1}}, {{1, 0}}}), std::runtime_error);
  EXPECT_THROW(read(one, 5, Keys{7, 8}, light, evidence, Cuts{{{0, 1}, {}}}), std::runtime_error);
  EXPECT_THROW(read(one, 500, Keys{7, 8}, light, evidence), std::runtime_error);
  EXPECT_THROW(read(one, 5, Keys{7, 7}, light, evidence), std::runtime_error);
  EXPECT_THROW(read(one, 5, Keys{7, 0}, light, evidence), std::runtime_error);
  EXPECT_THROW(read(one, 5, Keys{7}, light, evidence), std::runtime_error);
  EXPECT_THROW(read(one, 5, std::uint64_t{1} << 60), std::runtime_error);
  EXPECT_THROW(read(std::uint32_t{2}, 5, Keys{}, std::vector<Quad>{}, std::vector<Octet>{}, Cuts{}, 5),
               std::runtime_error);
}

}  // namespace
}  // namespace saccade
