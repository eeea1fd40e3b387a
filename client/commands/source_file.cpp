#include "client/commands/source_file.h"

#include <cstdio>
#include <filesystem>

#include "client/commands/console.h"
#include "client/commands/request_text.h"
#include "client/formats/truth_folder/truth_folder.h"
#include "client/recording/recording_file.h"
#include "client/recording/sidecar.h"

namespace saccade::client {
namespace {

ImageSize sizeOf(const std::string& path, const std::string& description, const ImageSize& in_file,
                 const std::optional<v1::Recording>& recording, const std::optional<std::string>& given) {
  if (!given && !recording)
    throw std::runtime_error(path + ": there is no " + description + " to compare with");
  ImageSize size = in_file;
  if (size.width == 0 && recording) size = {recording->width(), recording->height()};
  if (!given && size.width == 0)
    throw std::invalid_argument("'" + path + "' does not tell the size of the image, nor does " +
                                description);
  if (!given) return size;
  if (given->empty() && size.width == 0)
    throw std::invalid_argument("--size: '" + path +
                                "' does not tell the size of the image; give WIDTHxHEIGHT");
  if (given->empty()) return size;
  const ImageSize asked = parseSize("--size", *given);
  if (size.width != 0 && (size.width != asked.width || size.height != asked.height))
    throw std::invalid_argument("--size: '" + path + "' has " + std::to_string(size.width) + "x" +
                                std::to_string(size.height) + " pixels");
  return asked;
}

}  // namespace

void addSensorOptions(CLI::App& command, SensorChoice& choice) {
  command.add_option("--sensor", choice.sensor,
                     "number of the sensor in a .bag, .h5 or .mcap file of several, counted from 0");
  command.add_option("--topic", choice.topic,
                     "topic of the sensor in a .bag or .mcap file, instead of --sensor");
}

SourceFile::SourceFile(const std::string& path, const SensorChoice& choice,
                       const std::optional<std::string>& size, bool labels)
    : path_(path),
      reader_(openReader(path, choice)),
      description_(sidecarOf(nameOfSensor(path, reader_->sensor()))),
      recording_(recordingOf(nameOfSensor(path, reader_->sensor()))),
      size_(sizeOf(path, description_, reader_->size(), recording_, size)),
      check_(path, size_) {
  std::string left_out = reader_->leftOut();
  const auto leaveOut = [&](const std::string& what) { left_out += (left_out.empty() ? "" : ", ") + what; };
  if (reader_->labels() && !labels) leaveOut("the labels of the events");
  if (std::filesystem::is_directory(truthFolderOf(path))) leaveOut(truthFolderOf(path));
  if (!left_out.empty())
    print(stderr, "saccade: %s: the events of %s are read; left out: %s\n", path.c_str(),
          reader_->name().c_str(), left_out.c_str());
}

bool SourceFile::read(Events& events) {
  if (!reader_->read(events)) return false;
  check_.check(events);
  return true;
}

}  // namespace saccade::client
