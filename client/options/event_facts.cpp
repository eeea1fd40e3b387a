#include "client/options/event_facts.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace saccade::client {

void addEventFacts(CLI::App& command, EventFacts& facts) {
  command
      .add_flag(
          "--labels", facts.labels,
          "record of each event whether it is noise, and its odds to be an artefact of rendering; for " +
              labelWriterNames())
      ->group("Sensors");
  command
      .add_flag(
          "--object-ids", facts.object_ids,
          "record of each event the number of the object that its pixel shows; for " + objectWriterNames())
      ->group("Sensors");
}

void requestEventFacts(const EventFacts& facts, v1::OpenStream& request) {
  for (v1::Sensor& sensor : *request.mutable_sensors()) {
    if (facts.labels) sensor.set_labels(true);
    if (facts.object_ids) sensor.set_object_ids(true);
  }
}

void checkEventFacts(const OutputOptions& options, const v1::OpenStream& request) {
  const WriterInfo& writer = options.writer();
  const auto refuse = [&](const std::string& what, const std::string& names) {
    throw std::invalid_argument("--output: the format " + std::string(writer.name) + " does not hold the " +
                                what + " of events; those that do are " + names);
  };
  const auto& sensors = request.sensors();
  if (!writer.labels && std::ranges::any_of(sensors, &v1::Sensor::labels))
    refuse("labels", labelWriterNames());
  if (!writer.objects && std::ranges::any_of(sensors, &v1::Sensor::object_ids))
    refuse("objects", objectWriterNames());
}

}  // namespace saccade::client
