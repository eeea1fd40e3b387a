// The first lines of a text file, and what they tell of the others.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "client/formats/common/reader.h"

namespace saccade::client {

struct TextHead {
  ImageSize size;
  bool size_line = false;          // of rpg_e2vid: "width height"
  bool geometry = false;           // of Metavision: "%geometry:width,height"
  std::vector<std::string> names;  // of the columns, by a heading or a comment; empty: none
  std::size_t lines = 0;           // before the first event
};

// Throws FileFault for a size that no image has.
TextHead parseHead(const std::string& path, const std::vector<std::string>& lines);

}  // namespace saccade::client
