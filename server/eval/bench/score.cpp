#include "eval/bench/score.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/names.h"
#include "eval/bench/sequence.h"
#include "eval/metrics/brightness_change.h"
#include "eval/metrics/error_parts.h"
#include "eval/metrics/event_phases.h"
#include "eval/metrics/event_rates.h"
#include "eval/metrics/event_streams.h"
#include "eval/metrics/for_each_pixel.h"
#include "eval/metrics/noise_free_error.h"
#include "eval/metrics/plane_error.h"

namespace saccade::eval {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// One frame: the truth and the estimates of all repeats.
struct ScoredFrame {
  ScoredFrame(const Truth& of, float bias)
      : truth(of),
        regions(of.regions),
        dL(brightnessChange(of.change, bias)),
        half_a(brightnessChange(of.half_a, of.prev_a, bias)),
        half_b(brightnessChange(of.half_b, of.prev_b, bias)) {}
  const Truth& truth;
  const RegionMap& regions;
  ImageF dL, half_a, half_b;  // halves: of dL, each with its own denominator
  struct Repeat {
    const ImageF& dI;
    ImageF dL;
  };
  std::vector<Repeat> repeats;
};

// A running mean.
struct Mean {
  double sum = 0, count = 0;
  void add(double value) { sum += value, ++count; }
  double value() const { return count > 0 ? sum / count : kNaN; }
};

// The mean of squares. error_parts.h and event_phases.h give the root of a negative square as negative, and
// NaN where there is nothing to measure.
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
    {region::kAnywhere, &Score::false_events, &Score::missed_events, &Score::rms_dL},
    {region::kSmooth, &Score::false_smooth, &Score::missed_smooth, &Score::rms_smooth},
    {region::kCurved, &Score::false_curved, &Score::missed_curved, &Score::rms_curved},
    {region::kChanged, &Score::false_changed, &Score::missed_changed, &Score::rms_changed},
};

void scoreRegion(const Region& r, const std::vector<ScoredFrame>& frames, double C, Score& score) {
  Mean false_events, missed_events;
  MeanSquare rms;
  for (const ScoredFrame& f : frames) {
    for (const auto& repeat : f.repeats) {
      rms.add(rmsError(repeat.dL, f.half_a, f.half_b, f.regions, r.bits));
      forEachPixel(f.regions, [&](int x, int y) {
        if (!(f.regions.at(x, y) & r.bits)) return;
        const double d = repeat.dL.at(x, y), ref = f.dL.at(x, y);
        false_events.add(expectedFalseEvents(d, ref, C));
        missed_events.add(expectedFalseEvents(ref, d, C));
      });
    }
  }
  score.*r.false_events = false_events.value();
  score.*r.missed_events = missed_events.value();
  score.*r.rms = rms.root();
}

void scorePlanes(const std::vector<ScoredFrame>& frames, Score& score) {
  Mean dI_l1, dI_mape, dL_l1, dL_mape;
  for (const ScoredFrame& f : frames) {
    for (const auto& repeat : f.repeats) {
      const ImageF& dI = f.truth.change.dI;
      dI_l1.add(relativeL1(repeat.dI, dI)), dI_mape.add(mape(repeat.dI, dI));
      dL_l1.add(relativeL1(repeat.dL, f.dL)), dL_mape.add(mape(repeat.dL, f.dL));
    }
  }
  score.dI_l1 = dI_l1.value(), score.dI_mape = dI_mape.value();
  score.dL_l1 = dL_l1.value(), score.dL_mape = dL_mape.value();
}

void scoreHalves(const std::vector<ScoredFrame>& frames, Score& score) {
  NoiseFreeError dI, dL;
  for (const ScoredFrame& f : frames) {
    for (const auto& repeat : f.repeats) {
      dI.add(repeat.dI, f.truth.half_a, f.truth.half_b);
      dL.add(repeat.dL, f.half_a, f.half_b);
    }
  }
  score.dI_error = dI.relative(), score.dI_share = dI.share();
  score.dL_error = dL.relative(), score.dL_share = dL.share();
}

