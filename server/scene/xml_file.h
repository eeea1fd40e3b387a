// An XML scene file with its $names filled in, its ids known, and faults that name their line.
#pragma once

#include <map>
#include <pugixml.hpp>
#include <string>

#include "scene/scene_error.h"

namespace saccade {

class XmlFile {
 public:
  // `definitions` override the values of <default> elements. Throws SceneError: a file that cannot be read,
  // faulty XML, a root that is not <scene>, a $name that is not defined.
  XmlFile(const std::string& path, std::map<std::string, std::string> definitions);

  pugi::xml_node root() const { return document_.document_element(); }
  const std::string& path() const { return path_; }
  SceneError error(pugi::xml_node at, const std::string& what) const;

  // The object that a <ref> names; other nodes are what they are. An object must stand before its <ref>, so
  // that references cannot go in circles.
  pugi::xml_node resolve(pugi::xml_node node) const;

  // A file name as the scene file means it: relative to its folder.
  std::string locate(const std::string& filename) const;

 private:
  long lineAt(std::ptrdiff_t offset) const;
  void substituteNames(std::map<std::string, std::string> definitions);
  std::string substituted(pugi::xml_node node, const std::string& text,
                          const std::map<std::string, std::string>& definitions) const;

  std::string path_, text_;
  pugi::xml_document document_;
  std::map<std::string, pugi::xml_node> ids_;
};

}  // namespace saccade
