#include "client/options/sensor_options.h"

#include <algorithm>
#include <stdexcept>

#include "client/options/option_range.h"
#include "client/options/request_text.h"
#include "saccade/wire/noise_units.h"
#include "saccade/wire/ranges.h"

namespace saccade::client {
namespace {

void setNoise(const std::vector<std::string>& amounts, v1::Sensor& sensor) {
  for (const std::string& amount : amounts) {
    const auto [name, number] = splitAt(amount, '=');
    const auto value = parseNumber<double>(number);
    const auto* field = v1::Noise::descriptor()->FindFieldByName(name);
    if (!value || !field) {
      throw std::invalid_argument("--noise: '" + amount + "' is not KEY=NUMBER, with KEY one of " +
                                  fieldNames(*v1::Noise::descriptor()));
    }
    v1::Noise& noise = *sensor.mutable_noise();
    noise.GetReflection()->SetDouble(&noise, field, *value);
  }
}

v1::Sensor makeSensor(const SensorOptions& options, std::size_t index) {
  v1::Sensor sensor;
  const auto& off = options.thresholds_off;
  if (!options.thresholds.empty()) sensor.set_threshold(options.thresholds[index]);
  if (!off.empty()) sensor.set_threshold_off(off[off.size() == 1 ? 0 : index]);
  if (options.bias) sensor.set_bias(*options.bias);
  if (options.refractory_s) sensor.set_refractory_s(*options.refractory_s);
  if (options.cutoff_hz) sensor.set_cutoff_hz(*options.cutoff_hz);
  if (options.max_artefact_odds) sensor.set_max_artefact_odds(*options.max_artefact_odds);
  if (options.max_events) sensor.set_max_events_per_pixel_frame(*options.max_events);
  if (!options.model.empty()) {
    sensor.set_model(enumValue<v1::EventModel>("--model", options.model));
  }
  if (!options.start_level.empty()) {
    sensor.set_start_level(enumValue<v1::StartLevel>("--start-level", options.start_level));
  }
  if (!options.reconstruction.empty()) {
    sensor.set_reconstruction(enumValue<v1::Reconstruction>("--reconstruction", options.reconstruction));
  }
  sensor.set_preset(options.preset);
  setNoise(options.noise, sensor);
  return sensor;
}

}  // namespace

void addSensorOptions(CLI::App& command, SensorOptions& o) {
  command.option_defaults()->group("Sensors");
  command
      .add_option("--threshold", o.thresholds,
                  "contrast threshold C, in natural log units; each further value, after a comma or another "
                  "--threshold, is another sensor; default 0.2")
      ->allow_extra_args(false)
      ->delimiter(',');
  command
      .add_option(
          "--threshold-off", o.thresholds_off,
          "threshold of OFF events: one value for all sensors, or one each; default: as --threshold, with "
          "--preset in the proportion of its thresholds")
      ->allow_extra_args(false)
      ->delimiter(',');
  command.add_option("--bias", o.bias,
                     "I_eps, the luminance added to each pixel before the logarithm; default 0.001");
  command.add_option("--refractory", o.refractory_s,
                     "seconds for which a pixel is blind after an event; default 0");
  command.add_option("--model", o.model,
                     "event model: " + enumWords<v1::EventModel>() + "; default accumulating");
  command.add_option("--start-level", o.start_level,
                     "where each pixel is at the first frame: " + enumWords<v1::StartLevel>() +
                         "; random lies between its thresholds, zero is its reference, as in ESIM and v2e, "
                         "with fewer events at first; default random");
  command.add_option("--reconstruction", o.reconstruction,
                     "how a sensor finds its brightness: " + enumWords<v1::Reconstruction>() +
                         "; direct sums the changes and drifts, the others also use the picture; default "
                         "kalman");
  command.add_option("--preset", o.preset, "sensor of a known camera, see `saccade info`");
  command
      .add_option(
          "--noise", o.noise,
          "KEY=NUMBER, an amount of the sensor's noise, such as leak_hz=0.1; may be given again, or several "
          "with commas. KEY is one of " +
              noiseUnitTexts())
      ->allow_extra_args(false)
      ->delimiter(',');
  command.add_option("--max-artefact-odds", o.max_artefact_odds,
                     "withhold events with higher odds to be an artefact of rendering");
  command.add_option(
      "--max-events", o.max_events,
      "events of a pixel from one whole frame to the next; further ones are withheld and counted; "
      "default 32");
  command.add_option("--cutoff", o.cutoff_hz,
                     "Hz below which --reconstruction complementary follows the picture; default 0.5");
}

void limitSensors(CLI::App& command) {
  limitTo(command, "--threshold", ranges::kThreshold);
  limitTo(command, "--threshold-off", ranges::kThreshold);
  limitTo(command, "--bias", ranges::kBias);
  limitTo(command, "--refractory", ranges::kRefractory);
  limitTo(command, "--cutoff", ranges::kCutoff);
  limitTo(command, "--max-artefact-odds", ranges::kArtefactOdds);
  limitTo(command, "--max-events", ranges::kMaxPixelEvents);
}

void addSensors(const SensorOptions& options, v1::OpenStream& open) {
  const std::size_t sensors = std::max<std::size_t>(options.thresholds.size(), 1);
  if (options.thresholds_off.size() > 1 && options.thresholds_off.size() != sensors) {
    throw std::invalid_argument("--threshold-off: give one value, or one for each --threshold");
  }
  for (std::size_t i = 0; i < sensors; ++i) *open.add_sensors() = makeSensor(options, i);
}

}  // namespace saccade::client
