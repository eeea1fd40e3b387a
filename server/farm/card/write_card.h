// Writes the card of a data set: README.md, croissant.json and card/sequences.png.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace saccade::farm {

struct CardOptions {
  std::string folder;  // of the data set
  std::string scenes;  // folder with the scenes
  // For hubs; empty: not given.
  std::string url, licence, creator, published;
};

struct CardResult {
  std::uint64_t sequences = 0;
  std::uint32_t unfinished = 0;               // shards, of which the card does not tell
  std::vector<std::string> unknown_licences;  // scenes
  std::vector<std::string> lacking;           // options that Croissant requires
};

// Equal data sets with equal options get equal bytes. `tell` hears of pictures that cannot be drawn, and
// `step` how many sequences have been counted. Throws std::runtime_error where an index is damaged, and
// std::system_error where a file cannot be written.
CardResult writeCard(const CardOptions& options, const std::function<void(const std::string&)>& tell,
                     const std::function<void(std::uint64_t)>& step);

}  // namespace saccade::farm
