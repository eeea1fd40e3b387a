// A picture of a sequence: its events in the middle of it, and the distances then.
#pragma once

#include <optional>

#include "client/drawing/time_surface.h"
#include "client/formats/hdf5/hdf5_picture.h"
#include "farm/dataset/data_set.h"

namespace saccade::farm {

struct SamplePicture {
  v1::DataSetSequence sequence;
  client::TimeSurface surface;  // of its first recording
  std::int64_t now_ns = 0;      // of its newest event; 0: there is none
  std::optional<client::PlanePicture> depth = {};
};

// Reads the events up to the middle of the recording, and at most 20 million. `depth`: the picture in the
// middle of the truth channel of that name, where there is one in HDF5 or in pictures of its own. Throws
// std::runtime_error and std::invalid_argument where a file cannot be read.
SamplePicture readSample(const DataSet& set, const v1::DataSetSequence& sequence);

}  // namespace saccade::farm
