#include "client/commands/output_check.h"

#include <unistd.h>

#include <filesystem>
#include <stdexcept>

#include "client/recorder.h"

namespace saccade::client {
namespace {

namespace fs = std::filesystem;

void checkFile(const std::string& option, const fs::path& file, bool force) {
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

}  // namespace

void checkOutputs(const RecordOptions& options, int sensors) {
  writerFor(options.output);
  if (!options.preview.empty()) checkFile("--preview", options.preview, options.force);
  if (options.output == kStandardOutput) {
    if (sensors > 1)
      throw std::invalid_argument("--output: standard output takes the events of one sensor only");
    return;
  }
  for (const std::string& file : outputFiles(options.output, sensors))
    checkFile("--output", file, options.force);
}

}  // namespace saccade::client
