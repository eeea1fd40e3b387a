// Pieces of manifests for Kubernetes.
#pragma once

#include <string>

namespace saccade::farm {

// A string of YAML of a text in a container's args or env, where Kubernetes itself would expand $(NAME).
std::string literal(const std::string& text);
// Lines of such a text as a block of YAML, each with so many spaces before it.
std::string literalBlock(const std::string& lines, std::size_t spaces);
// Throws std::invalid_argument where a name of an object is none: a DNS subdomain.
void checkObjectName(const std::string& name, const std::string& what);

}  // namespace saccade::farm
