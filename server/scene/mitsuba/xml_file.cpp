#include "scene/mitsuba/xml_file.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <utility>

#include "base/names.h"
#include "scene/files/find_file.h"
#include "scene/files/limits.h"

namespace saccade {
namespace {

// Calls f(node) for every element, in document order and without recursion, however deep the file is.
template <class F>
void forEachElement(pugi::xml_document& document, F f) {
  struct Walker : pugi::xml_tree_walker {
    explicit Walker(F& f) : f_(f) {}
    bool for_each(pugi::xml_node& node) override {
      if (node.type() == pugi::node_element) f_(node);
      return true;
    }
    F& f_;
  } walker(f);
  document.traverse(walker);
}

bool isAncestor(pugi::xml_node ancestor, pugi::xml_node node) {
  for (; node; node = node.parent())
    if (node == ancestor) return true;
  return false;
}

int depthOf(pugi::xml_node node) {
  int depth = 0;
  while (depth <= kMaxXmlDepth && (node = node.parent())) ++depth;
  return depth;
}

// The bsdf that the id of `node` stands for. Some files put the id on a bsdf within wrappers that have none,
// such as a bump map. The id then stands for the outermost wrapper, if that is at the top of the scene.
pugi::xml_node wholeBsdf(pugi::xml_node node) {
  const auto isBsdf = [](pugi::xml_node n) { return std::string(n.name()) == "bsdf"; };
  pugi::xml_node outer = node;
  while (isBsdf(outer) && isBsdf(outer.parent()) && !outer.parent().attribute("id")) outer = outer.parent();
  return std::string(outer.parent().name()) == "scene" ? outer : node;
}

// Shapes of one id are one object, see Scene::bodies. Mitsuba itself refuses them.
bool isShape(pugi::xml_node node) {
  return std::string(node.name()) == "shape";
}

}  // namespace

XmlFile::XmlFile(std::string text, const std::string& path, const LoadOptions& options)
    : text_(std::move(text)), path_(path), options_(options) {
  const pugi::xml_parse_result result = document_.load_buffer(text_.data(), text_.size());
  if (!result)
    throw SceneError(path_, lineAt(result.offset), std::string("faulty XML: ") + result.description());
  if (std::string(root().name()) != "scene") throw error(root(), "the root element is not <scene>");
  substituteNames();
  indexIds();
}

void XmlFile::indexIds() {
  forEachElement(document_, [&](pugi::xml_node node) {
    if (depthOf(node) > kMaxXmlDepth)
      throw error(node, "the elements are nested more than " + std::to_string(kMaxXmlDepth) + " deep");
    const std::string id = node.attribute("id").value();
    if (id.empty() || std::string(node.name()) == "ref") return;
    const auto known = ids_.find(id);
    const bool joins = known != ids_.end() && isShape(known->second) && isShape(node);
    if (known != ids_.end() && !joins) throw error(node, "the id '" + id + "' is taken already");
    ids_.emplace(id, wholeBsdf(node));
  });
}

SceneError XmlFile::error(pugi::xml_node at, const std::string& what) const {
  return {path_, lineAt(at.offset_debug()), what};
}

bool XmlFile::isMitsuba0() const {
  return std::string(root().attribute("version").value()).starts_with("0.");
}

long XmlFile::lineAt(std::ptrdiff_t offset) const {
  const auto end = text_.begin() + std::clamp<std::ptrdiff_t>(offset, 0, std::ssize(text_));
  return 1 + std::count(text_.begin(), end, '\n');
}

void XmlFile::substituteNames() {
  std::map<std::string, std::string> definitions;
  forEachElement(document_, [&](pugi::xml_node node) {
    for (pugi::xml_attribute a : node.attributes()) {
      const std::string value = a.value();
      if (value.find('$') != value.npos) a.set_value(substituted(node, value, definitions).c_str());
    }
    if (std::string(node.name()) == "default")
      definitions.emplace(node.attribute("name").value(), node.attribute("value").value());
  });
}

std::string XmlFile::substituted(pugi::xml_node node, const std::string& text,
                                 const std::map<std::string, std::string>& definitions) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] != '$') {
      out += text[i++];
      continue;
    }
    std::size_t end = i + 1;
    while (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) || text[end] == '_'))
      ++end;
    const auto found = definitions.find(text.substr(i + 1, end - i - 1));
    if (found == definitions.end()) {
      std::vector<std::string> names;
      for (const auto& [name, value] : definitions) names.push_back("$" + name);
      throw error(node, text.substr(i, end - i) + " is not defined; defined: " + joinNames(names));
    }
    if ((substituted_bytes_ += found->second.size()) > kMaxSubstitutedBytes)
      throw error(node,
                  "the values of $names take more than " + std::to_string(kMaxSubstitutedBytes) + " bytes");
    out += found->second;
    i = end;
  }
  return out;
}

pugi::xml_node XmlFile::resolve(pugi::xml_node node) const {
  if (std::string(node.name()) != "ref") return node;
  const std::string id = node.attribute("id").value();
  const auto found = ids_.find(id);
  if (found != ids_.end() && found->second.offset_debug() < node.offset_debug() &&
      !isAncestor(found->second, node))
    return found->second;
  std::vector<std::string> names;
  for (const auto& [name, target] : ids_) names.push_back(name);
  throw error(node, "ref to '" + id + "', which names no object before this line; ids: " + joinNames(names));
}

std::string XmlFile::locate(pugi::xml_node at, const std::string& filename) const {
  if (filename.empty())
    throw error(at, "the " + std::string(at.name()) + " needs <string name=\"filename\">");
  try {
    return findFile(filename, std::filesystem::path(path_).parent_path(), options_);
  } catch (const SceneError& fault) {
    throw error(at, fault.what());
  }
}

}  // namespace saccade
