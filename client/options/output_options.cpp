#include "client/options/output_options.h"

#include <unistd.h>

#include <filesystem>
#include <stdexcept>

#include "client/recording/recorder.h"
#include "client/recording/sidecar.h"

namespace saccade::client {

namespace fs = std::filesystem;

void checkOutput(const std::string& option, const std::string& path, bool force) {
  const fs::path file = path;
  const auto fail = [&](const std::string& what) { throw std::invalid_argument(option + ": " + what); };
  const std::string name = "'" + file.string() + "'";
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  std::error_code fault;
  if (!fs::is_directory(folder, fault)) fail(name + ": there is no folder '" + folder.string() + "'");
  if (access(folder.c_str(), W_OK) != 0)
    fail(name + ": the folder '" + folder.string() + "' cannot be written");
  const fs::file_status status = fs::status(file, fault);
  if (!fs::exists(status)) return;
  if (fs::is_directory(status)) fail(name + " is a folder");
  if (!fs::is_regular_file(status)) fail(name + " is not a regular file; -o - writes to a pipe");
  if (!force) fail(name + " exists; --force replaces it");
}

void checkOutputs(const OutputOptions& options, int sensors) {
  if (options.path == kStandardOutput) {
    if (sensors > 1)
      throw std::invalid_argument("--output: standard output takes the events of one sensor only");
    return;
  }
  for (const RecordingPlace& place : recordingPlaces(options.path, options.writer(), sensors)) {
    checkOutput("--output", place.file, options.force);
    if (isBeingWritten(partialOf(place.file)))
      throw std::invalid_argument("--output: '" + partialOf(place.file) +
                                  "' is being written by another program");
    checkOutput("--output", sidecarOf(place.name), options.force);
  }
}

void addOutputOptions(CLI::App& command, OutputOptions& options, const std::string& name) {
  command
      .add_option(name, options.path,
                  "file to write, in the format of its extension: " + writerExtensions() +
                      "; - writes CSV to standard output")
      ->required();
  command.add_option("--format", options.format,
                     "name of the format, where an extension has several: " + writerNames());
  command.add_flag("--force", options.force, "replace files that exist");
}

}  // namespace saccade::client
