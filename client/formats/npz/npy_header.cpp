#include "client/formats/npz/npy_header.h"

#include <regex>

namespace saccade::client {

std::optional<NpyHeader> parseNpyHeader(const std::string& text) {
  static const std::regex type("'descr' *: *'([<>|])([a-zA-Z])([1-9][0-9]?)'");
  static const std::regex shape("'shape' *: *\\( *(?:([0-9]{1,18})L? *, *)?\\)");  // Python 2 wrote the L
  std::smatch found_type, found_shape;
  if (!std::regex_search(text, found_type, type) || !std::regex_search(text, found_shape, shape))
    return std::nullopt;
  NpyHeader header{*found_type[1].first, *found_type[2].first, std::stoul(found_type[3]), std::nullopt};
  if (found_shape[1].matched) header.length = std::stoull(found_shape[1]);
  return header;
}

}  // namespace saccade::client
