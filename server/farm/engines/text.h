// Words of others within scripts and manifests: each is quoted, or refused.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "farm/dataset/data_set.h"

namespace saccade::farm {

// The text with values in place of @KEY@. Values are not searched for keys, and other @ stay.
std::string filled(const std::string& text, const std::map<std::string, std::string>& values);

// One word of a POSIX shell, whatever is in it.
std::string shellWord(const std::string& text);
// Words, each with a space before it.
std::string shellWords(const std::vector<std::string>& words);

// A string of YAML, JSON and Python, in double quotes, of a text that passes checkPlain().
std::string quoted(const std::string& text);
// Throws std::invalid_argument, which begins with `what`, if a text is empty, has control
// characters or is no UTF-8.
void checkPlain(const std::string& text, const std::string& what);

// The data set's folder, absolute and without a slash at its end.
std::filesystem::path folderOf(const DataSet& set);
// The data set's name with all but letters, digits, - and _ replaced.
std::string plainName(const DataSet& set);
// The number of digits that shardName() has.
std::size_t shardDigits(const DataSet& set);

}  // namespace saccade::farm
