// Reads the events of a file of arrays.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "client/formats/common/event_columns.h"
#include "client/formats/common/find_columns.h"

namespace saccade::client {

// Facts that a format tells beside the columns.
struct ArrayFacts {
  ImageSize size;
  std::optional<TimeUnit> unit;  // of t, where the layout tells it
  std::int64_t offset_us = 0;    // to be added to t
  std::string source, artefact;  // the arrays of labels, where both are there
  std::string object;            // that of objects
  std::string left_out;
  std::uint32_t sensor = 0;  // as Reader::sensor()
  std::string name = "one stream";
};

class ColumnReader : public Reader {
 public:
  ColumnReader(const std::string& path, std::unique_ptr<ArrayFile> file, const FoundColumns& columns,
               const std::optional<TimeUnit>& unit, ArrayFacts facts);

  ImageSize size() const override { return facts_.size; }
  std::uint32_t sensor() const override { return facts_.sensor; }
  std::string name() const override { return facts_.name; }
  bool labels() const override { return !facts_.source.empty(); }
  bool objects() const override { return !facts_.object.empty(); }
  std::string leftOut() const override { return facts_.left_out; }
  std::string assumed() const override { return assumed_; }
  bool read(Events& events) override;

 private:
  using Column = std::unique_ptr<NumberColumn>;

  Column openBesideT(const ColumnPlace& place) const;  // throws if it has another length
  TimesSeen firstTimes(const ColumnPlace& place) const;
  void readTimes(std::uint64_t count);

  const std::string path_;
  const std::unique_ptr<ArrayFile> file_;
  const ArrayFacts facts_;
  Column t_, x_, y_, p_, source_, artefact_, object_;
  FoundUnit unit_;
  std::string assumed_;
  EventColumns columns_;
  std::vector<double> real_times_;
  std::uint64_t done_ = 0;  // events
};

}  // namespace saccade::client
