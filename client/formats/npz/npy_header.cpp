#include "client/formats/npz/npy_header.h"

#include <regex>

namespace saccade::client {
namespace {

constexpr std::size_t kMostFields = 64;

NpyField fieldOf(const std::smatch& found, std::size_t first) {
  return {"", *found[first].first, *found[first + 1].first, std::stoul(found[first + 2]), 0};
}

// The list of a structure, "('t', '<i8'), ('p', '|b1')".
bool parseFields(const std::string& list, NpyHeader& header) {
  static const std::regex one(" *\\( *'([^']{0,64})' *, *'([<>|])([a-zA-Z])([1-9][0-9]?)' *\\) *(?:,|$)");
  std::smatch found;
  std::string rest = list;
  while (std::regex_search(rest, found, one, std::regex_constants::match_continuous)) {
    NpyField field = fieldOf(found, 2);
    field.name = found[1].length() == 0 ? "-" : found[1].str();  // bytes between other fields
    field.offset = header.element_bytes;
    header.element_bytes += field.value_bytes;
    header.fields.push_back(field);
    rest = found.suffix();
    if (header.fields.size() > kMostFields) return false;
  }
  return !header.fields.empty() && rest.find_first_not_of(' ') == std::string::npos;
}

bool parseType(const std::string& text, NpyHeader& header) {
  static const std::regex number("'descr' *: *'([<>|])([a-zA-Z])([1-9][0-9]?)'");
  static const std::regex structure("'descr' *: *\\[([^\\]]*)\\]");
  std::smatch found;
  if (std::regex_search(text, found, structure)) return parseFields(found[1], header);
  if (!std::regex_search(text, found, number)) return false;
  header.fields = {fieldOf(found, 1)};
  header.element_bytes = header.fields.front().value_bytes;
  return true;
}

bool parseShape(const std::string& text, NpyHeader& header) {
  static const std::regex shape(  // Python 2 wrote the L
      "'shape' *: *\\( *(?:([0-9]{1,18})L? *, *(?:([1-9][0-9]?)L? *,? *)?)?\\)");
  std::smatch found;
  if (!std::regex_search(text, found, shape)) return false;
  if (found[1].matched) header.length = std::stoull(found[1]);
  if (found[2].matched) header.columns = std::stoull(found[2]);
  return header.columns.value_or(1) <= kMostFields;
}

}  // namespace

std::optional<NpyHeader> parseNpyHeader(const std::string& text) {
  static const std::regex by_columns("'fortran_order' *: *True");
  NpyHeader header;
  if (!parseType(text, header) || !parseShape(text, header)) return std::nullopt;
  header.by_columns = header.columns && std::regex_search(text, by_columns);
  if (header.structured() && header.columns) return std::nullopt;
  return header;
}

}  // namespace saccade::client
