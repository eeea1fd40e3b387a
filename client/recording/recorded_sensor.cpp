#include "client/recording/recorded_sensor.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "client/recording/sidecar.h"

namespace saccade::client {

RecordedSensor::RecordedSensor(const std::string& name, const WriterInfo& format,
                               std::unique_ptr<Writer> writer, v1::Recording about)
    : name_(name), about_(std::move(about)), writer_(std::move(writer)) {
  for (int i = 0; i < about_.truth_size(); ++i) {
    if (format.truth && format.truth(about_.truth(i))) continue;
    if (!truth_folder_) truth_folder_.emplace(truthFolderOf(name_));
    truth_folder_->add(i, about_.truth(i));
  }
}

RecordedSensor::~RecordedSensor() {
  endAnyway();
}

void RecordedSensor::endAnyway() {
  if (std::exchange(ended_, true)) return;
  try {
    writer_->finish();
  } catch (const std::exception&) {
    // The fault that ended the recording is being told already.
  }
}

void RecordedSensor::write(const Events& events, std::int64_t t0_ns, std::int64_t until_ns) {
  writer_->write(events, until_ns);
  digest_.add(events);
  if (!std::exchange(begun_, true)) about_.set_begin_ns(t0_ns);
  about_.set_end_ns(std::max(about_.end_ns(), until_ns));
  about_.set_events(about_.events() + events.size());
}

void RecordedSensor::writeTruth(int channel, const TruthSamples& samples) {
  if (truth_folder_ && truth_folder_->holds(channel)) {
    truth_folder_->write(channel, samples);
  } else {
    writer_->writeTruth(channel, samples);
  }
  v1::RecordedTruth& about = *about_.mutable_truth(channel);
  about.set_samples(about.samples() + samples.size());
}

void RecordedSensor::close() {
  about_.set_digest(digest_.hex());
  ended_ = true;
  writer_->finish();
  if (truth_folder_) truth_folder_->close();
}

void RecordedSensor::commit(const std::string& name) {
  writeSidecar(sidecarOf(name), about_);
  if (truth_folder_) {
    std::filesystem::remove_all(truthFolderOf(name));
    std::filesystem::rename(truthFolderOf(name_), truthFolderOf(name));
  }
  name_ = name;
}

std::vector<std::string> RecordedSensor::truthPlaces(const std::string& file, const std::string& name) const {
  const auto in_folder = truth_folder_ ? truth_folder_->size() : 0;
  std::vector<std::string> places;
  if (in_folder < static_cast<std::size_t>(about_.truth_size())) places.push_back(file);
  if (truth_folder_) places.push_back(truthFolderOf(name));
  return places;
}

}  // namespace saccade::client
