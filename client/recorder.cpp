#include "client/recorder.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>

namespace saccade::client {
namespace {

std::string fileOf(const std::string& path, int sensor, int sensors) {
  if (sensors == 1) return path;
  std::filesystem::path file(path);
  const std::string extension = file.extension();
  file.replace_extension();
  return file.string() + "-" + std::to_string(sensor) + extension;
}

}  // namespace

Recorder::Recorder(const std::string& path, int sensors) {
  const WriterInfo& format = writerFor(path);
  for (int i = 0; i < sensors; ++i) {
    const std::string file = fileOf(path, i, sensors);
    if (std::filesystem::is_directory(file)) throw std::system_error(EISDIR, std::generic_category(), file);
    const std::string partial = file + ".partial";
    outputs_.push_back({file, partial, format.make(partial)});
  }
}

void Recorder::add(const Batch& batch) {
  if (batch.header.sensor() >= outputs_.size()) throw StreamFault("a packet is of a sensor nobody asked for");
  if (batch.header.kind() == v1::KIND_HEARTBEAT) return;  // tells what was rendered, not what came
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
