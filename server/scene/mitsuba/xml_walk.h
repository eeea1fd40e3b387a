// Goes through the elements of an XML document.
#pragma once

#include <pugixml.hpp>

namespace saccade {

// Calls f(node) for every element, in document order and without recursion, however deep the file is.
template <class F>
void forEachElement(const pugi::xml_document& document, F f) {
  struct Walker : pugi::xml_tree_walker {
    explicit Walker(F& f) : f_(f) {}
    bool for_each(pugi::xml_node& node) override {
      if (node.type() == pugi::node_element) f_(node);
      return true;
    }
    F& f_;
  } walker(f);
  pugi::xml_node(document).traverse(walker);
}

}  // namespace saccade
