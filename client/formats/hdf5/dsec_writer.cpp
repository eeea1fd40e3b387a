// HDF5 as the DSEC data set has it: /events/x, y, p, t and /ms_to_idx. Entry m is the number of events before
// millisecond m; an event is at t + /t_offset microseconds. Compressed by gzip, or by Blosc with zstd. See
// dsec.ifi.uzh.ch/data-format, and scripts/utils/eventslicer.py of github.com/uzh-rpg/DSEC. Width and height
// stand where others look for them: in attributes of the root, and in /events.
//
// t has 32 bits, as readers expect. The file on disk ends with a whole chunk until finish(). After a full
// disk or a kill it lacks the latest events, up to 131071, and the end of /ms_to_idx. The group /truth has
// the truth channels, and then lacks the latest pictures, up to 4 MiB, and up to 1023 rows. Labels are
// /events/source and /events/artefact, u8, as in Event. Objects are /events/object, u32.
//
// Sensor 0 is at the root, and sensor k in /sensor_k with all of the layout. Truth of view v is in
// /view_v/truth, but for view 0.
#include <deque>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "client/formats/common/shared_file.h"
#include "client/formats/common/truth_group.h"
#include "client/formats/common/units.h"
#include "client/formats/common/writer.h"
#include "client/formats/hdf5/hdf5_column.h"
#include "client/formats/hdf5/hdf5_file.h"
#include "client/formats/hdf5/hdf5_labels.h"
#include "client/formats/hdf5/hdf5_truth.h"

