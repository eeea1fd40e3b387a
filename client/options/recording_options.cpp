#include "client/options/recording_options.h"

#include <utility>

#include "client/options/truth_option.h"

namespace saccade::client {

void addRecordingOptions(CLI::App& command, RecordingOptions& options) {
  const auto fault = [](const std::string& name) {
    return name.ends_with(".png") ? std::string() : "'" + name + "' is not a .png file";
  };
  addOutputOptions(command, options.output, "-o,--output");
  command
      .add_option("--preview", options.preview,
                  "PNG of brightness, its change and the latest events, a third of the way through")
      ->check(CLI::Validator(fault, "FILE.png"));
  addTruthOption(command, options.truth);
  addEventFacts(command, options.facts);
}

RecordJob makeJob(const RecordingOptions& options, v1::OpenStream request) {
  requestTruth(options.truth, request);
  requestEventFacts(options.facts, request);
  checkOutputs(options.output, request.sensors_size());
  checkTruthOutput(options.output, request);
  checkEventFacts(options.output, request);
  if (!options.preview.empty()) checkOutput("--preview", options.preview, options.output.force);
  return {.request = std::move(request),
          .output = options.output.path,
          .format = &options.output.writer(),
          .preview = options.preview};
}

}  // namespace saccade::client
