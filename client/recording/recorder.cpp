#include "client/recording/recorder.h"

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <utility>

#include "client/recording/truth_description.h"
#include "saccade/stream_fault.h"
#include "saccade/stream_views.h"

namespace saccade::client {
namespace {

bool hasIds(const v1::Recording& about) {
  const auto numbers = [](const v1::RecordedTruth& channel) {
    const std::string& name = channel.info().name();
    return name == "ids" || name.starts_with("object_");
  };
  return about.object_ids() || std::ranges::any_of(about.truth(), numbers);
}

v1::Recording describe(const v1::StreamOpened& stream, const v1::ServerDescription& server, int sensor) {
  v1::Recording about;
  const v1::Sensor& asked = stream.resolved().sensors(sensor);
  const v1::View& view = viewOf(stream.resolved(), asked.view());
  about.set_width(view.width());
  about.set_height(view.height());
  *about.mutable_request() = stream.resolved();
  about.set_sensor(static_cast<std::uint32_t>(sensor));
  about.set_labels(asked.labels());
  about.set_object_ids(asked.object_ids());
  about.set_bake_digest(stream.bake_digest());
  about.set_server_version(server.version());
  about.set_instruction_set(server.instruction_set());
  describeTruth(stream.resolved(), server, about);
  if (hasIds(about)) *about.mutable_id_names() = stream.id_names();
  return about;
}

}  // namespace

std::vector<RecordingPlace> recordingPlaces(const std::string& path, const WriterInfo& format, int sensors) {
  std::filesystem::path stem(path);
  const std::string extension = stem.extension();
  stem.replace_extension();
  const bool one_file = sensors == 1 || format.makeJoint;
  std::vector<RecordingPlace> places;
  for (int i = 0; i < sensors; ++i) {
    const std::string file = stem.string() + "-" + std::to_string(i) + extension;
    places.push_back(one_file ? RecordingPlace{path, nameOfSensor(path, i)} : RecordingPlace{file, file});
  }
  return places;
}

Recorder::Recorder(const std::string& path, const WriterInfo& format, const v1::StreamOpened& stream,
                   const v1::ServerDescription& server) {
  std::vector<v1::Recording> sensors;
  for (int i = 0; i < stream.resolved().sensors_size(); ++i) sensors.push_back(describe(stream, server, i));
  const auto places = recordingPlaces(path, format, stream.resolved().sensors_size());
  if (format.makeJoint) {
    addFile(path, format, std::move(sensors));
  } else {
    for (std::size_t i = 0; i < sensors.size(); ++i) addFile(places[i].file, format, {sensors[i]});
  }
  tellTruth(stream.resolved(), places);
  std::vector<int> channels(outputs_.size());  // so far, by file
  for (int i = 0; i < stream.resolved().truth_size(); ++i) {
    const int sensor = sensorOfTruth(stream.resolved(), i);
    truth_.push_back({sensor, channels[sensor]++});
  }
}

void Recorder::addFile(const std::string& path, const WriterInfo& format,
                       std::vector<v1::Recording> sensors) {
  const std::size_t count = sensors.size();
  RecordingFile& file =
      *files_.emplace_back(std::make_unique<RecordingFile>(path, format, std::move(sensors)));
  for (std::size_t i = 0; i < count; ++i) outputs_.push_back({&file, &file.sensor(i)});
}

void Recorder::setTimeOffset(std::int64_t offset_ns) {
  for (Output& output : outputs_) output.sensor->about().set_time_offset_ns(offset_ns);
}

// Says in each description where the truth of its view will be.
void Recorder::tellTruth(const v1::OpenStream& resolved, const std::vector<RecordingPlace>& places) {
  for (const Output& output : outputs_) {
    v1::Recording& about = output.sensor->about();
    const int first = sensorOfView(resolved, resolved.sensors(static_cast<int>(about.sensor())).view());
    for (const std::string& place :
         outputs_[first].sensor->truthPlaces(places[first].file, places[first].name))
      about.add_truth_places(std::filesystem::path(place).filename());
  }
}

void Recorder::add(const DecodedPacket& batch) {
  const v1::PacketHeader& header = batch.header;
  if (header.sensor() >= outputs_.size() + truth_.size())
    throw StreamFault("a packet is of a sensor that the stream does not have");
  if (header.sensor() >= outputs_.size()) return addTruth(truth_[header.sensor() - outputs_.size()], batch);
  if (header.kind() == v1::KIND_HEARTBEAT) return;  // its time is that of rendering, not of what has arrived
  if (!begin_ns_) begin_ns_ = header.t0_ns();
  Output& output = outputs_[header.sensor()];
  output.sensor->write(batch.events, header.t0_ns(), header.t1_ns());
  output.sensor->about().set_suppressed(output.sensor->about().suppressed() + header.suppressed());
  withheld_ += withheldOf(header);
  output.ended |= header.kind() == v1::KIND_END;
}

void Recorder::addTruth(Truth& truth, const DecodedPacket& batch) {
  RecordedSensor& sensor = *outputs_[truth.sensor].sensor;
  if (!batch.truth.empty()) {
    checkTruthPacket(sensor.about().truth(truth.channel), batch.header);
    sensor.writeTruth(truth.channel, batch.truth);
  }
  truth.ended |= batch.header.kind() == v1::KIND_END;
}

bool Recorder::complete() const {
  const auto ended = [](const auto& channel) { return channel.ended; };
  return std::all_of(outputs_.begin(), outputs_.end(), ended) &&
         std::all_of(truth_.begin(), truth_.end(), ended);
}

void Recorder::commit(std::uint64_t lost_events) {
  for (Output& output : outputs_) output.sensor->about().set_lost_events(lost_events);
  for (const auto& file : files_) {
    file->close();
    file->commit();
  }
}

std::uint64_t Recorder::salvage() {
  std::uint64_t events = 0;
  for (const auto& file : files_) events += file->salvage();
  return events;
}

std::uint64_t Recorder::events() const {
  return std::accumulate(outputs_.begin(), outputs_.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const Output& o) { return sum + o.sensor->about().events(); });
}

std::int64_t Recorder::time_ns() const {
  std::int64_t time_ns = outputs_.front().sensor->about().end_ns();
  for (const Output& output : outputs_) time_ns = std::min(time_ns, output.sensor->about().end_ns());
  return time_ns;
}

std::int64_t Recorder::duration_ns() const {
  return std::max<std::int64_t>(0, time_ns() - begin_ns_.value_or(0));
}

std::vector<v1::RecordedTruth> Recorder::truth() const {
  std::vector<v1::RecordedTruth> all;
  for (const Output& output : outputs_)
    all.insert(all.end(), output.sensor->about().truth().begin(), output.sensor->about().truth().end());
  return all;
}

std::vector<v1::Recording> Recorder::descriptions() const {
  std::vector<v1::Recording> all;
  for (const Output& output : outputs_) all.push_back(output.sensor->about());
  return all;
}

std::string Recorder::truthPlace() const {
  std::vector<std::string> places;
  for (const Output& output : outputs_)
    for (const std::string& place : output.sensor->truthPlaces(output.file->name(), output.sensor->name()))
      if (std::find(places.begin(), places.end(), place) == places.end()) places.push_back(place);
  std::string text;
  for (const std::string& place : places) text += (text.empty() ? "" : " ") + place;
  return text;
}

std::vector<std::string> Recorder::files() const {
  std::vector<std::string> names;
  for (const auto& file : files_) names.push_back(file->name());
  return names;
}

}  // namespace saccade::client
