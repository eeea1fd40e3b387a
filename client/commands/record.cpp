// saccade record: opens a stream and writes its events to files.
#include <memory>

#include "client/commands/commands.h"
#include "client/commands/output_check.h"
#include "client/commands/record_options.h"
#include "client/commands/record_stream.h"

namespace saccade::client {
namespace {

void runRecord(const RecordOptions& options) {
  const RecordJob job{.request = makeOpenStream(options),
                      .output = options.output,
                      .format = &writerFor(options.output, options.format),
                      .preview = options.preview,
                      .trajectory = options.trajectory,
                      .retry_time_s = options.retry_time_s};
  checkOutputs(options.output, job.request.sensors_size(), options.force);
  if (!options.preview.empty()) checkOutput("--preview", options.preview, options.force);
  recordStream(options.server, job);
}

}  // namespace

void addRecordCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("record", "open a stream and write its events to files");
  const auto options = std::make_shared<RecordOptions>();
  addRecordOptions(*command, *options);
  command->callback([options] { runRecord(*options); });
}

}  // namespace saccade::client
