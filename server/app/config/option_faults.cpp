#include "app/config/option_faults.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <string_view>

#include "base/instruction_set.h"
#include "scene/files/search_folders.h"

namespace saccade {
namespace {

namespace fs = std::filesystem;

std::string inQuotes(const fs::path& path) {
  return "'" + path.string() + "'";
}

// Whether the text ends with a port from 0 to 65535, or with * for a free one. ZeroMQ takes the last 16 bits
// of any number.
bool hasPort(std::string_view text) {
  const std::string_view port = text.substr(text.rfind(':') + 1);
  unsigned number = 0;
  const auto [end, fault] = std::from_chars(port.begin(), port.end(), number);
  return port == "*" || (fault == std::errc() && end == port.end() && number <= 65535);
}

}  // namespace

std::string endpointFault(const std::string& text) {
  if (text.starts_with("ipc://") || (text.starts_with("tcp://") && hasPort(text))) return {};
  return inQuotes(text) + " is not an endpoint such as tcp://127.0.0.1:5770";
}

std::string httpFault(const std::string& text) {
  if (text == "off" || (text.starts_with("http://") && hasPort(text))) return {};
  return inQuotes(text) + " is neither off nor an address such as http://127.0.0.1:5773";
}

std::string foldersFault(const std::string& list) {
  for (const fs::path& folder : splitFolders(list))
    if (!fs::is_directory(folder)) return "there is no folder " + inQuotes(folder);
  return {};
}

std::string instructionsFault(const std::string& name) {
  const auto at = std::find(kInstructionSetNames.begin(), kInstructionSetNames.end(), name);
  const auto set = static_cast<InstructionSet>(at - kInstructionSetNames.begin());
  const bool lacks = at != kInstructionSetNames.end() && set > widestInstructionSet();
  return lacks ? "this processor has no " + name : "";
}

}  // namespace saccade
