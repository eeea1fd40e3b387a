// A truth channel in an HDF5 file: a group with t [n], i64 microseconds, and data. The shape of data
// is [n, height, width, planes] for pictures and [n, planes] for rows. Pictures have exposure_begin and
// exposure_end too, as t. Attributes: unit, planes, description.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "client/formats/common/truth_layout.h"
#include "client/formats/hdf5/hdf5_column.h"
#include "saccade/wire/truth_samples.h"

namespace saccade::client {

// Every call throws std::runtime_error if the library refuses.
class Hdf5Truth {
 public:
  // `path`: of the new group, such as "truth/depth"; those that it is in are made too. `filters`: as for
  // Hdf5Dataset.
  Hdf5Truth(hid_t file, const std::string& path, const v1::RecordedTruth& channel, const Hdf5Handle& filters);

  // Pictures are in the file at once, and rows in chunks.
  void write(const TruthSamples& samples);
  void flush();

 private:
  const v1::RecordedTruth channel_;
  const hsize_t chunk_;  // samples
  const Hdf5Handle group_;
  Hdf5Dataset t_, data_;
  std::optional<Hdf5Dataset> exposure_begin_, exposure_end_;
  // Not in the file yet:
  std::vector<std::int64_t> times_us_, begins_us_, ends_us_;
  std::string bytes_;
};

}  // namespace saccade::client
