// saccade verify: compares a file of events with what FILE.json says of it.
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "client/commands/commands.h"
#include "client/commands/console.h"
#include "client/commands/source_file.h"
#include "client/recording/event_digest.h"
#include "client/recording/sidecar.h"

namespace saccade::client {
namespace {

void runVerify(const std::string& path) {
  if (!std::filesystem::exists(sidecarOf(path)))
    throw std::runtime_error(path + ": there is no " + sidecarOf(path) + " to compare with");
  SourceFile source(path, std::nullopt, false);
  const v1::Recording& expected = *source.recording();
  EventDigest digest;
  std::uint64_t count = 0;
  for (Events events; source.read(events);) {
    digest.add(events);
    count += events.size();
  }
  if (count != expected.events())
    throw std::runtime_error(path + ": has " + std::to_string(count) + " events, not " +
                             std::to_string(expected.events()) + " as " + sidecarOf(path) + " says");
  if (digest.hex() != expected.digest())
    throw std::runtime_error(path + ": the events are not those that " + sidecarOf(path) + " describes");
  print("%s: all %llu events are as recorded\n", path.c_str(), static_cast<unsigned long long>(count));
}

}  // namespace

void addVerifyCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("verify", "compare a file of events with its FILE.json");
  const auto path = std::make_shared<std::string>();
  command->add_option("file", *path, "file to read: " + readerNames())->required();
  command->callback([path] { runVerify(*path); });
}

}  // namespace saccade::client
