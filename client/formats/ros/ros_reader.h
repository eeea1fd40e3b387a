// Reads the events of one topic of a bag or an MCAP file.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "client/formats/common/reader.h"
#include "client/formats/ros/ros_source.h"

namespace saccade::client {

// Decodes messages of one type. Throws std::runtime_error for one that is not of it.
class EventMessageDecoder {
 public:
  virtual ~EventMessageDecoder() = default;
  // Turns to a message, which stays where it is until its end. Returns the size of the image; 0: not told.
  virtual ImageSize begin(std::string_view message) = 0;
  // Appends its next events, a bounded number; false: there are no more.
  virtual bool append(Events& events) = 0;
};

class RosReader final : public Reader {
 public:
  // `path` for errors. Throws FileFault if there is no topic of events, and std::invalid_argument if not the
  // one that is asked for.
  RosReader(const std::string& path, std::unique_ptr<RosSource> source,
            std::unique_ptr<EventMessageDecoder> decoder, const SensorChoice& choice);

  ImageSize size() const override { return size_; }
  std::uint32_t sensor() const override { return sensor_; }
  std::string name() const override { return source_->topics()[topic_].name; }
  std::string leftOut() const override;
  bool read(Events& events) override;

 private:
  bool nextMessage();

  const std::string path_;
  const std::unique_ptr<RosSource> source_;
  const std::unique_ptr<EventMessageDecoder> decoder_;
  std::uint32_t sensor_;  // number among the topics of events
  std::size_t topic_;     // in source_->topics()
  ImageSize size_;
  bool more_;  // whether the decoder has a message
};

}  // namespace saccade::client
