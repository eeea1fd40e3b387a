#include "eval/metrics/block_ratios.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

#include "base/quantile.h"

namespace saccade::eval {
namespace {

// Mean of each block of edge x edge pixels, row by row.
std::vector<Rgb> blockMeans(const RgbPlanes& planes, int edge, int across, int down) {
  const auto mean = [&](const ImageF& plane, int column, int row) {
    double sum = 0;
    for (int y = row * edge; y < (row + 1) * edge; ++y)
      sum = std::accumulate(plane.row(y) + column * edge, plane.row(y) + (column + 1) * edge, sum);
    return static_cast<float>(sum / (edge * edge));
  };
  std::vector<Rgb> means;
  for (int row = 0; row < down; ++row) {
    for (int column = 0; column < across; ++column)
      means.push_back(
          {mean(planes[0], column, row), mean(planes[1], column, row), mean(planes[2], column, row)});
  }
  return means;
}

// The edge of a block in pixels of the picture.
int edgeIn(const ImageF& picture, const ImageF& reference, int edge) {
  const int scaled = edge * picture.width();
  if (picture.width() <= reference.width() && scaled % reference.width() == 0 &&
      picture.width() * reference.height() == picture.height() * reference.width())
    return scaled / reference.width();
  const auto size = [](const ImageF& p) {
    return std::to_string(p.width()) + "x" + std::to_string(p.height());
  };
  throw std::runtime_error("a picture of " + size(picture) + " has no whole pixels in blocks of " +
                           std::to_string(edge) + " pixels of a reference of " + size(reference));
}

bool touches(const PixelRect& r, int x, int y, int edge) {
  return r.x < x + edge && x < r.x + r.width && r.y < y + edge && y < r.y + r.height;
}

bool isFinite(Rgb c) {
  return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z);
}

// Luminance below which a block is too dark.
double darkness(const std::vector<Rgb>& means, double least_light) {
  std::vector<double> luminances;
  for (const Rgb c : means) {
    if (isFinite(c)) luminances.push_back(luminance(c));
  }
  return luminances.empty() ? 0 : least_light * quantile(luminances, 0.5);
}

}  // namespace

double Block::ratio() const {
  return static_cast<double>(luminance(picture)) / luminance(reference);
}

int BlockRatios::compared() const {
  return static_cast<int>(
      std::count_if(blocks.begin(), blocks.end(), [](const Block& b) { return b.compared; }));
}

std::array<double, 3> BlockRatios::meanRatio() const {
  Vec3d picture, reference;
  for (const Block& b : blocks) {
    if (b.compared) picture = picture + toDouble(b.picture), reference = reference + toDouble(b.reference);
  }
  return {picture.x / reference.x, picture.y / reference.y, picture.z / reference.z};
}

double BlockRatios::shareWithin(double within) const {
  const auto count = std::count_if(blocks.begin(), blocks.end(), [&](const Block& b) {
    return b.compared && std::abs(b.ratio() - 1) <= within;
  });
  return static_cast<double>(count) / compared();
}

BlockRatios blockRatios(const RgbPlanes& picture, const RgbPlanes& reference, const BlockSettings& settings) {
  const int edge = settings.edge, across = reference[0].width() / edge, down = reference[0].height() / edge;
  const std::vector<Rgb> x = blockMeans(picture, edgeIn(picture[0], reference[0], edge), across, down),
                         ref = blockMeans(reference, edge, across, down);
  const double dark = darkness(ref, settings.least_light);
  BlockRatios out{edge, across, down, {}};
  for (int i = 0; i < across * down; ++i) {
    const auto left_out = [&](const PixelRect& r) {
      return touches(r, i % across * edge, i / across * edge, edge);
    };
    const std::size_t k = static_cast<std::size_t>(i);
    const bool compared = isFinite(x[k]) && isFinite(ref[k]) && luminance(ref[k]) > 0 &&
                          luminance(ref[k]) >= dark &&
                          std::none_of(settings.left_out.begin(), settings.left_out.end(), left_out);
    out.blocks.push_back({x[k], ref[k], compared});
  }
  if (out.compared() == 0) throw std::runtime_error("no block is bright enough to be compared");
  return out;
}

}  // namespace saccade::eval