// Needs two repeats.
void scoreNoise(const std::vector<ScoredFrame>& frames, Score& score) {
  Mean sigma;
  MeanSquare bias, noise;
  for (const ScoredFrame& f : frames) {
    Repeats dL(f.dL.width(), f.dL.height());
    for (const auto& repeat : f.repeats) dL.add(repeat.dL);
    const ErrorParts parts = errorParts(dL, f.half_a, f.half_b, f.regions, region::kAnywhere);
    bias.add(parts.bias), noise.add(parts.noise);
    const double unchanged = median(dL.sigma(), f.regions, region::kUnchanged);
    if (!std::isnan(unchanged)) sigma.add(unchanged);
  }
  score.sigma_dL = sigma.value(), score.bias_dL = bias.root(), score.noise_dL = noise.root();
}

// The times of all frames but the first. Events of the first come from the sensor's random start, not from
// the motion before it.
FrameIntervals intervalsOf(const ChangeSequence& changes) {
  FrameIntervals intervals;
  for (std::size_t f = 1; f < changes.size(); ++f)
    intervals.push_back({changes[f]->t0.count(), changes[f]->t1.count()});
  return intervals;
}

void scoreEvents(const std::vector<Truth>& truth, std::span<const BenchRun> repeats, double bias, double C,
                 Score& score) {
  const SensorConfig sensor{.threshold = C, .threshold_off = C, .bias = bias, .reconstruction = "direct"};
  const Events ref = eventsOf(sequenceOf(truth), sensor);
  const PhasedEvents ref_phases = phasesOf(ref, intervalsOf(sequenceOf(truth)));
  Mean count, voxel, time;
  MeanSquare phase;
  for (const BenchRun& run : repeats) {
    const Events events = eventsOf(sequenceOf(run), sensor);
    count.add(countError(events, ref));
    voxel.add(voxelError(events, ref));
    if (!events.empty()) time.add(nearestTimeError(events, ref).mean_ns / 1e6);
    phase.add(phaseError(phasesOf(events, intervalsOf(sequenceOf(run))), ref_phases));
  }
  score.count_error = count.value(), score.voxel_error = voxel.value(), score.time_error_ms = time.value();
  score.phase_error = phase.root();
}

}  // namespace

const ScoreColumn& columnOf(double Score::*value) {
  const auto column = std::find_if(kScoreColumns.begin(), kScoreColumns.end(),
                                   [&](const ScoreColumn& c) { return c.value == value; });
  SACCADE_CHECK(column != kScoreColumns.end());
  return *column;
}

std::string scoreNames() {
  return joinRowNames(kScoreColumns);
}

Score scoreOf(const std::vector<Truth>& truth, std::span<const BenchRun> repeats, double bias,
              double threshold) {
  SACCADE_CHECK(!truth.empty() && !repeats.empty());
  const auto I_eps = static_cast<float>(bias);
  std::vector<ScoredFrame> frames;
  for (std::size_t f = 0; f < truth.size(); ++f) {
    frames.emplace_back(truth[f], I_eps);
    for (const BenchRun& run : repeats)
      frames.back().repeats.push_back({run.changes[f].dI, brightnessChange(run.changes[f], I_eps)});
  }
  Score score;
  score.sigma_dL = score.bias_dL = score.noise_dL = kNaN;
  scorePlanes(frames, score);
  scoreHalves(frames, score);
  for (const Region& r : kRegions) scoreRegion(r, frames, threshold, score);
  if (repeats.size() > 1) scoreNoise(frames, score);
  scoreEvents(truth, repeats, bias, threshold, score);
  return score;
}

double ownFalseEvents(const std::vector<Truth>& truth, double bias, double threshold) {
  Mean events;
  for (const Truth& t : truth) {
    const ScoredFrame f(t, static_cast<float>(bias));
    events.add(ownRate(integratedRates(f.half_a, f.half_b, threshold)));
  }
  return events.value();
}

}  // namespace saccade::eval
