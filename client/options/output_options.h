// The options for files that a command writes. Finds before any work that they cannot be written.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "client/formats/common/writer.h"

namespace saccade::client {

struct OutputOptions {
  std::string path = {};    // a file, or kStandardOutput
  std::string format = {};  // WriterInfo::name, or empty: by the extension
  bool force = false;       // existing files may be replaced

  const WriterInfo& writer() const { return writerFor(path, format); }
};

// `name`: of the option that takes the path, "-o,--output" or "output".
void addOutputOptions(CLI::App& command, OutputOptions& options, const std::string& name);

// Throws std::invalid_argument with the option and the reason if a file of `sensors` sensors, or its JSON,
// cannot be written.
void checkOutputs(const OutputOptions& options, int sensors);

// The same for one file, which `option` names.
void checkOutput(const std::string& option, const std::string& path, bool force);

}  // namespace saccade::client
