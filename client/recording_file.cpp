#include "client/recording_file.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "client/sidecar.h"

namespace saccade::client {

RecordingFile::RecordingFile(const std::string& path, const WriterInfo& format, v1::Recording about)
    : path_(path),
      name_(path == kStandardOutput ? path : path + ".partial"),
      about_(std::move(about)),
      writer_(format.make(name_, about_)) {
  for (int i = 0; i < about_.truth_size(); ++i) {
    if (format.truth && format.truth(about_.truth(i))) continue;
    if (!truth_folder_) truth_folder_.emplace(truthFolderOf(name_));
    truth_folder_->add(i, about_.truth(i));
  }
}

RecordingFile::~RecordingFile() {
  if (!writer_) return;
  try {
    writer_->finish();
  } catch (const std::exception&) {
    // The fault that ended the recording is being told already.
  }
}

void RecordingFile::write(const Events& events, std::int64_t t0_ns, std::int64_t until_ns) {
  writer_->write(events, until_ns);
  digest_.add(events);
  if (!std::exchange(begun_, true)) about_.set_begin_ns(t0_ns);
  about_.set_end_ns(std::max(about_.end_ns(), until_ns));
  about_.set_events(about_.events() + events.size());
}

void RecordingFile::writeTruth(int channel, const TruthSamples& samples) {
  if (truth_folder_ && truth_folder_->holds(channel)) {
    truth_folder_->write(channel, samples);
  } else {
    writer_->writeTruth(channel, samples);
  }
  v1::RecordedTruth& about = *about_.mutable_truth(channel);
  about.set_samples(about.samples() + samples.size());
}

void RecordingFile::close() {
  about_.set_digest(digest_.hex());
  std::exchange(writer_, nullptr)->finish();
  if (truth_folder_) truth_folder_->close();
}

std::string RecordingFile::truthPlace() const {
  if (!truth_folder_) return name_;
  const bool all = truth_folder_->size() == static_cast<std::size_t>(about_.truth_size());
  return (all ? "" : name_ + " ") + truthFolderOf(name_);
}

void RecordingFile::commit() {
  if (path_ == kStandardOutput) return;
  const std::string sidecar = sidecarOf(path_);
  writeSidecar(sidecar, about_);
  if (truth_folder_) {
    std::filesystem::remove_all(truthFolderOf(path_));
    std::filesystem::rename(truthFolderOf(name_), truthFolderOf(path_));
  }
  std::filesystem::rename(name_, path_);
  name_ = path_;
}

}  // namespace saccade::client