namespace saccade::client {
namespace {

constexpr std::int64_t kUsPerMs = 1000, kUsPerSecond = 1'000'000;
constexpr std::int64_t kMaxUs = UINT32_MAX;
constexpr std::uint64_t kChunk = 131072, kIndexChunk = 4096;
constexpr std::uint64_t kTruthCommit = 4 << 20;  // bytes of samples after which they go to the disk
constexpr const char* kLimit =
    "the DSEC layout holds times from 0 to 4294.9 s (71 min 34 s); .npz and .csv hold others";

using SharedHdf5 = SharedFile<Hdf5File>;

// The group of a sensor.
Hdf5Handle groupOf(hid_t file, std::size_t number) {
  if (number == 0) return {H5Gopen2(file, "/", H5P_DEFAULT), H5Gclose};
  const std::string name = "sensor_" + std::to_string(number);
  return {H5Gcreate2(file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose};
}

class DsecWriter : public Writer {
 public:
  // `number`: of the sensor in the file. `filters`: properties of the datasets that name their filters.
  DsecWriter(const std::string& path, std::shared_ptr<SharedHdf5> shared, std::size_t number,
             const v1::Recording& about, const Hdf5Handle& filters)
      : path_(path),
        shared_(std::move(shared)),
        file_(shared_->file()),
        group_(groupOf(file_.id(), number)),
        events_(H5Gcreate2(group_.id(), "events", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose),
        x_(events_.id(), "x", kChunk, filters),
        y_(events_.id(), "y", kChunk, filters),
        p_(events_.id(), "p", kChunk, filters),
        t_(events_.id(), "t", kChunk, filters),
        ms_to_idx_(group_.id(), "ms_to_idx", kIndexChunk, filters) {
    writeAttribute(group_.id(), "width", about.width());
    writeAttribute(group_.id(), "height", about.height());
    writeScalar(events_.id(), "width", about.width());
    writeScalar(events_.id(), "height", about.height());
    if (about.labels()) labels_.emplace(events_.id(), kChunk, filters);
    if (about.object_ids()) object_.emplace(events_.id(), "object", kChunk, filters);
    addTruth(about, filters);
    toDisk();
  }

  void write(const Events& events, std::int64_t until_ns) override {
    if (!events.empty()) checkTimes(events);
    for (const Event& event : events) add(event);
    until_us_ = until_ns / kNsPerUs;
  }

  void writeTruth(int channel, const TruthSamples& samples) override {
    truth_.at(channel).write(samples);
    for (const TruthSample& sample : samples) truth_bytes_ += sample.elements.size();
    if (truth_bytes_ < kTruthCommit) return;
    truth_bytes_ = 0;
    toDisk();
  }

  void finish() override {
    if (!offset_us_) chooseOffset(0);
    indexUntil((until_us_ - *offset_us_) / kUsPerMs + 1);
    x_.flush(), y_.flush(), p_.flush(), t_.flush(), ms_to_idx_.flush();
    if (labels_) labels_->flush();
    if (object_) object_->flush();
    for (Hdf5Truth& truth : truth_) truth.flush();
    shared_->finish();
  }

  std::uint64_t kept(std::uint64_t) const override { return file_.finished() ? count_ : on_disk_; }

 private:
  void addTruth(const v1::Recording& about, const Hdf5Handle& filters) {
    for (int i = 0; i < about.truth_size(); ++i)
      truth_.emplace_back(file_.id(), truthGroup(about, i), about.truth(i), filters);
  }

  // 0, except for times that count from an epoch long ago.
  void chooseOffset(std::int64_t first_us) {
    offset_us_ = first_us > kMaxUs ? first_us / kUsPerMs * kUsPerMs : 0;
    writeScalar(group_.id(), "t_offset", *offset_us_);
  }

  void checkTimes(const Events& events) {
    if (!offset_us_) chooseOffset(events.front().t_ns / kNsPerUs);
    if (events.front().t_ns < 0 || events.back().t_ns / kNsPerUs - *offset_us_ > kMaxUs)
      throw std::range_error(path_ + ": " + kLimit);
  }

  void add(const Event& event) {
    const std::int64_t t_us = event.t_ns / kNsPerUs - *offset_us_;
    indexUntil(t_us / kUsPerMs);
    x_.push(event.x), y_.push(event.y), p_.push(event.p), t_.push(static_cast<std::uint32_t>(t_us));
    if (labels_) labels_->push(event);
    if (object_) object_->push(event.object);
    if (++count_ % kChunk != 0) return;
    ms_to_idx_.flush();
    toDisk();
  }

  // Milliseconds up to `last_ms` have no further events before them.
  void indexUntil(std::int64_t last_ms) {
    for (; next_ms_ <= last_ms; ++next_ms_) ms_to_idx_.push(count_);
  }

  void toDisk() {
    file_.commit();
    if (file_.whole()) on_disk_ = count_ / kChunk * kChunk;
  }

  const std::string path_;  // for errors
  const std::shared_ptr<SharedHdf5> shared_;
  Hdf5File& file_;
  const Hdf5Handle group_, events_;
  Hdf5Column<std::uint16_t> x_, y_;
  Hdf5Column<std::uint8_t> p_;
  Hdf5Column<std::uint32_t> t_;
  Hdf5Column<std::uint64_t> ms_to_idx_;
  std::optional<Hdf5Labels> labels_;
  std::optional<Hdf5Column<std::uint32_t>> object_;
  std::deque<Hdf5Truth> truth_;    // by channel
  std::uint64_t truth_bytes_ = 0;  // since the last commit
  std::optional<std::int64_t> offset_us_;
  std::int64_t until_us_ = 0, next_ms_ = 0;
  std::uint64_t count_ = 0, on_disk_ = 0;  // events
};

void addGzip(const Hdf5Handle& filters) {
  H5Pset_shuffle(filters.id());
  H5Pset_deflate(filters.id(), 1);
}

void addBlosc(const Hdf5Handle& filters) {
  constexpr H5Z_filter_t kBlosc = 32001;
  // Four places that the filter fills in, the level, 1 to shuffle bytes, 5 for zstd.
  constexpr unsigned kSettings[] = {0, 0, 0, 0, 1, 1, 5};
  if (H5Zfilter_avail(kBlosc) <= 0)
    throw std::invalid_argument(
        "--format: dsec-blosc needs the Blosc filter of HDF5; install hdf5-filter-plugin-blosc-serial");
  H5Pset_filter(filters.id(), kBlosc, H5Z_FLAG_MANDATORY, std::size(kSettings), kSettings);
}

template <void (*addFilters)(const Hdf5Handle&)>
Writers makeJoint(const std::string& path, const std::vector<v1::Recording>& sensors) {
  for (const v1::Recording& about : sensors)
    if (about.request().timing().duration_s() * kUsPerSecond > kMaxUs)
      throw std::invalid_argument(std::string("--format: ") + kLimit);
  startHdf5();
  const Hdf5Handle filters(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  addFilters(filters);
  const auto shared = std::make_shared<SharedHdf5>(sensors.size(), path);
  Writers writers;
  for (std::size_t i = 0; i < sensors.size(); ++i)
    writers.push_back(std::make_unique<DsecWriter>(path, shared, i, sensors[i], filters));
  return writers;
}

template <void (*addFilters)(const Hdf5Handle&)>
std::unique_ptr<Writer> make(const std::string& path, const v1::Recording& about) {
  return std::move(makeJoint<addFilters>(path, {about}).front());
}

}  // namespace

extern const WriterInfo kDsecWriter{.name = "dsec",
                                    .extension = ".h5",
                                    .description = "HDF5 as in DSEC, up to 71 min",
                                    .make = make<addGzip>,
                                    .truth = holdsAllTruth,
                                    .labels = true,
                                    .makeJoint = makeJoint<addGzip>,
                                    .objects = true};
extern const WriterInfo kDsecBloscWriter{.name = "dsec-blosc",
                                         .extension = ".h5",
                                         .description = "the same, compressed by Blosc with zstd",
                                         .make = make<addBlosc>,
                                         .truth = holdsAllTruth,
                                         .labels = true,
                                         .makeJoint = makeJoint<addBlosc>,
                                         .objects = true};

}  // namespace saccade::client
