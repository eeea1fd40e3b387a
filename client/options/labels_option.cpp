#include "client/options/labels_option.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace saccade::client {

void addLabelsOption(CLI::App& command, bool& labels) {
  command
      .add_flag(
          "--labels", labels,
          "record of each event whether it is noise, and its odds to be an artefact of rendering; for " +
              labelWriterNames())
      ->group("Sensors");
}

void requestLabels(v1::OpenStream& request) {
  for (v1::Sensor& sensor : *request.mutable_sensors()) sensor.set_labels(true);
}

void checkLabelsOutput(const OutputOptions& options, const v1::OpenStream& request) {
  const auto& sensors = request.sensors();
  if (options.writer().labels || std::ranges::none_of(sensors, &v1::Sensor::labels)) return;
  throw std::invalid_argument("--output: the format " + std::string(options.writer().name) +
                              " does not hold the labels of events; those that do are " + labelWriterNames());
}

}  // namespace saccade::client
