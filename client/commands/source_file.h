// A file of events that a command reads, with what FILE.json says of it, or FILE.sensor1.json of sensor 1.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "client/commands/reading_options.h"
#include "client/formats/common/event_check.h"
#include "client/formats/common/event_sorter.h"
#include "client/formats/common/reader.h"
#include "client/options/event_facts.h"
#include "saccade/v1/recording.pb.h"

namespace saccade::client {

class SourceFile {
 public:
  // `size`: --size of the command, for the image where neither the file nor its description tells its size.
  // It is "WIDTHxHEIGHT" or empty; nothing: the command has no such option, and compares with the
  // description. Throws std::invalid_argument if the size is missing or contradicts them, std::runtime_error
  // if there is nothing to compare with, and as openReader(). Says on stderr what of the file is left out;
  // the labels and objects of events are, unless `kept`. Says what was assumed too, where there is no
  // description.
  SourceFile(const std::string& path, const std::optional<std::string>& size, const EventFacts& kept,
             const ReadingOptions& options = {});

  // Replaces `events` by the next batch; false at the end. Throws FileFault for events that no sensor of this
  // size sends.
  bool read(Events& events);

  // After the end: what was changed, a line for each option; empty: nothing.
  std::string changes() const;

  const std::string& path() const { return path_; }
  const std::string& description() const { return description_; }  // the name of that JSON
  const ImageSize& size() const { return size_; }
  EventFacts facts() const { return {reader_->labels(), reader_->objects()}; }  // that its events have
  const std::optional<v1::Recording>& recording() const { return recording_; }  // if there is that JSON

 private:
  void sayLeftOut(const EventFacts& kept) const;
  void sayAssumed(const std::optional<std::string>& size) const;
  void crop(Events& events);
  bool readSorted(Events& events);

  const std::string path_;
  const ReadingOptions options_;
  std::unique_ptr<Reader> reader_;
  const std::string description_;
  std::optional<v1::Recording> recording_;
  ImageSize size_;
  EventCheck check_;
  std::optional<EventSorter> sorter_;  // with --sort
  bool ended_ = false;
  std::uint64_t cropped_ = 0;  // events
};

}  // namespace saccade::client
