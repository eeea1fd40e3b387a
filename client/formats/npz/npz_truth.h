// A truth channel in an .npz file: the arrays NAME and NAME_t. NAME is (n, height, width, planes) of pictures
// and (n, planes) of rows; NAME_t is (n), i64 microseconds. Pictures have NAME_exposure (n, 2) too: begin and
// end, as NAME_t.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "client/formats/common/truth_layout.h"
#include "client/formats/npz/npz_column.h"
#include "saccade/wire/truth_samples.h"

namespace saccade::client {

class NpzTruth {
 public:
  // `path`: of the archive.
  NpzTruth(const std::string& path, const v1::RecordedTruth& channel);

  void write(const TruthSamples& samples);  // all or none; throws std::system_error
  std::vector<NpzColumn*> columns();

 private:
  const v1::RecordedTruth channel_;
  NpzColumn t_, data_;
  std::optional<NpzColumn> exposure_;
};

}  // namespace saccade::client
