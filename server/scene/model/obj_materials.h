// The materials of an OBJ file, from its MTL files.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "scene/files/load_options.h"
#include "scene/mesh/mesh_io.h"
#include "scene/model/mtl_file.h"
#include "scene/model/split_mesh.h"

namespace saccade {

Material greyMaterial();

class ObjMaterials {
 public:
  // Reads the files of materials that `file`, at `path`, names. Throws SceneError; one that is absent is told
  // by addTo().
  ObjMaterials(const std::string& path, const ObjFile& file, const LoadOptions& options);

  // Materials are numbered in the order of their first use. All triangles are in a range.
  const std::vector<MaterialRange>& ranges() const { return ranges_; }

  // Sets materials, textures and Scene::unread of a scene, and the light of its meshes, which are parts by
  // ranges(). Reads the pictures. Throws SceneError.
  void addTo(Scene& scene, const LoadOptions& options) const;

 private:
  struct Named {
    MtlMaterial material;
    std::string path;  // of its MTL file
  };
  void readLibrary(const std::string& path, const LoadOptions& options);
  int numberOf(const std::string& name);

  std::map<std::string, Named> known_;
  std::vector<std::string> used_;  // names, by number
  std::map<std::string, int> numbers_;
  std::vector<MaterialRange> ranges_;
  std::vector<std::string> told_;
};

}  // namespace saccade
