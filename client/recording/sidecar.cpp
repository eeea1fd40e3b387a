#include "client/recording/sidecar.h"

#include <google/protobuf/util/json_util.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include "client/formats/common/output_file.h"
#include "client/formats/common/reader.h"

namespace saccade::client {

std::string sidecarOf(const std::string& path) {
  return path + ".json";
}

void writeSidecar(const std::string& file, const v1::Recording& recording) {
  google::protobuf::util::JsonPrintOptions options;
  options.add_whitespace = true;
  options.always_print_primitive_fields = true;
  options.preserve_proto_field_names = true;
  std::string text;
  if (!google::protobuf::util::MessageToJsonString(recording, &text, options).ok())
    throw std::logic_error("a recording has no JSON form");
  OutputFile output(file);
  output.append(text);
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
