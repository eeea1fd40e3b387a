#include "farm/engines/manifest_text.h"

#include <regex>
#include <sstream>
#include <stdexcept>

#include "farm/engines/text.h"

namespace saccade::farm {
namespace {

constexpr std::size_t kMostNameLetters = 253;

// $$ stands for $. It changes nothing else, so a text that has neither $( nor $$ stays as it is.
std::string unexpanded(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool special = text[i] == '$' && i + 1 < text.size() && (text[i + 1] == '(' || text[i + 1] == '$');
    result += special ? "$$" : std::string(1, text[i]);
  }
  return result;
}

}  // namespace

std::string literal(const std::string& text) {
  return quoted(unexpanded(text));
}

std::string literalBlock(const std::string& lines, std::size_t spaces) {
  std::istringstream input(unexpanded(lines));
  std::string block = "|", line;
  while (std::getline(input, line)) block += "\n" + (line.empty() ? "" : std::string(spaces, ' ') + line);
  return block;
}

void checkObjectName(const std::string& name, const std::string& what) {
  static const std::regex kName("[a-z0-9]([-a-z0-9]*[a-z0-9])?(\\.[a-z0-9]([-a-z0-9]*[a-z0-9])?)*");
  if (name.size() > kMostNameLetters || !std::regex_match(name, kName))
    throw std::invalid_argument(what + ": '" + name +
                                "' is not the name of an object: small letters, digits, - and .");
}

}  // namespace saccade::farm
