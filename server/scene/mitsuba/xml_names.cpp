#include "scene/mitsuba/xml_names.h"

#include <cctype>
#include <vector>

#include "base/names.h"
#include "base/text_cut.h"
#include "scene/files/limits.h"

namespace saccade {
namespace {

std::string describe(const std::set<std::string>& names) {
  std::vector<std::string> written;
  for (const std::string& name : names) written.push_back("$" + name);
  return cutText(joinNames(written), kMostNames);
}

}  // namespace

void XmlNames::define(const std::string& name, const std::string& value) {
  defaults_.emplace(name, value);
  named_.insert(name);
}

SceneError XmlNames::undefined(const std::string& name) const {
  std::set<std::string> defined;
  for (const auto& [known, value] : defaults_) defined.insert(known);
  for (const auto& [known, value] : given_.by_name) defined.insert(known);
  return SceneError("$" + name + " is not defined; defined: " + describe(defined) + ". A <default> or " +
                    kValuesFile + " beside the scene defines a name");
}

const std::string& XmlNames::valueOf(const std::string& name) {
  const auto given = given_.by_name.find(name);
  const auto found = defaults_.find(name);
  if (given == given_.by_name.end() && found == defaults_.end()) throw undefined(name);
  named_.insert(name);
  return given != given_.by_name.end() ? given->second.text : found->second;
}

std::string XmlNames::substituted(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] != '$') {
      out += text[i++];
      continue;
    }
    std::size_t end = i + 1;
    while (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) || text[end] == '_'))
      ++end;
    const std::string& value = valueOf(text.substr(i + 1, end - i - 1));
    if ((substituted_bytes_ += value.size()) > kMaxSubstitutedBytes)
      throw SceneError("the values of $names take more than " + std::to_string(kMaxSubstitutedBytes) +
                       " bytes");
    out += value;
    i = end;
  }
  return out;
}

void XmlNames::checkGiven() const {
  for (const auto& [name, value] : given_.by_name)
    if (!named_.contains(name))
      throw SceneError(given_.file, value.line,
                       "the scene has no $" + cutText(name, kMaxEcho) + "; it has: " + describe(named_));
}

}  // namespace saccade
