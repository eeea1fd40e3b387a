// The labels of events in an HDF5 file: columns beside those of the events.
#pragma once

#include "client/formats/hdf5/hdf5_column.h"
#include "saccade/wire/event.h"

namespace saccade::client {

struct Hdf5Labels {
  Hdf5Labels(hid_t group, hsize_t chunk, const Hdf5Handle& filters)
      : source(group, "source", chunk, filters), artefact(group, "artefact", chunk, filters) {}

  void push(const Event& event) { source.push(event.source), artefact.push(event.artefact); }
  void flush() { source.flush(), artefact.flush(); }

  Hdf5Column<std::uint8_t> source, artefact;
};

}  // namespace saccade::client
