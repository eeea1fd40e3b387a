#include "client/commands/source_file.h"

#include <cstdio>
#include <filesystem>

#include "client/commands/console.h"
#include "client/commands/request_text.h"
#include "client/formats/truth_folder/truth_folder.h"
#include "client/recording/sidecar.h"

namespace saccade::client {
namespace {

ImageSize sizeOf(const std::string& path, const ImageSize& in_file,
                 const std::optional<v1::Recording>& recording, const std::optional<std::string>& given) {
  ImageSize size = in_file;
  if (size.width == 0 && recording) size = {recording->width(), recording->height()};
  if (!given && size.width == 0)
    throw std::invalid_argument("'" + path + "' does not tell the size of the image, nor does " +
                                sidecarOf(path));
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

SourceFile::SourceFile(const std::string& path, const std::optional<std::string>& size, bool labels)
    : path_(path),
      reader_(readerFor(path).make(path)),
      recording_(recordingOf(path)),
      size_(sizeOf(path, reader_->size(), recording_, size)),
      check_(path, size_) {
  std::string left_out = reader_->leftOut();
  const auto leaveOut = [&](const std::string& what) { left_out += (left_out.empty() ? "" : ", ") + what; };
  if (reader_->labels() && !labels) leaveOut("the labels of the events");
  if (std::filesystem::is_directory(truthFolderOf(path))) leaveOut(truthFolderOf(path));
  if (!left_out.empty())
    print(stderr, "saccade: %s: the events of one stream are read; left out: %s\n", path.c_str(),
          left_out.c_str());
}

bool SourceFile::read(Events& events) {
  if (!reader_->read(events)) return false;
  check_.check(events);
  return true;
}

}  // namespace saccade::client
