#include "client/formats/common/column_reader.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace saccade::client {

std::int64_t wholeOf(double value) {
  return value == std::trunc(value) && std::abs(value) < 9e18 ? static_cast<std::int64_t>(value) : INT64_MAX;
}

ColumnReader::ColumnReader(const std::string& path, std::unique_ptr<ArrayFile> file,
                           const FoundColumns& columns, const std::optional<TimeUnit>& unit, ArrayFacts facts)
    : path_(path), file_(std::move(file)), facts_(std::move(facts)), t_(file_->open(columns.places[0])) {
  x_ = openBesideT(columns.places[1]), y_ = openBesideT(columns.places[2]);
  p_ = openBesideT(columns.places[3]);
  if (labels()) source_ = openBesideT({facts_.source}), artefact_ = openBesideT({facts_.artefact});
  if (objects()) object_ = openBesideT({facts_.object});
  const auto told = columns.told ? columns.told : facts_.unit;
  unit_ = findUnit(path, unit, told, firstTimes(columns.places[0]));
  if (!unit_.why.empty()) assumed_ = "t as " + unit_.why + ", " + columns.text;
}

bool ColumnReader::read(Events& events) {
  const std::uint64_t count = std::min(kColumnBatch, t_->size() - done_);
  events.clear();
  if (count == 0) return false;
  readTimes(count);
  x_->read(count, columns_.x), y_->read(count, columns_.y), p_->read(count, columns_.p);
  if (labels()) source_->read(count, columns_.source), artefact_->read(count, columns_.artefact);
  if (objects()) object_->read(count, columns_.object);
  columns_.toEvents(path_, done_, events);
  done_ += count;
  return true;
}

ColumnReader::Column ColumnReader::openBesideT(const ColumnPlace& place) const {
  Column column = file_->open(place);
  if (column->size() != t_->size())
    throw FileFault(path_, "has columns of unequal lengths: t has " + std::to_string(t_->size()) +
                               " values, " + place.array + " has " + std::to_string(column->size()));
  return column;
}

// Opens the column anew, because some can only be read from their start.
TimesSeen ColumnReader::firstTimes(const ColumnPlace& place) const {
  const Column column = file_->open(place);
  std::vector<double> times;
  column->readReal(std::min(kColumnBatch, column->size()), times);
  TimesSeen seen;
  seen.decimal = column->real();
  for (const double time : times) seen.add(time);
  return seen;
}

void ColumnReader::readTimes(std::uint64_t count) {
  const auto microseconds = [&](auto time) {
    auto t_us = toUs(time, unit_.unit).value_or(INT64_MAX);
    return __builtin_add_overflow(t_us, facts_.offset_us, &t_us) ? INT64_MAX : t_us;
  };
  if (!t_->real()) {
    t_->read(count, columns_.t_us);
    if (unit_.unit == TimeUnit::kUs && facts_.offset_us == 0) return;
    for (std::int64_t& time : columns_.t_us) time = microseconds(time);
    return;
  }
  t_->readReal(count, real_times_);
  columns_.t_us.resize(count);
  std::transform(real_times_.begin(), real_times_.end(), columns_.t_us.begin(), microseconds);
}

}  // namespace saccade::client
