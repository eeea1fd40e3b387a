#include "fuzz/fuzz_target.h"
#include "scene/mitsuba/mitsuba_xml.h"
#include "scene/scratch.h"

namespace saccade {
namespace {

const std::string kOld = R"(<?xml version="1.0"?>
<scene version="0.5.0"><default name="spp" value="16"/><integrator type="path"/>
<sensor type="perspective"><float name="fov" value="40"/><transform name="toWorld">
<lookAt origin="0,0,5" target="0,0,0" up="0,1,0"/></transform><sampler type="sobol">
<integer name="sampleCount" value="$spp"/></sampler><film type="hdrfilm"><integer name="width" value="64"/>
</film></sensor><bsdf type="bumpmap"><texture name="map" type="bitmap"><string name="filename" value="a.ppm"/>
</texture><bsdf type="twosided" id="metal"><bsdf type="roughconductor"><float name="alpha" value="0.1"/>
<string name="distribution" value="ggx"/><string name="material" value="Au"/></bsdf></bsdf></bsdf>
<shape type="obj"><string name="filename" value="a.obj"/><boolean name="faceNormals" value="true"/>
<transform name="toWorld"><matrix value="1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"/></transform><ref id="metal"/>
</shape></scene>)";
const std::string kNow =
    R"(<scene version="3.0.0"><sensor type="perspective"><float name="fov" value="40"/></sensor>
<bsdf type="mask" id="grid"><float name="opacity" value="0.5"/><bsdf type="roughplastic">
<texture type="checkerboard" name="diffuse_reflectance"><rgb name="color0" value="1, 0, 0"/>
<transform name="to_uv"><scale x="2" y="2"/><translate x="0.5"/></transform></texture>
<float name="int_ior" value="1.5"/><boolean name="nonlinear" value="true"/></bsdf></bsdf>
<shape type="sphere"><point name="center" x="1" y="0" z="0"/><float name="radius" value="0.5"/><ref id="grid"/></shape>
<shape type="disk"><transform name="to_world"><rotate x="1" angle="90"/></transform><emitter type="area">
<rgb name="radiance" value="1 2 3"/><string name="strength" value="0:1, 0.5:0"/></emitter></shape>
<emitter type="envmap"><string name="filename" value="a.ppm"/></emitter>
<emitter type="point"><rgb name="intensity" value="1"/></emitter>
<emitter type="spot"><rgb name="intensity" value="1"/><float name="cutoff_angle" value="30"/></emitter>
<emitter type="sun"><float name="hour" value="9"/></emitter>
<emitter type="directional"><vector name="direction" value="0, -1, 0"/><float name="irradiance" value="1"/></emitter>
</scene>)";

const std::string kParts =
    R"(<scene version="3.0.0"><default name="part" value="part"/><include filename="$part.xml"/>
<sensor type="perspective"/><shape type="cylinder"><point name="p1" x="0" y="1" z="2"/><ref id="lamp"/></shape>
<emitter type="area" id="lamp"/><shape type="sphere"><boolean name="flip_normals" value="true"/></shape></scene>)";

// The scene stands beside its mesh and its picture, and may read nothing else.
bool read(std::string_view bytes) {
  static const Scratch files;
  static const std::string mesh = files.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  static const std::string picture = files.write("a.ppm", "P3 1 1 255  1 2 3");
  LoadOptions options;
  static const std::string part = files.write("part.xml", "<scene><shape type='cube' id='box'/></scene>");
  options.confined_to = {mesh, picture, part};
  options.threads = 1;
  return accepts<SceneError>([&] { parseMitsubaXml(std::string(bytes), files.path("scene.xml"), options); });
}

}  // namespace

const FuzzTarget& fuzzTarget() {
  static const FuzzTarget target{{kOld, kNow, kParts},
                                 {"<shape type=\"cube\"/>",
                                  "<bsdf type=\"diffuse\"/>",
                                  "<ref id=\"metal\"/>",
                                  "<include filename=\"part.xml\"/>",
                                  "<path value=\".\"/>",
                                  "$spp",
                                  "id=\"metal\"",
                                  "type=\"mask\"",
                                  "name=\"to_world\"",
                                  "nan",
                                  "-1",
                                  "0",
                                  "1e39",
                                  "1e300",
                                  "&lt;",
                                  "<",
                                  ">",
                                  "\"",
                                  "]]>",
                                  "<!--",
                                  "../",
                                  "<default name=\"spp\" value=\"\"/>"},
                                 read};
  return target;
}

}  // namespace saccade
