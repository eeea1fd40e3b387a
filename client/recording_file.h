// A file of events of one sensor, and FILE.json beside it. It is called FILE.partial until it is complete.
// Truth channels are in the file, or in the folder FILE.truth where the format does not hold them.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "client/event_digest.h"
#include "client/writers/truth_folder.h"
#include "client/writers/writer.h"

namespace saccade::client {

class RecordingFile {
 public:
  // Starts FILE.partial, or standard output, which gets no JSON. `about` has all fields that are known now:
  // the interval and the counts are filled in. Throws as WriterInfo::make() does.
  RecordingFile(const std::string& path, const WriterInfo& format, v1::Recording about);
  // A file without commit() stays FILE.partial, and can be read too.
  ~RecordingFile();
  RecordingFile(const RecordingFile&) = delete;
  RecordingFile& operator=(const RecordingFile&) = delete;

  // Adds the events of [t0_ns, until_ns). Throws std::system_error.
  void write(const Events& events, std::int64_t t0_ns, std::int64_t until_ns);
  // Adds samples of about().truth(channel). Throws std::runtime_error.
  void writeTruth(int channel, const TruthSamples& samples);
  v1::Recording& about() { return about_; }
  const v1::Recording& about() const { return about_; }

  void close();  // ends the events and fills in the digest; throws std::system_error
  // After close(): gives the file its name. Throws std::system_error; the file then stays FILE.partial.
  void commit();
  const std::string& name() const { return name_; }  // the present one
  std::string truthPlace() const;                    // "FILE", "FILE.truth", or both with a blank between

 private:
  const std::string path_;
  std::string name_;
  v1::Recording about_;
  EventDigest digest_;
  std::unique_ptr<Writer> writer_;           // none once the file is closed
  std::optional<TruthFolder> truth_folder_;  // of channels that the format does not hold
  bool begun_ = false;
};

}  // namespace saccade::client
