#include "farm/dataset/json_file.h"

#include <google/protobuf/util/json_util.h>
#include <unistd.h>

#include <cerrno>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

#include "client/formats/common/output_file.h"
#include "client/recording/json_text.h"
#include "farm/dataset/durable.h"

namespace saccade::farm {

std::string jsonOf(const google::protobuf::Message& message) {
  return client::jsonText(message, false);
}

void parseJson(const std::string& text, const std::string& name, google::protobuf::Message& message) {
  const auto status = google::protobuf::util::JsonStringToMessage(text, &message);
  if (!status.ok())
    throw std::runtime_error(name + " is not a " + message.GetDescriptor()->name() + ": " +
                             std::string(status.message()));
}

std::string readText(const std::string& file) {
  std::ifstream input(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(input), {}};
  if (!input || std::filesystem::is_directory(file))
    throw std::system_error(errno ? errno : EISDIR, std::generic_category(), file);
  return text;
}

void writeText(const std::string& file, const std::string& text) {
  const std::string partial = file + "." + std::to_string(getpid()) + ".partial";
  try {
    client::OutputFile output(partial);
    output.append(text);
    output.close();
    flushFile(partial);
    std::filesystem::rename(partial, file);
  } catch (const std::exception&) {
    std::error_code gone;
    std::filesystem::remove(partial, gone);
    throw;
  }
}

}  // namespace saccade::farm
