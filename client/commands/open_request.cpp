#include "client/commands/record_options.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace saccade {
namespace {

// A value of a schema's enum from its name on the command line: "lossless" is DELIVERY_LOSSLESS.
template <class Parse, class Enum>
void setEnum(Parse parse, const std::string& prefix, std::string name, Enum& value) {
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::toupper(c); });
  if (!parse(prefix + name, &value))
    throw std::invalid_argument("'" + name + "' is not a " + prefix + " value");
}

std::string readFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (!(text << file.rdbuf())) throw std::invalid_argument("--trajectory: cannot read '" + path + "'");
  return text.str();
}

v1::Trajectory makeTrajectory(const std::string& name_or_file) {
  v1::Trajectory trajectory;
  if (name_or_file.ends_with(".csv") || std::filesystem::is_regular_file(name_or_file)) {
    trajectory.set_csv(readFile(name_or_file));
  } else {
    trajectory.set_name(name_or_file);
  }
  return trajectory;
}

// All of `text`, or nothing.
template <class T>
std::optional<T> parseNumber(std::string_view text) {
  T value;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || rest != text.data() + text.size()) return std::nullopt;
  return value;
}

// What stands before and behind `separator`; nothing behind where there is none.
std::pair<std::string, std::string> splitAt(const std::string& text, char separator) {
  const std::size_t at = std::min(text.find(separator), text.size());
  return {text.substr(0, at), text.substr(std::min(at + 1, text.size()))};
}

v1::View makeView(const RecordOptions& options) {
  const auto [left, right] = splitAt(options.size, 'x');
  const auto width = parseNumber<std::uint32_t>(left), height = parseNumber<std::uint32_t>(right);
  if (!width || !height) {
    throw std::invalid_argument("--size: '" + options.size + "' is not WIDTHxHEIGHT, such as 346x260");
  }
  v1::View view;
  view.set_width(*width);
  view.set_height(*height);
  if (options.fov_x_deg) view.set_fov_x_deg(*options.fov_x_deg);
  return view;
}

v1::Method makeMethod(const RecordOptions& options) {
  v1::Method method;
  method.set_name(options.method);
  method.set_spp(options.spp.value_or(0));
  for (const std::string& param : options.params) {
    const auto [name, number] = splitAt(param, '=');
    const auto value = parseNumber<double>(number);
    if (name.empty() || !value) throw std::invalid_argument("--set: '" + param + "' is not NAME=NUMBER");
    (*method.mutable_params())[name] = *value;
  }
  return method;
}

v1::Quality makeQuality(const RecordOptions& options) {
  v1::Quality quality;
  if (options.bounces) quality.set_bounces(*options.bounces);
  if (options.budget_ms) quality.set_budget_ms(*options.budget_ms);
  if (options.max_false_rate) quality.set_max_false_rate(*options.max_false_rate);
  return quality;
}

v1::Sensor makeSensor(const RecordOptions& options, std::size_t index) {
  v1::Sensor sensor;
  const auto& off = options.thresholds_off;
  if (!options.thresholds.empty()) sensor.set_threshold(options.thresholds[index]);
  if (!off.empty()) sensor.set_threshold_off(off[off.size() == 1 ? 0 : index]);
  if (options.bias) sensor.set_bias(*options.bias);
  if (options.refractory_s) sensor.set_refractory_s(*options.refractory_s);
  if (options.cutoff_hz) sensor.set_cutoff_hz(*options.cutoff_hz);
  if (!options.model.empty()) {
    v1::EventModel model;
    setEnum(v1::EventModel_Parse, "EVENT_MODEL_", options.model, model);
    sensor.set_model(model);
  }
  if (!options.reconstruction.empty()) {
    v1::ReconstructionModel reconstruction;
    setEnum(v1::ReconstructionModel_Parse, "RECONSTRUCTION_", options.reconstruction, reconstruction);
    sensor.set_reconstruction(reconstruction);
  }
  return sensor;
}

v1::Timing makeTiming(const RecordOptions& options) {
  v1::Timing timing;
  timing.set_frame_rate_hz(options.rate_hz);
  timing.set_duration_s(options.duration_s);
  v1::Clock clock;
  setEnum(v1::Clock_Parse, "CLOCK_", options.clock, clock);
  timing.set_clock(clock);
  return timing;
}

}  // namespace

v1::OpenStream makeOpenStream(const RecordOptions& options) {
  const std::size_t sensors = std::max<std::size_t>(options.thresholds.size(), 1);
  if (options.thresholds_off.size() > 1 && options.thresholds_off.size() != sensors) {
    throw std::invalid_argument("--threshold-off: give one value, or as many as of --threshold");
  }
  v1::OpenStream open;
  open.set_scene(options.scene);
  *open.mutable_view() = makeView(options);
  *open.mutable_trajectory() = makeTrajectory(options.trajectory);
  *open.mutable_timing() = makeTiming(options);
  *open.mutable_method() = makeMethod(options);
  *open.mutable_quality() = makeQuality(options);
  for (std::size_t i = 0; i < sensors; ++i) *open.add_sensors() = makeSensor(options, i);
  v1::Delivery delivery;
  setEnum(v1::Delivery_Parse, "DELIVERY_", options.delivery, delivery);
  open.set_delivery(delivery);
  open.set_seed(options.seed);
  return open;
}

}  // namespace saccade
