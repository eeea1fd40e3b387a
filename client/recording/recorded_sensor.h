// The events and truth of one sensor in a file, which it may share with other sensors, and NAME.json about
// them. Truth channels are in the file, or in the folder NAME.truth where the format does not hold them.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/formats/common/writer.h"
#include "client/formats/truth_folder/truth_folder.h"
#include "client/recording/event_digest.h"

namespace saccade::client {

class RecordedSensor {
 public:
  // `name`: the present one of JSON and folder, without their extensions. `about` has all fields that are
  // known now: the interval and the counts are filled in.
  RecordedSensor(const std::string& name, const WriterInfo& format, std::unique_ptr<Writer> writer,
                 v1::Recording about);
  ~RecordedSensor();  // as endAnyway()
  RecordedSensor(const RecordedSensor&) = delete;
  RecordedSensor& operator=(const RecordedSensor&) = delete;

  // Adds the events of [t0_ns, until_ns). Throws std::system_error.
  void write(const Events& events, std::int64_t t0_ns, std::int64_t until_ns);
  // Adds samples of about().truth(channel). Throws std::runtime_error.
  void writeTruth(int channel, const TruthSamples& samples);
  v1::Recording& about() { return about_; }
  const v1::Recording& about() const { return about_; }

  void close();  // ends the events and fills in the digest; throws std::system_error
  // After a fault: ends the events as well as can be.
  void endAnyway();
  // After that: how many events readers find in the file. All sensors of a file are to be ended before.
  std::uint64_t kept() const { return writer_->kept(about_.events()); }
  // After close(): writes the JSON, and renames the folder. Throws std::system_error.
  void commit(const std::string& name);

  // Where the truth is: `file`, which has the events, or the folder, or both; empty without truth. `name`: as
  // of the constructor, the present one or another.
  std::vector<std::string> truthPlaces(const std::string& file, const std::string& name) const;
  const std::string& name() const { return name_; }  // the present one

 private:
  std::string name_;
  v1::Recording about_;
  EventDigest digest_;
  std::unique_ptr<Writer> writer_;
  std::optional<TruthFolder> truth_folder_;  // of channels that the format does not hold
  bool begun_ = false, ended_ = false;
};

}  // namespace saccade::client
