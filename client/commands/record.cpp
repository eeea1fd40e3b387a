// saccade record: opens a stream and writes its events to files.
#include <memory>
#include <set>

#include "client/commands/commands.h"
#include "client/commands/record_stream.h"
#include "client/options/help_formatter.h"
#include "client/options/record_options.h"
#include "client/terminal/console.h"

namespace saccade::client {
namespace {

void addHelp(CLI::App& command) {
  std::set<std::string> common{"--output", "--force", "--preview", "--truth"};
  common.insert(commonRequestOptions().begin(), commonRequestOptions().end());
  showInHelp(command, common);
  command.footer(
      std::string(kMotionHelp) +
      "\nKeep the image motion below half a pixel per frame: `record` warns, and names a --rate.\n\n"
      "Options without a default here have the server's default. FILE is called FILE.partial until it is "
      "complete.\n"
      "`record` reconnects to a lost server and resumes; a lossless recording misses nothing.\n"
      "Exit codes: 0 recorded, 1 the stream or the server failed, 2 wrong usage.\n\n"
      "Example: saccade record cornell-box --trajectory right -o events.csv --preview events.png");
}

void runRecord(const RecordOptions& options) {
  const RecordJob job = makeRecordJob(options);
  const std::string note = sizeNote(options.request.camera);
  if (!note.empty()) print(stderr, "saccade: %s\n", note.c_str());
  recordStream(options.request.server, job);
}

}  // namespace

void addRecordCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("record", "open a stream and write its events to files");
  const auto options = std::make_shared<RecordOptions>();
  addRecordOptions(*command, *options);
  addHelp(*command);
  command->callback([options] { runRecord(*options); });
}

}  // namespace saccade::client
