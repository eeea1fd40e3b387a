#include "client/commands/record_options.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "client/commands/commands.h"
#include "client/writers/writer.h"

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

v1::View makeView(const RecordOptions& options) {
  unsigned width = 0, height = 0;
  int read = -1;
  const int fields = std::sscanf(options.size.c_str(), "%5ux%5u%n", &width, &height, &read);
  if (fields != 2 || read != static_cast<int>(options.size.size())) {
    throw std::invalid_argument("--size: '" + options.size + "' is not WIDTHxHEIGHT, such as 346x260");
  }
  v1::View view;
  view.set_width(width);
  view.set_height(height);
  if (options.fov_x_deg) view.set_fov_x_deg(*options.fov_x_deg);
  return view;
}

v1::Method makeMethod(const RecordOptions& options) {
  v1::Method method;
  method.set_name(options.method);
  method.set_spp(options.spp.value_or(0));
  for (const std::string& param : options.params) {
    const std::size_t equals = std::min(param.find('='), param.size());
    const char *begin = param.data() + std::min(equals + 1, param.size()), *end = param.data() + param.size();
    double value = 0;
    const auto [rest, error] = std::from_chars(begin, end, value);
    if (equals == 0 || rest != end || error != std::errc()) {
      throw std::invalid_argument("--set: '" + param + "' is not NAME=NUMBER");
    }
    (*method.mutable_params())[param.substr(0, equals)] = value;
  }
  return method;
}

v1::Sensor makeSensor(const RecordOptions& options, std::size_t index) {
  v1::Sensor sensor;
  const auto& off = options.thresholds_off;
  if (!options.thresholds.empty()) sensor.set_threshold(options.thresholds[index]);
  if (!off.empty()) sensor.set_threshold_off(off[off.size() == 1 ? 0 : index]);
  if (options.bias) sensor.set_bias(*options.bias);
  if (options.refractory_s) sensor.set_refractory_s(*options.refractory_s);
  if (options.model.empty()) return sensor;
  v1::EventModel model;
  setEnum(v1::EventModel_Parse, "EVENT_MODEL_", options.model, model);
  sensor.set_model(model);
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

std::string checkPng(const std::string& path) {
  return path.ends_with(".png") ? "" : "'" + path + "' is no .png file";
}

}  // namespace

void addRecordOptions(CLI::App& command, RecordOptions& o) {
  addControlOption(command, o.control);
  command.add_option("scene", o.scene, "name of a scene, see `saccade list`")->required();
  command.add_option("--trajectory", o.trajectory, "a trajectory of the scene, or a TUM or ESIM file")
      ->required();
  command.add_option("-o,--output", o.output, "file to write: " + writerNames())->required();
  command.add_option("--threshold", o.thresholds, "contrast threshold C; give it again for another sensor")
      ->allow_extra_args(false)
      ->delimiter(',');
  command
      .add_option("--threshold-off", o.thresholds_off, "C of OFF events: one for all sensors, or one each")
      ->allow_extra_args(false)
      ->delimiter(',');
  command.add_option("--bias", o.bias, "I_eps, in scene luminance");
  command.add_option("--refractory", o.refractory_s, "seconds a pixel is blind after an event");
  command.add_option("--model", o.model, "event model")
      ->check(CLI::IsMember({"accumulating", "probabilistic"}));
  command.add_option("--size", o.size, "WIDTHxHEIGHT in pixels")->capture_default_str();
  command.add_option("--fov", o.fov_x_deg, "horizontal field of view, degrees");
  command.add_option("--rate", o.rate_hz, "frames per second of stream time")->capture_default_str();
  command.add_option("--duration", o.duration_s, "seconds of stream time; 0: until Ctrl-C")
      ->capture_default_str();
  command
      .add_option("--delivery", o.delivery,
                  "what happens when this client is slow: wait, drop the oldest, drop any")
      ->check(CLI::IsMember({"lossless", "live", "broadcast"}))
      ->capture_default_str();
  command.add_option("--clock", o.clock, "as fast as can be, or in step with the wall clock")
      ->check(CLI::IsMember({"fast", "paced"}))
      ->capture_default_str();
  command.add_option("--method", o.method, "see `saccade info`");
  command.add_option("--spp", o.spp, "paths per pixel and frame");
  command.add_option("--bounces", o.bounces, "indirect bounces");
  command.add_option("--set", o.params, "NAME=NUMBER, a parameter of the method; may be given again")
      ->allow_extra_args(false);
  command.add_option("--seed", o.seed, "of all random numbers")->capture_default_str();
  command
      .add_option("--preview", o.preview, "PNG of brightness, its change and the events, half way through")
      ->check(CLI::Validator(checkPng, "FILE.png"));
}

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
  if (options.bounces) open.mutable_quality()->set_bounces(*options.bounces);
  for (std::size_t i = 0; i < sensors; ++i) *open.add_sensors() = makeSensor(options, i);
  v1::Delivery delivery;
  setEnum(v1::Delivery_Parse, "DELIVERY_", options.delivery, delivery);
  open.set_delivery(delivery);
  open.set_seed(options.seed);
  return open;
}

}  // namespace saccade
