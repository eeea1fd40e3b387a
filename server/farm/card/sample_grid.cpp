#include "farm/card/sample_grid.h"

#include <algorithm>
#include <cmath>

namespace saccade::farm {
namespace {

using client::Colour;
using client::RgbPicture;

constexpr int kColumns = 4, kTileWidth = 240, kGap = 8, kCaption = 24, kLine = 11;  // pixels
constexpr float kNoSurface = 1e5f;  // the channel depth has it where no surface is
constexpr double kFarShare = 0.95;  // of the distances are not farther than black

// Where a picture of a size stands within a tile: enlarged by whole numbers, or `side` pixels become one.
struct Fit {
  Fit(int width, int height)
      : zoom(std::max(1, kTileWidth / width)),
        side((width + kTileWidth - 1) / kTileWidth),
        columns((width + side - 1) / side),
        rows((height + side - 1) / side) {}
  int zoom, side, columns, rows;
  int height() const { return rows * zoom; }
};

void fill(RgbPicture& picture, int left, int top, const Fit& fit, const auto& colourOf) {
  for (int y = 0; y < fit.height(); ++y)
    for (int x = 0; x < fit.columns * fit.zoom; ++x)
      picture.put(left + x, top + y, colourOf(x / fit.zoom * fit.side, y / fit.zoom * fit.side));
}

Fit fitOf(const SamplePicture& sample) {
  return {sample.surface.width(), sample.surface.height()};
}

void drawEvents(RgbPicture& picture, int left, int top, const SamplePicture& sample) {
  const Fit fit = fitOf(sample);
  fill(picture, left, top, fit, [&](int x, int y) {
    const float weight = sample.surface.weight(x, y, fit.side, sample.now_ns);
    return client::mix(client::kWhite, weight > 0 ? client::kRed : client::kBlue, std::abs(weight));
  });
}

bool hasSurface(float depth) {
  return depth > 0 && depth < kNoSurface;  // not a NaN
}

void drawDepth(RgbPicture& picture, int left, int top, const client::PlanePicture& depth) {
  std::vector<float> known;
  for (const float value : depth.values)
    if (hasSurface(value)) known.push_back(value);
  if (known.empty()) return;
  std::ranges::sort(known);
  const float near = known.front(),
              far = known[static_cast<std::size_t>(kFarShare * static_cast<double>(known.size() - 1))];
  const Fit fit(depth.width, depth.height);
  fill(picture, left, top, fit, [&](int x, int y) {
    const float value = depth.values[std::size_t(y) * depth.width + x];
    if (!hasSurface(value)) return client::kBlack;
    const float grey = far > near ? (far - value) / (far - near) : 1;
    return Colour{grey, grey, grey};
  });
}

std::string cut(const std::string& text) {
  return text.substr(0, kTileWidth / client::kLetterWidth);
}

}  // namespace

RgbPicture drawGrid(const DataSet& set, const std::vector<SamplePicture>& samples) {
  int events = 0, depths = 0;
  for (const SamplePicture& sample : samples) {
    events = std::max(events, fitOf(sample).height());
    if (sample.depth)
      depths = std::max(depths, Fit(sample.depth->width, sample.depth->height).height() + kGap);
  }
  const int count = static_cast<int>(samples.size()), row = kCaption + events + depths + kGap;
  RgbPicture picture = client::whitePicture(std::min(count, kColumns) * (kTileWidth + kGap) - kGap,
                                            (count + kColumns - 1) / kColumns * row - kGap);
  for (int i = 0; i < count; ++i) {
    const SamplePicture& sample = samples[static_cast<std::size_t>(i)];
    const int left = i % kColumns * (kTileWidth + kGap), top = i / kColumns * row;
    picture.write(left, top + 1,
                  cut(set.sequenceName(sample.sequence.number()) + " " + sample.sequence.split()),
                  client::kBlack);
    picture.write(left, top + 1 + kLine, cut(sample.sequence.options(0)), client::kBlack);
    drawEvents(picture, left, top + kCaption, sample);
    if (sample.depth) drawDepth(picture, left, top + kCaption + events + kGap, *sample.depth);
  }
  return picture;
}

}  // namespace saccade::farm
