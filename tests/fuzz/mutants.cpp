#include "fuzz/mutants.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "fuzz/draws.h"

namespace saccade {
namespace {

void changeBytes(std::string& bytes, const std::string& token, const std::string& other, Draws& draw) {
  const std::size_t at = draw.below(bytes.size() + 1), length = draw.below(bytes.size() - at + 1);
  switch (draw.below(7)) {
    case 0:
      if (at < bytes.size()) bytes[at] = static_cast<char>(draw.below(256));
      break;
    case 1:
      bytes.insert(at, token);
      break;
    case 2:  // a word for a word
      bytes.replace(at, std::min(bytes.find_first_of(" \n\"'/", at), bytes.size()) - at, token);
      break;
    case 3:
      bytes.erase(at, std::min<std::size_t>(length, 1 + draw.below(16)));
      break;
    case 4:
      bytes.resize(at);
      break;
    case 5:
      bytes.insert(at, bytes.substr(at, length));
      break;
    default:
      bytes = bytes.substr(0, at) + other.substr(draw.below(other.size()));
  }
}

}  // namespace

std::vector<std::string> readCorpus() {
  std::set<std::filesystem::path> paths;
  for (const auto& file : std::filesystem::directory_iterator(corpusFolder())) paths.insert(file.path());
  std::vector<std::string> corpus;
  for (const auto& path : paths) {
    std::ifstream file(path, std::ios::binary);
    corpus.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return corpus;
}

std::string mutantOf(const FuzzTarget& target, const std::vector<std::string>& originals,
                     std::uint64_t mutant) {
  Draws draw(mutant);
  std::string bytes = originals[draw.below(originals.size())];
  for (std::size_t steps = 1 + draw.below(4); steps > 0; --steps) {
    const std::string& token = target.tokens[draw.below(target.tokens.size())];
    const std::string& other = originals[draw.below(originals.size())];
    if (target.mutate && !draw.oneIn(8)) {
      bytes = target.mutate(bytes, draw);
    } else {
      changeBytes(bytes, token, other, draw);
    }
  }
  return bytes;
}

}  // namespace saccade
