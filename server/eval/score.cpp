#include "eval/score.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "eval/metrics/brightness_change.h"
#include "eval/metrics/error_parts.h"
#include "eval/metrics/event_streams.h"
#include "eval/metrics/for_each_pixel.h"
#include "eval/metrics/frame_errors.h"
#include "events/sensor.h"

namespace saccade {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// dL of one half of the reference; the halves share the denominator, whose noise is small.
ImageF brightnessChange(const Truth& truth, const ImageF& half_dI, float bias) {
  IntensityChange change(half_dI.width(), half_dI.height());
  change.dI.copyFrom(half_dI);
  change.I_prev.copyFrom(truth.change.I_prev);
  return brightnessChange(change, bias);
}

// A mean whose sum is still growing.
struct Mean {
  double sum = 0, count = 0;
  void add(double value, double weight = 1) { sum += weight * value, count += weight; }
  double value() const { return count > 0 ? sum / count : kNaN; }
};

// Of mean squares; error_parts.h gives the root of a negative one as negative.
struct MeanSquare {
  Mean mean;
  void add(double root) {
    if (!std::isnan(root)) mean.add(root * std::abs(root));
  }
  double root() const { return std::copysign(std::sqrt(std::abs(mean.value())), mean.value()); }
};

struct Region {
  std::uint32_t bits;
  double Score::*false_events, Score::*missed_events, Score::*rms;
};
constexpr Region kRegions[] = {
    {region::kSmooth, &Score::false_smooth, &Score::missed_smooth, &Score::rms_smooth},
    {region::kCurved, &Score::false_curved, &Score::missed_curved, &Score::rms_curved},
    {region::kChanged, &Score::false_changed, &Score::missed_changed, &Score::rms_changed},
};

void scoreRegion(const Region& r, const std::vector<Truth>& truth, const std::vector<BenchRun>& repeats,
                 float bias, double C, Score& score) {
  Mean false_events, missed_events;
  MeanSquare rms;
  for (std::size_t f = 0; f < truth.size(); ++f) {
    const ImageF ref = brightnessChange(truth[f].change, bias);
    const ImageF a = brightnessChange(truth[f], truth[f].reference.half_a, bias),
                 b = brightnessChange(truth[f], truth[f].reference.half_b, bias);
    for (const BenchRun& run : repeats) {
      const ImageF dL = brightnessChange(run.changes[f], bias);
      rms.add(rmsError(dL, a, b, truth[f].regions, r.bits));
      forEachPixel(dL, [&](int x, int y) {
        if (!(truth[f].regions.at(x, y) & r.bits)) return;
        false_events.add(expectedFalseEvents(dL.at(x, y), ref.at(x, y), C));
        missed_events.add(expectedFalseEvents(ref.at(x, y), dL.at(x, y), C));
      });
    }
  }
  score.*r.false_events = false_events.value();
  score.*r.missed_events = missed_events.value();
  score.*r.rms = rms.root();
}

void scoreFrames(const std::vector<Truth>& truth, const std::vector<BenchRun>& repeats, float bias, double C,
                 Score& score) {
  Mean dI_l1, dI_mape, dL_l1, dL_mape, false_events, missed_events;
  for (std::size_t f = 0; f < truth.size(); ++f) {
    for (const BenchRun& run : repeats) {
      const FrameErrors e = frameErrors(run.changes[f], truth[f].change, bias, C);
      dI_l1.add(e.dI_l1), dI_mape.add(e.dI_mape), dL_l1.add(e.dL_l1), dL_mape.add(e.dL_mape);
      false_events.add(e.rates.false_events), missed_events.add(e.rates.missed_events);
    }
  }
  score.dI_l1 = dI_l1.value(), score.dI_mape = dI_mape.value();
  score.dL_l1 = dL_l1.value(), score.dL_mape = dL_mape.value();
  score.false_events = false_events.value(), score.missed_events = missed_events.value();
}

void scoreNoise(const std::vector<Truth>& truth, const std::vector<BenchRun>& repeats, float bias,
                Score& score) {
  Mean sigma;
  MeanSquare rms, bias_part, noise;
  for (std::size_t f = 0; f < truth.size(); ++f) {
    const Truth& t = truth[f];
    Repeats dL(t.change.dI.width(), t.change.dI.height());
    for (const BenchRun& run : repeats) dL.add(brightnessChange(run.changes[f], bias));
    const ErrorParts parts =
        errorParts(dL, brightnessChange(t, t.reference.half_a, bias),
                   brightnessChange(t, t.reference.half_b, bias), t.regions, region::kAnywhere);
    rms.add(parts.rms), bias_part.add(parts.bias), noise.add(parts.noise);
    sigma.add(median(dL.sigma(), t.regions, region::kUnchanged));
  }
  score.sigma_dL = sigma.value();
  score.rms_dL = rms.root(), score.bias_dL = bias_part.root(), score.noise_dL = noise.root();
}

Events eventsOf(const std::vector<const IntensityChange*>& changes, double bias, double C) {
  const ImageF& plane = changes.front()->dI;
  Sensor sensor({.threshold = C, .threshold_off = C, .bias = bias}, plane.width(), plane.height());
  Events all;
  SensorOutput out;
  for (const IntensityChange* change : changes) {
    sensor.generate(*change, out);
    all.insert(all.end(), out.events.begin(), out.events.end());
  }
  return all;
}

void scoreEvents(const std::vector<Truth>& truth, const std::vector<BenchRun>& repeats, double bias, double C,
                 Score& score) {
  std::vector<const IntensityChange*> changes;
  for (const Truth& t : truth) changes.push_back(&t.change);
  const Events ref = eventsOf(changes, bias, C);
  Mean count, voxel, time;
  for (const BenchRun& run : repeats) {
    changes.clear();
    for (const IntensityChange& change : run.changes) changes.push_back(&change);
    const Events events = eventsOf(changes, bias, C);
    count.add(countError(events, ref));
    voxel.add(voxelError(events, ref));
    if (!events.empty()) time.add(nearestTimeError(events, ref).mean_ns / 1e6);
  }
  score.count_error = count.value(), score.voxel_error = voxel.value(), score.time_error_ms = time.value();
}

}  // namespace

const ScoreColumn& columnOf(double Score::*value) {
  const auto column = std::find_if(kScoreColumns.begin(), kScoreColumns.end(),
                                   [&](const ScoreColumn& c) { return c.value == value; });
  SACCADE_CHECK(column != kScoreColumns.end());
  return *column;
}

std::string scoreNames() {
  std::string names;
  for (const ScoreColumn& column : kScoreColumns)
    names += (names.empty() ? "" : ", ") + std::string(column.name);
  return names;
}

Score scoreOf(const Bench& bench, const std::vector<BenchRun>& repeats, double bias, double threshold) {
  SACCADE_CHECK(!repeats.empty());
  const auto I_eps = static_cast<float>(bias);
  Score score;
  for (const ScoreColumn& column : kScoreColumns) score.*column.value = kNaN;
  scoreFrames(bench.truth(), repeats, I_eps, threshold, score);
  for (const Region& r : kRegions) scoreRegion(r, bench.truth(), repeats, I_eps, threshold, score);
  if (repeats.size() > 1) scoreNoise(bench.truth(), repeats, I_eps, score);
  scoreEvents(bench.truth(), repeats, bias, threshold, score);
  return score;
}

}  // namespace saccade
