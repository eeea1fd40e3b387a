#include "client/formats/common/find_columns.h"

#include <algorithm>
#include <stdexcept>

namespace saccade::client {
namespace {

constexpr std::uint64_t kSampleRows = 1000;

// Of an array in a group of HDF5: the name without those of the groups.
std::string lastPart(const std::string& name) {
  return name.substr(name.rfind('/') + 1);
}

FoundColumns found(const RolePlaces& places, const std::vector<std::string>& names,
                   ColumnPlace (*place)(const std::string& array, const std::string& name),
                   const std::string& array) {
  FoundColumns columns;
  std::vector<std::string> chosen;
  for (std::size_t i = 0; i < columns.places.size(); ++i) {
    chosen.push_back(names[places.at[i]]);
    columns.places[i] = place(array, chosen.back());
  }
  columns.told = places.unit;
  columns.text = "columns " + joined(chosen) + (array.empty() ? "" : " of " + array);
  return columns;
}

ColumnPlace arrayPlace(const std::string&, const std::string& name) {
  return {name};
}

ColumnPlace fieldPlace(const std::string& array, const std::string& name) {
  return {array, name};
}

std::optional<FoundColumns> separateArrays(const std::string& path, const ArrayFile& file,
                                           const ColumnOptions& options) {
  const std::vector<std::string> arrays = file.names();
  std::vector<std::string> names;
  for (const std::string& array : arrays) names.push_back(lastPart(array));
  if (options.columns.empty()) {
    const auto places = placesOf(path, names);
    return places ? std::optional(found(*places, arrays, arrayPlace, "")) : std::nullopt;
  }
  if (const auto places = placesBy(options, names)) return found(*places, arrays, arrayPlace, "");
  const auto places = placesBy(options, options.columns);
  const bool all = std::all_of(options.columns.begin(), options.columns.end(),
                               [&](const std::string& name) { return file.has(name); });
  if (!places || !all) return std::nullopt;
  return found(*places, options.columns, arrayPlace, "");  // also of another group
}

std::optional<FoundColumns> fieldsOf(const std::string& path, const std::string& array,
                                     const std::vector<std::string>& fields, const ColumnOptions& options) {
  const auto places = options.columns.empty() ? placesOf(path, fields) : placesBy(options, fields);
  return places ? std::optional(found(*places, fields, fieldPlace, array)) : std::nullopt;
}

std::vector<SampleRow> sampleOf(const ArrayFile& file, const std::string& array) {
  std::vector<SampleRow> rows;
  for (std::size_t column = 0; column < std::tuple_size_v<SampleRow>; ++column) {
    const auto values = file.open({array, "", column});
    std::vector<double> sample;
    values->readReal(std::min(kSampleRows, values->size()), sample);
    rows.resize(sample.size());
    for (std::size_t i = 0; i < sample.size(); ++i) rows[i][column] = sample[i];
  }
  return rows;
}

FoundColumns byOrder(const std::string& array, const std::vector<std::string>& names) {
  const RolePlaces places = *placesOf(array, names);
  FoundColumns columns;
  for (std::size_t i = 0; i < columns.places.size(); ++i) columns.places[i] = {array, "", places.at[i]};
  columns.told = places.unit;
  columns.text = "columns " + joined(names) + " of " + array;
  return columns;
}

std::optional<FoundColumns> tableOf(const std::string& path, const ArrayFile& file, const std::string& array,
                                    std::uint64_t width, const ColumnOptions& options,
                                    const std::vector<ColumnOrder>& orders) {
  if (!options.columns.empty()) {
    if (!options.inKnownWords() || options.columns.size() != width) return std::nullopt;
    return byOrder(array, options.columns);
  }
  if (width != kRoles.size()) return std::nullopt;
  std::vector<std::string> names;
  for (const Role role : findOrder(path, orders, sampleOf(file, array)))
    names.emplace_back(1, kRoleLetters[static_cast<std::size_t>(role)]);
  return byOrder(array, names);
}

}  // namespace

FoundColumns findColumns(const std::string& path, const ArrayFile& file, const ColumnOptions& options,
                         const std::vector<ColumnOrder>& orders) {
  if (const auto columns = separateArrays(path, file, options)) return *columns;
  std::optional<FoundColumns> only;
  for (const std::string& array : file.names()) {
    const ArrayForm form = file.form(array);
    std::optional<FoundColumns> columns;
    if (!form.fields.empty()) columns = fieldsOf(path, array, form.fields, options);
    if (form.columns) columns = tableOf(path, file, array, *form.columns, options, orders);
    if (columns && only)
      throw FileFault(path, "has events in '" + only->places[0].array + "' and in '" + array + "'");
    if (columns) only = columns;
  }
  if (only) return *only;
  if (!options.columns.empty())
    throw std::invalid_argument("--columns: '" + path + "' has no columns " + joined(options.columns, ",") +
                                "; its arrays are " + joined(file.names()));
  throw FileFault(path, "has no arrays t, x, y and p, and no table of them; its arrays are " +
                            joined(file.names()) + "; --columns T,X,Y,P names four of them");
}

}  // namespace saccade::client
