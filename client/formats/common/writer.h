// A writer puts the events of one sensor into a file of one format, which it may share with other writers.
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "client/formats/common/output_file.h"
#include "saccade/v1/recording.pb.h"
#include "saccade/wire/event.h"
#include "saccade/wire/truth_samples.h"

namespace saccade::client {

// Every call throws std::system_error with the file's name when the file cannot be written.
class Writer {
 public:
  virtual ~Writer() = default;
  // Adds a batch, and says that no event before `until_ns` will follow. Batches come in time order, and their
  // events lie within the image. If this throws, readers find the earlier batches and no part of this one.
  // Readers of a format of large chunks find whole chunks instead, see kept(). Throws std::range_error if the
  // format cannot hold a time.
  virtual void write(const Events& events, std::int64_t until_ns) = 0;
  // Adds samples of Recording.truth[channel], in time order. Only of channels that WriterInfo::truth takes.
  virtual void writeTruth(int channel, const TruthSamples& samples) {
    throw std::logic_error("no truth: channel " + std::to_string(channel) + " has " +
                           std::to_string(samples.size()) + " samples");
  }
  virtual void finish() = 0;  // the file is complete and closed; nothing is written after it
  // How many events readers find in the file after finish(), though it or a call before it threw. `written`:
  // in all batches whose write() did not throw.
  virtual std::uint64_t kept(std::uint64_t written) const { return written; }
};

using Writers = std::vector<std::unique_ptr<Writer>>;

struct WriterInfo {
  const char* name;       // "evt3"
  const char* extension;  // ".raw"
  const char* description;
  // Starts a file at `path`, which may have any extension. `about` says what is known before the first event:
  // the size of the image, the truth channels, and the request where there is one. Throws
  // std::invalid_argument if the format cannot hold such events.
  std::unique_ptr<Writer> (*make)(const std::string& path, const v1::Recording& about);
  bool pipe = false;  // whether `path` may be kStandardOutput
  // Whether the file holds a truth channel; nullptr: it holds none.
  bool (*truth)(const v1::RecordedTruth& channel) = nullptr;
  bool labels = false;  // whether the file holds the labels of events, see Recording.labels
  // Starts one file for several sensors of a stream, and returns a writer for each. The file is complete when
  // all of them are finished. Throws as make(). nullptr: each sensor needs a file of its own.
  Writers (*makeJoint)(const std::string& path, const std::vector<v1::Recording>& sensors) = nullptr;
  bool wraps = false;    // its times wrap: it holds none that begin far from 0
  bool objects = false;  // whether the file holds the objects of events, see Recording.object_ids
};

// All file formats. The first of an extension is the one that it stands for.
const std::vector<const WriterInfo*>& writerTable();
std::string writerNames();        // ".csv csv (what it is), ..." for messages
std::string writerExtensions();   // ".csv, ..."
std::string labelWriterNames();   // ".npz npz, ...": the formats that hold labels
std::string objectWriterNames();  // likewise: that hold objects

// The format `name`, or without a name that of the extension of `path`; CSV for kStandardOutput. Throws
// std::invalid_argument with the known formats, also where the name has another extension than `path`.
const WriterInfo& writerFor(const std::string& path, const std::string& name = "");

}  // namespace saccade::client
