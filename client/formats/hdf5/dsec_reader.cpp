// HDF5, foremost as the DSEC data set has it: /events/x, y, p, t as whole numbers of any width, t in
// microseconds. Adds /t_offset, if there is one, to t. Labels may be /events/source and artefact, and objects
// /events/object. The size of
// the image may stand in attributes of the root or in /events. A file of a killed writer opens up to its last
// flush. In a file of several sensors, /sensor_1 has the same layout for sensor 1, and so on. Layouts of
// other programs are found by the names of their columns.
#include <stdexcept>
#include <utility>

#include "client/formats/common/column_reader.h"
#include "client/formats/hdf5/hdf5_arrays.h"
#include "client/formats/hdf5/hdf5_source.h"

namespace saccade::client {
namespace {

// Layouts with several cameras, by what only they have.
constexpr struct {
  const char *object, *layout, *columns;
} kOthers[] = {{"prophesee", "M3ED", "prophesee/left/t,prophesee/left/x,prophesee/left/y,prophesee/left/p"},
               {"ovc", "M3ED", "prophesee/left/t,prophesee/left/x,prophesee/left/y,prophesee/left/p"},
               {"davis", "MVSEC", nullptr}};

constexpr std::uint32_t kMostNamed = 20;  // sensors, and views

std::string groupOf(std::uint32_t sensor) {
  return "/sensor_" + std::to_string(sensor);
}

// "sensor 0 (--sensor 0), the truth channels of /truth": beside the events of a sensor.
std::string othersOf(const Hdf5Arrays& file, std::uint32_t sensor) {
  std::string others;
  const auto add = [&](const std::string& what) { others += (others.empty() ? "" : ", ") + what; };
  for (std::uint32_t i = 0; i < kMostNamed && (i == 0 || file.has(groupOf(i))); ++i)
    if (i != sensor) add("sensor " + std::to_string(i) + " (--sensor " + std::to_string(i) + ")");
  if (file.has("/truth")) add("the truth channels of /truth");
  for (std::uint32_t view = 1; view < kMostNamed; ++view) {
    const std::string group = "/view_" + std::to_string(view) + "/truth";
    if (file.has(group)) add("the truth channels of " + group);
  }
  return others;
}

void refuseOthers(const std::string& path, const Hdf5Arrays& file) {
  for (const auto& other : kOthers) {
    if (file.has(other.object))
      throw FileFault(path, std::string("has the layout of ") + other.layout +
                                (other.columns ? std::string("; --columns names the datasets of a camera: ") +
                                                     other.columns
                                               : "; it cannot be read"));
  }
}

ImageSize sizeOf(const std::string& path, const Hdf5Arrays& file) {
  const auto side = [&](const std::string& name) {
    auto pixels = readRootAttribute(path, file.file(), name);
    const std::string dataset = "events/" + name;
    if (!pixels && file.has(dataset)) pixels = readScalar(path, file.file(), dataset);
    return toSide(path, name, pixels.value_or(0));
  };
  const ImageSize size{side("width"), side("height")};
  return size.width != 0 ? size : readGeometry(file.file()).value_or(size);
}

ArrayFacts factsOf(const std::string& path, const Hdf5Arrays& file) {
  ArrayFacts facts;
  facts.size = sizeOf(path, file);
  facts.offset_us = readScalar(path, file.file(), "t_offset").value_or(0);
  if (file.has("ms_to_idx") || file.has("t_offset")) facts.unit = TimeUnit::kUs;
  const LabelColumns labels{file.has("events/source"), file.has("events/artefact")};
  if (labels.both()) facts.source = "events/source", facts.artefact = "events/artefact";
  if (file.has("events/object")) facts.object = "events/object";
  facts.left_out = labels.alone();
  return facts;
}

std::unique_ptr<Reader> open(const std::string& path, std::uint32_t sensor, const ColumnOptions& options) {
  auto file = std::make_unique<Hdf5Arrays>(path, sensor == 0 ? "/" : groupOf(sensor));
  if (options.columns.empty()) refuseOthers(path, *file);
  const FoundColumns columns = findColumns(path, *file, options, {kTxyp});
  ArrayFacts facts = factsOf(path, *file);
  facts.sensor = sensor;
  if (file->has(groupOf(1))) facts.name = "sensor " + std::to_string(sensor);
  const std::string others = othersOf(*file, sensor);
  facts.left_out += (facts.left_out.empty() || others.empty() ? "" : ", ") + others;
  return std::make_unique<ColumnReader>(path, std::move(file), columns, options.unit, facts);
}

std::unique_ptr<Reader> makeBy(const std::string& path, const ColumnOptions& options) {
  return open(path, 0, options);
}

std::unique_ptr<Reader> makeOf(const std::string& path, const SensorChoice& choice) {
  if (!choice.topic.empty()) throw std::invalid_argument("--topic: '" + path + "' has no topics");
  if (choice.sensor > 0 && !Hdf5Arrays(path, "/").has(groupOf(choice.sensor)))
    throw std::invalid_argument("--sensor: '" + path + "' has no sensor " + std::to_string(choice.sensor) +
                                ", which would be the group " + groupOf(choice.sensor));
  return open(path, choice.sensor, {});
}

std::unique_ptr<Reader> make(const std::string& path) {
  return makeBy(path, {});
}

}  // namespace

extern const ReaderInfo kDsecReader{".h5", "HDF5 as in DSEC, or as v2e, ESIM and Metavision have it", make,
                                    makeBy, makeOf};
extern const ReaderInfo kHdf5Reader{".hdf5", "the same", make, makeBy, makeOf};

}  // namespace saccade::client
