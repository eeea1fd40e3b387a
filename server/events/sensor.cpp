#include "events/sensor.h"

#include <algorithm>

#include "base/check.h"
#include "base/log_ratio.h"
#include "events/artefact_odds.h"
#include "events/log_response.h"

namespace saccade {

Sensor::Sensor(const SensorConfig& config, int width, int height) : config_(config), dL_(width, height) {
  SACCADE_CHECK(!findFault(config));
  SACCADE_CHECK(width <= UINT16_MAX && height <= UINT16_MAX);
  SensorConfig darkened = config;
  darkened.bias = bias();
  reconstruction_ = findReconstruction(config.reconstruction)->make(darkened, width, height);
  model_ = findEventModel(config.model)->make(config, width, height);
  setNoise();
}

// Photoreceptor and arbiter keep what is under way. The random numbers of the other parts are addressed, so
// they begin at any interval as if they had always been.
void Sensor::setNoise() {
  const NoiseConfig& noise = config_.noise;
  if (photoreceptor_) {
    photoreceptor_->change(noise);
  } else {
    photoreceptor_ = makePhotoreceptor(noise, dL_.width(), dL_.height());
  }
  level_leak_.reset();
  if (noise.level_leak_hz > 0) level_leak_.emplace(config_, dL_.width(), dL_.height());
  noise_sources_ = makeNoiseSources(config_, dL_.width(), dL_.height());
  dead_pixels_.reset(), jitter_.reset();
  if (noise.dead_fraction > 0)
    dead_pixels_.emplace(noise.dead_fraction, config_.seed, dL_.width(), dL_.height());
  if (noise.jitter_s > 0) jitter_.emplace(noise.jitter_s, config_.seed);
  if (arbiter_) {
    arbiter_->change(noise.readout_hz, noise.readout_buffer);
  } else if (noise.readout_hz > 0) {
    arbiter_.emplace(noise.readout_hz, noise.readout_buffer);
  }
}

PixelState Sensor::pixelsAtStart(const ImageF& I_prev) const {
  const auto I_eps = static_cast<float>(bias());
  PixelState pixels;
  for (int y = 0; y < I_prev.height(); ++y) {
    for (int x = 0; x < I_prev.width(); ++x) {
      const float L = finiteLogBrightness(I_prev.at(x, y), I_eps);
      pixels.brightness.push_back(L);
      pixels.reference.push_back(L - model_->level(x, y));
    }
  }
  return pixels;
}

void Sensor::change(const SensorChange& change) {
  SACCADE_CHECK(!change.noise || !changedPixelAmount(config_.noise, *change.noise));
  const double before = bias();
  config_ = changed(config_, change);
  SACCADE_CHECK(!findFault(config_));
  const bool other_thresholds = change.threshold || change.threshold_off;
  if (other_thresholds || (change.noise && config_.noise.brownian_hz > 0)) model_->setThresholds(config_);
  if (bias() != before) reconstruction_->setBias(bias());
  if (change.noise || (other_thresholds && level_leak_)) setNoise();
}

void Sensor::generate(const IntensityChange& change, SensorOutput& out) {
  const Interval interval{change.t0, change.t1, change.frame};
  out.events.clear();
  logResponse(change, static_cast<float>(bias()), dL_);
  model_->see(change.I_now);
  out.suppressed = change.updates.empty() ? moveStraight(change, interval, out.events)
                                          : moveInPieces(change, interval, out.events);
  if (photoreceptor_ && config_.noise.photoreceptor_hz == 0) photoreceptor_.reset();
  out.artefacts = 0;
  if (judges()) judge(change, out);
  if (!noise_sources_.empty()) addNoise(change, out);
  readOut(interval, out);
  giveBackSlack(out.events);
}

std::uint64_t Sensor::moveStraight(const IntensityChange& change, const Interval& interval, Events& events) {
  reconstruction_->reconstruct(change, dL_);
  if (photoreceptor_) photoreceptor_->filter(change, dL_);
  if (level_leak_) level_leak_->add(interval.t1 - interval.t0, dL_);
  return model_->generate(dL_, interval, events);
}

std::uint64_t Sensor::moveInPieces(const IntensityChange& change, const Interval& interval, Events& events) {
  if (!pieces_) pieces_.emplace(dL_.width(), dL_.height());
  pieces_->begin(change, static_cast<float>(bias()), dL_);
  reconstruction_->reconstruct(change, dL_);
  if (reconstruction_->corrects()) pieces_->correct(dL_);
  if (judges()) {
    if (!lengths_) lengths_.emplace(dL_.width(), dL_.height());
    lengths_->clear();
  }
  model_->begin(interval, events);
  while (Pieces* pieces = pieces_->next()) {
    if (photoreceptor_) photoreceptor_->filter(change, *pieces);
    if (level_leak_) level_leak_->add(interval.t1 - interval.t0, *pieces);
    if (judges()) lengths_->add(*pieces);
    model_->advance(*pieces, events);
  }
  pieces_->last(dL_);
  if (photoreceptor_) photoreceptor_->filter(change, dL_, &pieces_->from());
  if (level_leak_) level_leak_->add(interval.t1 - interval.t0, dL_, &pieces_->from());
  const std::uint64_t withheld = model_->end(dL_, pieces_->from(), events);
  if (judges()) lengths_->complete(dL_);
  return withheld;
}

bool Sensor::judges() const {
  return config_.labels || config_.max_artefact_odds < 1;
}

void Sensor::judge(const IntensityChange& change, SensorOutput& out) {
  labelArtefacts(change, static_cast<float>(bias()), dL_, out.events);
  out.artefacts = removeArtefacts(config_.max_artefact_odds, out.events);
  out.suppressed += out.artefacts;
}

void Sensor::addNoise(const IntensityChange& change, SensorOutput& out) {
  NoiseSink sink(
      config_.max_events_per_frame - std::min<std::uint64_t>(config_.max_events_per_frame, out.events.size()),
      out.events);
  for (const auto& source : noise_sources_) source->generate(change, sink);
  out.suppressed += sink.withheld();
}

void Sensor::readOut(const Interval& interval, SensorOutput& out) {
  if (dead_pixels_) dead_pixels_->remove(out.events);
  if (jitter_) jitter_->move(out.events, interval);
  order_.sort(out.events, interval);
  out.lost_in_readout = arbiter_ ? arbiter_->pass(out.events, interval) : 0;
  out.suppressed += out.lost_in_readout;
  if (arbiter_ && !arbiter_->waits() && config_.noise.readout_hz == 0) arbiter_.reset();
}

}  // namespace saccade
