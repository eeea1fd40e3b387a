#include "farm/card/sample_picture.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "client/formats/common/reader.h"
#include "pictures/library.h"

namespace saccade::farm {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMostEvents = 20'000'000;
constexpr double kMostDecay_s = 0.03, kShownEvents = 0.3;  // of a pixel, within the decay

void readEvents(const std::string& file, std::int64_t half_ns, SamplePicture& picture) {
  const auto reader = client::openReader(file, {});
  std::uint64_t count = 0;
  std::optional<std::int64_t> begin_ns;
  for (Events events; count < kMostEvents && reader->read(events); count += events.size()) {
    if (events.empty()) continue;
    if (!begin_ns) begin_ns = events.front().t_ns;
    const auto late = [&](const Event& event) { return event.t_ns > *begin_ns + half_ns; };
    const auto end = std::ranges::find_if(events, late);
    const bool last = end != events.end();
    events.erase(end, events.end());
    picture.surface.add(events);
    if (!events.empty()) picture.now_ns = events.back().t_ns;
    if (last) return;
  }
}

// Seconds, so that edges stand apart in dense recordings too.
double decayOf(const v1::DataSetRecording& recording) {
  const double pixels = double(recording.width()) * recording.height();
  const double length_s = static_cast<double>(recording.end_ns() - recording.begin_ns()) / 1e9;
  const auto events = static_cast<double>(std::max<std::uint64_t>(1, recording.events()));
  return std::min(kMostDecay_s, kShownEvents * pixels * length_s / events);
}

client::PlanePicture readPlane(const std::string& file) {
  const auto input = pictures::library().open(file);
  client::PlanePicture picture{input->shape().width, input->shape().height};
  picture.values.resize(input->shape().pixels());
  input->read(0, 1, picture.values.data(), sizeof(float));
  return picture;
}

// The file in the middle of those below FILE.truth/depth.
std::optional<std::string> middleFile(const v1::DataSetSequence& sequence, const std::string& events) {
  std::vector<std::string> names;
  for (const v1::DataSetFile& file : sequence.files())
    if (file.name().starts_with(events + ".truth/depth/") && fs::path(file.name()).extension() == ".exr")
      names.push_back(file.name());
  if (names.empty()) return std::nullopt;
  return names[names.size() / 2];
}

std::optional<client::PlanePicture> readDepth(const fs::path& folder, const v1::DataSetSequence& sequence,
                                              const v1::DataSetRecording& recording) {
  if (std::ranges::find(recording.truth(), "depth") == recording.truth().end()) return std::nullopt;
  if (const auto file = middleFile(sequence, recording.file())) return readPlane(folder / *file);
  const fs::path file = folder / recording.file();
  if (file.extension() != ".h5") return std::nullopt;
  return client::readMiddlePicture(file, "truth/depth/data");
}

}  // namespace

SamplePicture readSample(const DataSet& set, const v1::DataSetSequence& sequence) {
  if (sequence.recordings().empty()) throw std::runtime_error("a sequence has no recordings");
  const v1::DataSetRecording& recording = sequence.recordings(0);
  const fs::path folder = set.sequenceFolder(sequence);
  const std::int64_t length_ns = recording.end_ns() - recording.begin_ns();
  SamplePicture picture{
      sequence,
      {static_cast<int>(recording.width()), static_cast<int>(recording.height()), decayOf(recording)}};
  readEvents(folder / recording.file(), length_ns / 2, picture);
  picture.depth = readDepth(folder, sequence, recording);
  return picture;
}

}  // namespace saccade::farm
