#include "client/formats/common/column_names.h"

#include <algorithm>
#include <cctype>

#include "client/formats/common/reader.h"

namespace saccade::client {
namespace {

struct Spelling {
  const char* word;
  Role role;
};
constexpr Spelling kSpellings[] = {
    {"t", Role::kT},     {"ts", Role::kT},         {"time", Role::kT},       {"times", Role::kT},
    {"stamp", Role::kT}, {"timestamp", Role::kT},  {"timestamps", Role::kT}, {"x", Role::kX},
    {"xs", Role::kX},    {"y", Role::kY},          {"ys", Role::kY},         {"p", Role::kP},
    {"ps", Role::kP},    {"pol", Role::kP},        {"pols", Role::kP},       {"polarity", Role::kP},
    {"on", Role::kP},    {"polarities", Role::kP},
};

// In small letters, without quotes, blanks and what closes a unit.
std::string plain(std::string_view name) {
  std::string text;
  for (const unsigned char c : name) {
    if (std::isgraph(c) && std::string_view("\"'])").find(static_cast<char>(c)) == std::string_view::npos)
      text += static_cast<char>(std::tolower(c));
  }
  return text;
}

std::optional<Role> roleOf(std::string_view word) {
  for (const Spelling& spelling : kSpellings) {
    if (word == spelling.word) return spelling.role;
  }
  return std::nullopt;
}

std::optional<TimeUnit> unitOf(std::string_view word) {
  return parseTimeUnit(word == "sec" || word == "seconds" ? "s" : word);
}

char letterOf(Role role) {
  return kRoleLetters[static_cast<std::size_t>(role)];
}

}  // namespace

std::optional<ColumnName> parseColumnName(std::string_view name) {
  const std::string word = plain(name);
  if (const auto role = roleOf(word)) return ColumnName{*role, std::nullopt};
  const std::size_t end = word.find_last_of("_[(");
  if (end == std::string::npos) return std::nullopt;
  const auto role = roleOf(std::string_view(word).substr(0, end));
  const std::string_view unit = std::string_view(word).substr(end + 1);
  if (role == Role::kT && unitOf(unit)) return ColumnName{*role, unitOf(unit)};
  if ((role == Role::kX || role == Role::kY) && (unit == "px" || unit == "pix"))
    return ColumnName{*role, std::nullopt};
  return std::nullopt;
}

std::string joined(const std::vector<std::string>& words, const char* separator) {
  std::string text;
  for (const std::string& word : words) text += (&word == &words.front() ? "" : separator) + word;
  return text;
}

bool ColumnOptions::inKnownWords() const {
  std::array<int, 4> found{};
  for (const std::string& column : columns) {
    const auto name = parseColumnName(column);
    if (!name && column != "-") return false;
    if (name) ++found[static_cast<std::size_t>(name->role)];
  }
  return found == std::array<int, 4>{1, 1, 1, 1};
}

std::optional<RolePlaces> placesOf(const std::string& path, const std::vector<std::string>& names) {
  std::array<std::optional<std::size_t>, 4> found;
  RolePlaces places;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto name = parseColumnName(names[i]);
    if (!name) continue;
    auto& place = found[static_cast<std::size_t>(name->role)];
    if (place)
      throw FileFault(path, "'" + names[*place] + "' and '" + names[i] + "' may both be " +
                                letterOf(name->role) + "; --columns T,X,Y,P decides");
    place = i;
    if (name->unit) places.unit = name->unit;
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!found[i]) return std::nullopt;
    places.at[i] = *found[i];
  }
  return places;
}

std::optional<RolePlaces> placesBy(const ColumnOptions& options, const std::vector<std::string>& names) {
  const bool known = options.inKnownWords();
  if (!known && options.columns.size() != kRoles.size()) return std::nullopt;
  RolePlaces places;
  for (std::size_t i = 0; i < options.columns.size(); ++i) {
    const std::string& word = options.columns[i];
    const auto name = parseColumnName(word);
    if (known && !name) continue;
    const auto found = std::find(names.begin(), names.end(), word);
    if (found == names.end() || std::count(options.columns.begin(), options.columns.end(), word) > 1)
      return std::nullopt;
    const std::size_t role = known ? static_cast<std::size_t>(name->role) : i;
    places.at[role] = static_cast<std::size_t>(found - names.begin());
    if (role == 0 && name) places.unit = name->unit;
  }
  return places;
}

}  // namespace saccade::client
