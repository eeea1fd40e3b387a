#include "client/commands/output_check.h"

#include <unistd.h>

#include <filesystem>
#include <stdexcept>

#include "client/recorder.h"
#include "client/sidecar.h"

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

void checkOutputs(const std::string& output, int sensors, bool force) {
  if (output == kStandardOutput) {
    if (sensors > 1)
      throw std::invalid_argument("--output: standard output takes the events of one sensor only");
    return;
  }
  for (const std::string& file : outputFiles(output, sensors)) {
    checkOutput("--output", file, force);
    checkOutput("--output", sidecarOf(file), force);
  }
}

}  // namespace saccade::client
