// Goes through elements of an XML document.
#pragma once

#include <pugixml.hpp>

namespace saccade {

// Calls f(node) for every element within `top`, in document order and without recursion, however deep they
// are.
template <class F>
void forEachElement(pugi::xml_node top, F f) {
  struct Walker : pugi::xml_tree_walker {
    explicit Walker(F& f) : f_(f) {}
    bool for_each(pugi::xml_node& node) override {
      if (node.type() == pugi::node_element) f_(node);
      return true;
    }
    F& f_;
  } walker(f);
  top.traverse(walker);
}

}  // namespace saccade
