#include "farm/dataset/json_file.h"

#include <google/protobuf/util/json_util.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

#include "client/recording/json_text.h"
#include "feed/temporary_file.h"

namespace saccade::farm {

std::string jsonLine(const google::protobuf::Message& message) {
  return client::jsonText(message, false) + "\n";
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
  TemporaryFile output(file);
  output.write(text.data(), text.size());
  output.keep();
}

// TemporaryFile puts a point and six letters behind the name.
void removeLeftTexts(const std::string& folder) {
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none)) {
    const std::filesystem::path before = entry.path().stem().extension();
    if (entry.path().extension().string().size() == 7 && (before == ".json" || before == ".jsonl"))
      removeLeftover(entry.path());
  }
}

void writeJson(const std::string& file, const google::protobuf::Message& message) {
  writeText(file, jsonLine(message));
}

}  // namespace saccade::farm
