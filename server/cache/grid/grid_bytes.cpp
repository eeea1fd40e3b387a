#include "cache/grid/grid_bytes.h"

#include <algorithm>

namespace saccade {
namespace {

// A cut as it is written.
struct CutBytes {
  std::array<std::uint32_t, CutPlanes::kSides> vertices;
  std::array<CutPlane, 2> planes;
};

void require(bool holds, const char* fault) {
  if (!holds) throw std::runtime_error(fault);
}

void readCuts(ByteReader& in, Cuts& cuts, std::size_t vertices) {
  cuts.resize(vertices);
  for (const auto& [of_sides, planes] : in.getVector<std::vector<CutBytes>>()) {
    Cut cut{{}, of_sides};
    for (const CutPlane& plane : planes)
      if (!(plane.normal == Vec3{})) cut.planes.add(plane);
    require(!cut.planes.empty(), "a cut has no planes");
    std::vector<std::uint32_t> of_cut;
    cut.forEachVertex([&](std::uint32_t v) {
      require(v < vertices && std::ranges::count(of_cut, v) == 0, "a cut has no vertices");
      require(!cuts.find(v), "a vertex has two cuts");
      of_cut.push_back(v);
    });
    cuts.add(cut);
  }
}

void readLevel(ByteReader& in, GridLevel& level) {
  const auto keys = in.getVector<std::vector<VertexKey>>();
  level.light = in.getVector<HugeVector<Quad>>(), level.evidence = in.getVector<HugeVector<Octet>>();
  require(level.light.size() == keys.size() && level.evidence.size() == keys.size(),
          "a level has vertices without values");
  VertexTable::Finder finder(level.table, 0);
  for (std::uint32_t v = 0; v < keys.size(); ++v)
    require(keys[v] != 0 && level.table.indexAt(finder.find(keys[v])) == v, "a vertex stands twice");
  readCuts(in, level.cuts, keys.size());
  for (std::uint32_t v = 0; v < keys.size(); ++v)
    if (!level.cuts.find(v)) level.table.unmark(finder.find(keys[v]));
}

}  // namespace

void writeLevels(const GridLevels& levels, ByteWriter& out) {
  std::uint32_t count = 0;
  levels.forEach([&](int, const GridLevel&) { ++count; });
  out.add(count);
  levels.forEach([&](int l, const GridLevel& level) {
    out.add(static_cast<std::int32_t>(l));
    out.add(level.table.keys()), out.add(level.light), out.add(level.evidence);
    std::vector<CutBytes> cuts;
    level.cuts.forEach([&](const Cut& c) { cuts.push_back({c.vertices, c.planes.all()}); });
    out.add(cuts);
  });
}

GridLevels readLevels(ByteReader& in) {
  GridLevels levels;
  for (auto count = in.get<std::uint32_t>(); count > 0; --count) {
    const auto l = in.get<std::int32_t>();
    require(GridLevels::has(l) && !levels.find(l), "a level is out of range");
    levels.makeAll(l, l);
    readLevel(in, levels[l]);
  }
  return levels;
}

void writeBounces(const BounceGrid& bounces, ByteWriter& out) {
  out.add(bounces.keys()), out.add(bounces.light());
}

void readBounces(ByteReader& in, BounceGrid& bounces) {
  const auto keys = in.getVector<std::vector<std::uint64_t>>();
  const auto light = in.getVector<std::vector<Quad>>();
  require(light.size() == keys.size(), "cells without values");
  require(bounces.restore(keys, light), "a cell stands twice");
}

}  // namespace saccade
