#include "client/recorder.h"

#include <algorithm>
#include <filesystem>

namespace saccade::client {

std::vector<std::string> outputFiles(const std::string& path, int sensors) {
  if (sensors == 1) return {path};
  std::filesystem::path stem(path);
  const std::string extension = stem.extension();
  stem.replace_extension();
  std::vector<std::string> files;
  for (int i = 0; i < sensors; ++i) files.push_back(stem.string() + "-" + std::to_string(i) + extension);
  return files;
}

Recorder::Recorder(const std::string& path, const v1::StreamOpened& stream) {
  const WriterInfo& format = writerFor(path);
  for (const std::string& file : outputFiles(path, stream.resolved().sensors_size())) {
    const std::string now = file == kStandardOutput ? file : file + ".partial";
    outputs_.push_back({file, now, format.make(now, stream, static_cast<int>(outputs_.size()))});
  }
}

void Recorder::add(const Batch& batch) {
  if (batch.header.sensor() >= outputs_.size())
    throw StreamFault("a packet is of a sensor that the stream does not have");
  if (batch.header.kind() == v1::KIND_HEARTBEAT)
    return;  // its time is that of rendering, not of what has arrived
  if (!begin_ns_) begin_ns_ = batch.header.t0_ns();
  Output& output = outputs_[batch.header.sensor()];
  output.writer->write(batch.events);
  output.time_ns = std::max(output.time_ns, batch.header.t1_ns());
  output.ended |= batch.header.kind() == v1::KIND_END;
  events_ += batch.events.size();
  suppressed_ += batch.header.suppressed();
}

bool Recorder::complete() const {
  return std::all_of(outputs_.begin(), outputs_.end(), [](const Output& o) { return o.ended; });
}

void Recorder::commit() {
  for (Output& output : outputs_) {
    output.writer->finish();
    if (output.now == output.file) continue;
    std::filesystem::rename(output.now, output.file);
    output.now = output.file;
  }
}

std::int64_t Recorder::time_ns() const {
  return std::min_element(outputs_.begin(), outputs_.end(),
                          [](const Output& a, const Output& b) { return a.time_ns < b.time_ns; })
      ->time_ns;
}

std::int64_t Recorder::duration_ns() const {
  return std::max<std::int64_t>(0, time_ns() - begin_ns_.value_or(0));
}

std::vector<std::string> Recorder::files() const {
  std::vector<std::string> names;
  for (const Output& output : outputs_) names.push_back(output.now);
  return names;
}

}  // namespace saccade::client
