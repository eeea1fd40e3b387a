#include "client/recording/sidecar.h"

#include <google/protobuf/util/json_util.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include "client/formats/common/output_file.h"
#include "client/formats/common/reader.h"
#include "client/recording/json_text.h"

namespace saccade::client {

std::string sidecarOf(const std::string& path) {
  return path + ".json";
}

void writeSidecar(const std::string& file, const v1::Recording& recording) {
  OutputFile output(file);
  output.append(jsonText(recording, true));
  output.close();
}

v1::Recording readSidecar(const std::string& file) {
  if (std::filesystem::is_directory(file))
    throw std::system_error(EISDIR, std::generic_category(), file);  // a stream of it throws without its name
  std::ifstream input(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(input), {}};
  if (!input) throw std::system_error(errno, std::generic_category(), file);
  v1::Recording recording;
  const auto status = google::protobuf::util::JsonStringToMessage(text, &recording);
  if (!status.ok())
    throw FileFault(file, "is not the description of a recording: " + std::string(status.message()));
  return recording;
}

std::optional<v1::Recording> recordingOf(const std::string& path) {
  const std::string file = sidecarOf(path);
  if (!std::filesystem::exists(file)) return std::nullopt;
  return readSidecar(file);
}

}  // namespace saccade::client
