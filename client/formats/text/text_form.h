// The form of the lines of a text file, as its head, its first lines and the user tell it.
#pragma once

#include <string>
#include <vector>

#include "client/formats/common/column_names.h"
#include "client/formats/text/text_head.h"
#include "client/formats/text/text_row.h"

namespace saccade::client {

struct TextForm {
  RowForm row;
  std::string text;      // "t x y p", for errors
  std::string assumed;   // see Reader::assumed()
  std::string left_out;  // columns that are passed over
};

// `lines`: the first of the file, with the head. Throws FileFault where these lines tell no form, or more
// than one, and std::invalid_argument if `options` do not fit.
TextForm findForm(const std::string& path, const TextHead& head, const std::vector<std::string>& lines,
                  const ColumnOptions& options);

}  // namespace saccade::client
