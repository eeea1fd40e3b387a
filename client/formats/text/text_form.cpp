#include "client/formats/text/text_form.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <span>
#include <stdexcept>

#include "client/formats/common/column_order.h"
#include "client/formats/text/text_fields.h"
#include "client/formats/text/text_numbers.h"

namespace saccade::client {
namespace {

using Lines = std::span<const std::string>;

std::size_t columnsOf(Lines events, char separator) {
  return events.empty() ? kRoles.size() : fieldsOf(events.front(), separator).size();
}

// Lines that are not four numbers are passed over: they are refused when they are read.
std::vector<SampleRow> sampleOf(Lines events, char separator) {
  std::vector<SampleRow> rows;
  for (const std::string& line : events) {
    const auto fields = fieldsOf(line, separator);
    SampleRow row;
    bool numbers = fields.size() == row.size();
    for (std::size_t i = 0; numbers && i < row.size(); ++i) {
      std::string_view field = fields[i];
      numbers = takeReal(field, row[i]) && field.empty();
    }
    if (numbers) rows.push_back(row);
  }
  return rows;
}

// Of a file without names.
std::vector<std::string> namesByOrder(const std::string& path, const TextHead& head, Lines events,
                                      char separator) {
  const std::size_t columns = columnsOf(events, separator);
  if (columns != kRoles.size())
    throw FileFault(path, "line " + std::to_string(head.lines + 1) + " has " + std::to_string(columns) +
                              " columns; --columns names them, with - for each other than t, x, y and p");
  std::vector<ColumnOrder> orders{kTxyp, kXypt};
  if (head.size_line) orders = {kTxyp};
  if (head.geometry) orders = {kXypt};
  std::vector<std::string> names;
  for (const Role role : findOrder(path, orders, sampleOf(events, separator)))
    names.emplace_back(1, kRoleLetters[static_cast<std::size_t>(role)]);
  return names;
}

struct Columns {
  std::vector<std::string> names;
  RolePlaces places;
};

Columns byOptions(const std::string& path, const TextHead& head, std::size_t columns,
                  const ColumnOptions& options) {
  if (const auto places = placesBy(options, head.names)) return {head.names, *places};
  if (!options.inKnownWords() || options.columns.size() != columns)
    throw std::invalid_argument("--columns: '" + joined(options.columns, ",") + "' does not name the " +
                                std::to_string(columns) + " columns of '" + path +
                                "'; give t, x, y and p in its order, with - for each other");
  return {options.columns, *placesOf(path, options.columns)};
}

Columns columnsOf(const std::string& path, const TextHead& head, Lines events, char separator,
                  const ColumnOptions& options) {
  if (!options.columns.empty()) return byOptions(path, head, columnsOf(events, separator), options);
  const auto names = head.names.empty() ? namesByOrder(path, head, events, separator) : head.names;
  const auto places = placesOf(path, names);
  if (!places)
    throw FileFault(path, "line " + std::to_string(head.lines) +
                              " is no event, and does not name t, x, y and p; --columns names the columns");
  return {names, *places};
}

TimesSeen timesIn(Lines events, char separator, std::size_t column) {
  TimesSeen seen;
  for (const std::string& line : events) {
    const auto fields = fieldsOf(line, separator);
    if (column >= fields.size()) continue;
    std::string_view field = fields[column];
    double time;
    seen.decimal = seen.decimal || field.find_first_of(".eE") != std::string_view::npos;
    if (takeReal(field, time)) seen.add(time);
  }
  return seen;
}

RowForm rowOf(const Columns& columns, char separator, const FoundUnit& unit) {
  RowForm row;
  row.separator = separator;
  row.columns.resize(columns.names.size());
  for (const Role role : kRoles) row.columns[columns.places.at[static_cast<std::size_t>(role)]] = role;
  row.unit = unit.unit;
  return row;
}

}  // namespace

TextForm findForm(const std::string& path, const TextHead& head, const std::vector<std::string>& lines,
                  const ColumnOptions& options) {
  std::vector<std::string> events;
  std::copy_if(lines.begin() + static_cast<std::ptrdiff_t>(head.lines), lines.end(),
               std::back_inserter(events), [](const std::string& line) { return !isComment(line); });
  const char separator = separatorOf(events.empty() ? joined(head.names) : events.front());
  const Columns columns = columnsOf(path, head, events, separator, options);
  const TimesSeen seen = timesIn(events, separator, columns.places.at[0]);
  const auto told = head.size_line ? TimeUnit::kS : columns.places.unit;
  const FoundUnit unit = findUnit(path, options.unit, told, seen);
  TextForm form{rowOf(columns, separator, unit), joined(columns.names), "", ""};
  form.row.decimals = options.unit || told || seen.decimal;
  if (!unit.why.empty()) form.assumed = "t as " + unit.why + ", columns " + form.text;
  for (std::size_t i = 0; i < columns.names.size(); ++i) {
    if (form.row.columns[i]) continue;
    form.left_out += (form.left_out.empty() ? "column " : ", ") + columns.names[i];
  }
  return form;
}

}  // namespace saccade::client
