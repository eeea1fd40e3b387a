// HDF5 as the DSEC data set has it: /events/x, y, p, t as whole numbers of any width, t in microseconds. Adds
// /t_offset, if there is one, to t. Labels may be /events/source and artefact. The size of the image may
// stand in attributes of the root or in /events. In a file of several sensors, /sensor_1 has the same layout
// for sensor 1, and so on. A file of a killed writer opens up to its last flush.
#include <algorithm>
#include <optional>
#include <stdexcept>

#include "client/formats/common/event_columns.h"
#include "client/formats/hdf5/hdf5_column_reader.h"
#include "client/formats/hdf5/hdf5_source.h"

namespace saccade::client {
namespace {

// Layouts of other programs, by what only they have.
constexpr struct {
  const char *object, *layout;
} kOthers[] = {{"CD", "Metavision"}, {"prophesee", "M3ED"}, {"ovc", "M3ED"}, {"davis", "MVSEC"}};

constexpr std::uint32_t kMostNamed = 20;  // sensors, and views

bool has(const Hdf5Handle& file, const std::string& name) {
  return name == "/" || H5Lexists(file.id(), name.c_str(), H5P_DEFAULT) > 0;
}

std::string groupOf(std::uint32_t sensor) {
  return sensor == 0 ? "/" : "/sensor_" + std::to_string(sensor);
}

// Returns the group of the sensor, which keeps the file open.
Hdf5Handle openDsec(const std::string& path, std::uint32_t sensor) {
  const Hdf5Handle file = openHdf5(path);
  const std::string wanted = "; only that of DSEC can be read: /events/x, y, p and t";
  for (const auto& other : kOthers) {
    if (H5Lexists(file.id(), other.object, H5P_DEFAULT) > 0)
      throw FileFault(path, std::string("has the layout of ") + other.layout + wanted);
  }
  if (!Hdf5Handle(H5Gopen2(file.id(), "events", H5P_DEFAULT), H5Gclose))
    throw FileFault(path, "has no group /events" + wanted);
  const std::string group = groupOf(sensor);
  if (!has(file, group))
    throw std::invalid_argument("--sensor: '" + path + "' has no sensor " + std::to_string(sensor) +
                                ", which would be the group " + group);
  return {H5Gopen2(file.id(), group.c_str(), H5P_DEFAULT), H5Gclose};
}

// "sensor 0 (--sensor 0), the truth channels of /truth": what the file has beside the events of a sensor
std::string othersOf(const Hdf5Handle& file, std::uint32_t sensor) {
  std::string others;
  const auto add = [&](const std::string& what) { others += (others.empty() ? "" : ", ") + what; };
  for (std::uint32_t i = 0; i < kMostNamed && has(file, groupOf(i)); ++i)
    if (i != sensor) add("sensor " + std::to_string(i) + " (--sensor " + std::to_string(i) + ")");
  if (has(file, "/truth")) add("the truth channels of /truth");
  for (std::uint32_t view = 1; view < kMostNamed; ++view) {
    const std::string group = "/view_" + std::to_string(view);
    if (has(file, group) && has(file, group + "/truth")) add("the truth channels of " + group + "/truth");
  }
  return others;
}

class DsecReader : public Reader {
 public:
  DsecReader(const std::string& path, std::uint32_t sensor)
      : path_(path),
        sensor_(sensor),
        file_(openDsec(path, sensor)),
        x_(path, file_, "events/x"),
        y_(path, file_, "events/y"),
        p_(path, file_, "events/p"),
        t_(path, file_, "events/t"),
        label_columns_{has(file_, "events/source"), has(file_, "events/artefact")},
        offset_us_(readScalar(path, file_, "t_offset").value_or(0)) {
    for (const Hdf5ColumnReader* column : {&x_, &y_, &p_}) {
      if (column->size() != t_.size()) throw FileFault(path, "has x, y, p and t of unequal lengths");
    }
    if (labels()) openLabels();
  }

  std::uint32_t sensor() const override { return sensor_; }
  std::string name() const override {
    return has(file_, groupOf(1)) ? "sensor " + std::to_string(sensor_) : Reader::name();
  }

  ImageSize size() const override { return {side("width"), side("height")}; }

  bool labels() const override { return label_columns_.both(); }

  std::string leftOut() const override {
    const std::string label = label_columns_.alone(), others = othersOf(file_, sensor_);
    return label + (label.empty() || others.empty() ? "" : ", ") + others;
  }

  bool read(Events& events) override {
    const std::uint64_t count = std::min(kColumnBatch, t_.size() - done_);
    events.clear();
    if (count == 0) return false;
    x_.read(count, columns_.x), y_.read(count, columns_.y), p_.read(count, columns_.p);
    t_.read(count, columns_.t_us);
    if (labels()) source_->read(count, columns_.source), artefact_->read(count, columns_.artefact);
    for (std::int64_t& t_us : columns_.t_us) {
      if (__builtin_add_overflow(t_us, offset_us_, &t_us)) throw FileFault(path_, "t_offset is too large");
    }
    columns_.toEvents(path_, done_, events);
    done_ += count;
    return true;
  }

 private:
  void openLabels() {
    source_.emplace(path_, file_, "events/source"), artefact_.emplace(path_, file_, "events/artefact");
    if (source_->size() != t_.size() || artefact_->size() != t_.size())
      throw FileFault(path_, "has source, artefact and t of unequal lengths");
  }

  std::uint32_t side(const std::string& name) const {
    auto side = readRootAttribute(path_, file_, name);
    if (!side) side = readScalar(path_, file_, "events/" + name);
    return toSide(path_, name, side.value_or(0));
  }

  const std::string path_;
  const std::uint32_t sensor_;
  const Hdf5Handle file_;  // the group of the sensor
  Hdf5ColumnReader x_, y_, p_, t_;
  const LabelColumns label_columns_;
  std::optional<Hdf5ColumnReader> source_, artefact_;  // of labelled events
  const std::int64_t offset_us_;
  EventColumns columns_;
  std::uint64_t done_ = 0;  // events
};

std::unique_ptr<Reader> makeOf(const std::string& path, const SensorChoice& choice) {
  if (!choice.topic.empty()) throw std::invalid_argument("--topic: '" + path + "' has no topics");
  return std::make_unique<DsecReader>(path, choice.sensor);
}

std::unique_ptr<Reader> make(const std::string& path) {
  return makeOf(path, {});
}

}  // namespace

extern const ReaderInfo kDsecReader{".h5", "HDF5 as in DSEC", make, makeOf};

}  // namespace saccade::client
