// A file of events that a command reads, with what FILE.json says of it.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "client/formats/common/event_check.h"
#include "client/formats/common/reader.h"
#include "saccade/v1/recording.pb.h"

namespace saccade::client {

class SourceFile {
 public:
  // `size`: --size of the command, for the image where neither the file nor FILE.json tells its size. It is
  // "WIDTHxHEIGHT" or empty; nothing: the command has no such option. Throws std::invalid_argument if the
  // size is missing or contradicts them, and as Reader does. Says on stderr what of the file is left out; the
  // labels of events are, unless `labels`.
  SourceFile(const std::string& path, const std::optional<std::string>& size, bool labels);

  // Replaces `events` by the next batch; false at the end. Throws FileFault for events that no sensor of this
  // size sends.
  bool read(Events& events);

  const std::string& path() const { return path_; }
  const ImageSize& size() const { return size_; }
  bool labels() const { return reader_->labels(); }  // whether its events have some
  const std::optional<v1::Recording>& recording() const { return recording_; }  // FILE.json, if there is one

 private:
  const std::string path_;
  std::unique_ptr<Reader> reader_;
  std::optional<v1::Recording> recording_;
  ImageSize size_;
  EventCheck check_;
};

}  // namespace saccade::client
