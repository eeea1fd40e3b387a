// A recipe in a folder of its own.
#pragma once

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace saccade::farm {

class RecipeFile {
 public:
  explicit RecipeFile(const std::string& text) {
    std::string name = std::filesystem::temp_directory_path() / "recipe-XXXXXX";
    if (!mkdtemp(name.data())) throw std::runtime_error(name);
    folder = name;
    write("recipe.toml", text);
  }
  ~RecipeFile() { std::filesystem::remove_all(folder); }
  RecipeFile(const RecipeFile&) = delete;
  RecipeFile& operator=(const RecipeFile&) = delete;

  void write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((folder / name).parent_path());
    std::ofstream(folder / name) << text;
  }
  std::string path() const { return folder / "recipe.toml"; }

  std::filesystem::path folder;
};

}  // namespace saccade::farm
