#include "scene/mitsuba/xml_file.h"

#include <utility>
#include <vector>

#include "base/names.h"
#include "base/text_cut.h"
#include "scene/files/confinement.h"
#include "scene/files/find_file.h"
#include "scene/files/limits.h"
#include "scene/mitsuba/xml_told.h"
#include "scene/mitsuba/xml_walk.h"

namespace saccade {
namespace {

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

// Samplers are not read: they may ask for a value of Mitsuba's command line, such as $spp.
bool isInSampler(pugi::xml_node node) {
  for (; node; node = node.parent())
    if (std::string(node.name()) == "sampler") return true;
  return false;
}

// Shapes of one id are one object, see Scene::bodies. Mitsuba itself refuses them.
bool isShape(pugi::xml_node node) {
  return std::string(node.name()) == "shape";
}

}  // namespace

XmlFile::XmlFile(std::string text, const std::string& path, const LoadOptions& options)
    : folder_(std::filesystem::path(path).parent_path()),
      options_(options),
      names_(readSceneValues(path, options)),
      text_(std::move(text), path, options, names_) {
  const std::string& bytes = text_.bytes();
  const pugi::xml_parse_result result = document_.load_buffer(bytes.data(), bytes.size());
  if (!result) throw text_.error(result.offset, std::string("faulty XML: ") + result.description());
  if (std::string(root().name()) != "scene") throw error(root(), "the root element is not <scene>");
  if (const pugi::xml_node second = root().next_sibling()) throw error(second, "a second root element");
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

bool XmlFile::isMitsuba0() const {
  return std::string(root().attribute("version").value()).starts_with("0.");
}

void XmlFile::substituteNames() {
  forEachElement(document_, [&](pugi::xml_node node) {
    for (pugi::xml_attribute a : node.attributes()) {
      const std::string value = a.value();
      if (value.find('$') == value.npos) continue;
      try {
        a.set_value(names_.substituted(value).c_str());
      } catch (const SceneError& fault) {
        if (!isInSampler(node)) throw error(node, fault.what());
      }
    }
    const std::string name = node.name();
    if (name == "default") names_.define(node.attribute("name").value(), node.attribute("value").value());
    if (name == "path") addSearchFolder(node);
  });
  names_.checkGiven();
}

void XmlFile::addSearchFolder(pugi::xml_node path) {
  const std::string value = path.attribute("value").value();
  const std::filesystem::path folder = folder_ / value;
  std::error_code absent;
  if (!toldAt(*this, path, [&] { return mayRead(folder, options_.confined_to); }))
    throw error(path, folder.string() + " leads out of the folder of the scenes");
  if (value.empty() || !std::filesystem::is_directory(folder, absent))
    throw error(path, "a <path> needs value=\"FOLDER\"; there is no folder " + folder.string());
  options_.search_folders.push_back(folder);
}

pugi::xml_node XmlFile::resolve(pugi::xml_node node) const {
  if (std::string(node.name()) != "ref") return node;
  const std::string id = node.attribute("id").value();
  const auto found = ids_.find(id);
  if (found != ids_.end() && !isAncestor(found->second, node)) return found->second;
  std::vector<std::string> names;
  for (const auto& [name, target] : ids_) names.push_back(name);
  throw error(node, "ref to '" + id + "', which names no object outside of itself; ids: " +
                        cutText(joinNames(names), kMostNames));
}

std::string XmlFile::locate(pugi::xml_node at, const std::string& filename) const {
  if (filename.empty())
    throw error(at, "the " + std::string(at.name()) + " needs <string name=\"filename\">");
  return toldAt(*this, at, [&] { return findFile(filename, folder_, options_); });
}

}  // namespace saccade
