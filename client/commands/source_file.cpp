#include "client/commands/source_file.h"

#include <cstdio>
#include <filesystem>

#include "client/formats/truth_folder/truth_folder.h"
#include "client/options/request_text.h"
#include "client/recording/recording_file.h"
#include "client/recording/sidecar.h"
#include "client/terminal/console.h"

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

SourceFile::SourceFile(const std::string& path, const std::optional<std::string>& size,
                       const EventFacts& kept, const ReadingOptions& options)
    : path_(path),
      options_(options),
      reader_(openReader(path, options.sensor, &options_.columns)),
      description_(sidecarOf(nameOfSensor(path, reader_->sensor()))),
      recording_(recordingOf(nameOfSensor(path, reader_->sensor()))),
      size_(sizeOf(path, description_, reader_->size(), recording_, size)),
      check_(path, size_, options.mends) {
  if (options.sort_us > 0) sorter_.emplace(path, options.sort_us);
  sayLeftOut(kept);
  if (!recording_) sayAssumed(size);
}

bool SourceFile::read(Events& events) {
  if (!(sorter_ ? readSorted(events) : reader_->read(events))) return false;
  if (!sorter_ && options_.crop) crop(events);
  check_.check(events);
  return true;
}

std::string SourceFile::changes() const {
  std::string changes;
  if (options_.crop)
    changes = std::to_string(cropped_) + " events outside of the image were left out (--crop)\n";
  if (sorter_)
    changes += std::to_string(sorter_->late()) + " events were late, by at most " +
               textOfUs(sorter_->longestNs()) + ", and are in order now (--sort)\n";
  return changes;
}

void SourceFile::sayLeftOut(const EventFacts& kept) const {
  std::string left_out = reader_->leftOut();
  const auto leaveOut = [&](const std::string& what) { left_out += (left_out.empty() ? "" : ", ") + what; };
  if (reader_->labels() && !kept.labels) leaveOut("the labels of the events");
  if (reader_->objects() && !kept.object_ids) leaveOut("the objects of the events");
  if (std::filesystem::is_directory(truthFolderOf(path_))) leaveOut(truthFolderOf(path_));
  if (!left_out.empty())
    print(stderr, "saccade: %s: the events of %s are read; left out: %s\n", path_.c_str(),
          reader_->name().c_str(), left_out.c_str());
}

void SourceFile::sayAssumed(const std::optional<std::string>& size) const {
  const std::string assumed = reader_->assumed();
  if (assumed.empty()) return;
  const bool given = reader_->size().width == 0 && size && !size->empty();
  print(stderr, "saccade: %s: read %s, size %ux%u from %s\n", path_.c_str(), assumed.c_str(), size_.width,
        size_.height, given ? "--size" : "the file");
}

void SourceFile::crop(Events& events) {
  cropped_ += std::erase_if(
      events, [&](const Event& event) { return event.x >= size_.width || event.y >= size_.height; });
}

bool SourceFile::readSorted(Events& events) {
  if (ended_) return false;
  ended_ = !reader_->read(events);
  if (options_.crop) crop(events);
  if (ended_)
    sorter_->finish(events);
  else
    sorter_->push(events);
  return true;
}

}  // namespace saccade::client
