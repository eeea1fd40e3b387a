// JSON for people: an object or array has a line for each of its members, in the order given.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace saccade::farm {

// `text` in quotes, with escapes. Bytes that are not UTF-8 become question marks.
std::string jsonText(const std::string& text);

// The values are JSON already.
std::string jsonObject(const std::vector<std::pair<std::string, std::string>>& members);
std::string jsonArray(const std::vector<std::string>& elements);

}  // namespace saccade::farm
