// `saccade-eval sensor` draws the standard curves of an event camera for the settings of a sensor.
#include <cstdio>
#include <filesystem>
#include <memory>

#include "base/names.h"
#include "base/new_folder.h"
#include "eval/bench/arguments.h"
#include "eval/commands/commands.h"
#include "eval/figures/sensor_figure.h"
#include "eval/pictures/text.h"
#include "eval/sensor/sensor_options.h"

namespace saccade::eval {
namespace {

struct CurveOptions {
  SensorOptions sensor;
  std::string size = "64x64", output = "out/sensor";
  std::vector<std::string> curves;
};

SensorSetup setupOf(const CurveOptions& o) {
  const Size size = parseSize(o.size);
  return {configOf(o.sensor), size.width, size.height};
}

std::vector<const SensorCurve*> curvesOf(const CurveOptions& o) {
  std::vector<const SensorCurve*> curves;
  for (const std::string& name : o.curves) {
    curves.push_back(findRow(sensorCurveTable(), name));
    if (curves.back()) continue;
    throw CLI::ValidationError(
        "--curves", "there is no \"" + name + "\"; there are: " + joinRowNames(sensorCurveTable()));
  }
  return curves;
}

// The settings, for the head of a table.
std::string textOf(const SensorSetup& setup) {
  const SensorConfig& c = setup.config;
  std::string text = format("# threshold=%g threshold_off=%g bias=%g refractory_s=%g size=%dx%d", c.threshold,
                            c.threshold_off, c.bias, seconds(c.refractory), setup.width, setup.height);
  for (const NoiseField& field : noiseFields()) text += format(" %s=%g", field.name, c.noise.*field.value);
  return text + " model=" + c.model + "\n";
}

void runCurves(const CurveOptions& o) {
  const SensorSetup setup = setupOf(o);
  const auto curves = curvesOf(o);
  const std::filesystem::path folder(o.output);
  std::filesystem::create_directories(folder);
  for (const SensorCurve* curve : curves) {
    const SensorFigure figure = curve->make(setup);
    const std::string file = (folder / curve->name).string();
    writeText(file + ".csv", textOf(setup) + figure.csv);
    writeText(file + ".svg", drawCharts(figure.panels, static_cast<int>(figure.panels.size())));
    std::printf("%swrote %s.csv and %s.svg\n", figure.summary.c_str(), file.c_str(), curve->name);
    std::fflush(stdout);
  }
}

}  // namespace

void addSensorCommand(CLI::App& app) {
  auto o = std::make_shared<CurveOptions>();
  std::string curves;
  for (const SensorCurve& curve : sensorCurveTable()) {
    o->curves.emplace_back(curve.name);
    curves += std::string(curves.empty() ? "" : "; ") + curve.name + ": " + curve.what;
  }
  auto* c = app.add_subcommand(
      "sensor", "draw the standard curves of an event camera for a sensor, each as a table and a picture");
  addSensorOptions(*c, o->sensor);
  c->add_option("--size", o->size, "WIDTHxHEIGHT, pixels to measure")->capture_default_str();
  c->add_option("--curves", o->curves, curves)->delimiter(',')->capture_default_str();
  c->add_option("-o,--output", o->output, "folder for the tables and pictures")
      ->check(CLI::Validator(newFolderFault, ""))
      ->capture_default_str();
  c->callback([o] { runCurves(*o); });
}

}  // namespace saccade::eval
