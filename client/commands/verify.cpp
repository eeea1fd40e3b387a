// saccade verify: compares a file of events with what FILE.json says of it.
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "client/commands/commands.h"
#include "client/commands/source_file.h"
#include "client/recording/event_digest.h"
#include "client/terminal/console.h"

namespace saccade::client {
namespace {

struct VerifyOptions {
  std::string file;
  ReadingOptions reading;
};

void runVerify(const VerifyOptions& options) {
  SourceFile source(options.file, std::nullopt, {}, options.reading);
  const std::string &path = source.path(), &description = source.description();
  const v1::Recording& expected = *source.recording();
  EventDigest digest;
  std::uint64_t count = 0;
  for (Events events; source.read(events);) {
    digest.add(events);
    count += events.size();
  }
  if (count != expected.events())
    throw std::runtime_error(path + ": has " + std::to_string(count) + " events, not " +
                             std::to_string(expected.events()) + " as " + description + " says");
  if (digest.hex() != expected.digest())
    throw std::runtime_error(path + ": the events are not those that " + description + " describes");
  print("%s: all %llu events are as recorded\n", path.c_str(), static_cast<unsigned long long>(count));
}

}  // namespace

void addVerifyCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("verify", "compare a file of events with its FILE.json");
  const auto options = std::make_shared<VerifyOptions>();
  command->add_option("file", options->file, "file to read: " + readerNames())->required();
  addColumnOptions(*command, options->reading.columns);
  addSensorOptions(*command, options->reading.sensor);
  command->callback([options] { runVerify(*options); });
}

}  // namespace saccade::client
