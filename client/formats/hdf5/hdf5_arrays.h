// The datasets of an HDF5 file that may be of events, as others lay them out.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "client/formats/common/array_file.h"
#include "client/formats/hdf5/hdf5_handle.h"

namespace saccade::client {

class Hdf5Arrays : public ArrayFile {
 public:
  // Those of `group`, with names within it. Throws as openHdf5().
  Hdf5Arrays(const std::string& path, const std::string& group);

  const Hdf5Handle& file() const { return file_; }
  // Those of the group /events, or the dataset /events, or that of Metavision, /CD/events, or those of the
  // root: the first that there are.
  std::vector<std::string> names() const override;
  bool has(const std::string& name) const override;
  ArrayForm form(const std::string& name) const override;
  std::unique_ptr<NumberColumn> open(const ColumnPlace& place) const override;

 private:
  bool isA(const std::string& name, H5I_type_t type) const;
  std::vector<std::string> datasetsOf(const std::string& group) const;

  const std::string path_;
  const Hdf5Handle file_;  // the group, which keeps the file open
};

}  // namespace saccade::client
