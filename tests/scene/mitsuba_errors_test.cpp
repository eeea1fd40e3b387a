#include "scene/files/limits.h"
#include "scene/mitsuba/mitsuba_xml.h"
#include "scene/scratch.h"

namespace saccade {
namespace {

// The error of a scene whose line 4 is `line`. It has a sensor on line 2 and a bsdf with the id `paint` on
// line 3.
std::string errorAt4(const std::string& line) {
  const Scratch files;
  files.write("bad.obj", "v 0 0 0\nf 1 1 2\n");
  files.write("far.obj", "v 0 0 0\nv 1e38 0 0\nv 0 1 0\nf 1 2 3\n");
  const std::string path = files.write(
      "scene.xml",
      "<scene version='3.0.0'>\n<sensor type='perspective'><float name='fov' value='40'/></sensor>\n"
      "<bsdf type='diffuse' id='paint'/>\n" +
          line + "\n</scene>\n");
  return errorOf([&] { loadMitsubaXml(path); });
}

void expectAt4(const std::string& line, const std::string& part) {
  const std::string error = errorAt4(line);
  expectContains(error, "scene.xml:4: ");
  expectContains(error, part);
}

std::string shape(const std::string& content) {
  return "<shape type='rectangle'>" + content + "</shape>";
}

TEST(MitsubaErrors, UnknownElementsAndTypesListWhatIsSupported) {
  expectAt4("<medium type='homogeneous'/>", "<medium> is not supported");
  expectAt4("<medium type='homogeneous'/>", "supported: <sensor>, <shape>, <emitter>");
  expectAt4(
      "<emitter type='area'/>",
      "'area' is not supported; supported: envmap, constant, sky, sun, sunsky, point, spot, directional");
  expectAt4(
      "<shape type='hair'/>",
      "'hair' is not supported; supported: obj, ply, serialized, rectangle, cube, disk, cylinder, sphere");
  expectAt4(shape("<bsdf type='principled'/>"),
            "'principled' is not supported; supported: diffuse, plastic, roughplastic, conductor, "
            "roughconductor, dielectric, thindielectric, roughdielectric, metallicroughness, phong, ward, "
            "coating, roughdiffuse, roughcoating, twosided, mask, bumpmap, blendbsdf, mixturebsdf");
  expectAt4(shape("<emitter type='spot'/>"), "supported: area");
  expectAt4(shape("<boolean name='smooth' value='true'/>"), "<boolean name=\"smooth\"> is not supported");
  expectAt4(shape("<boolean name='beSmooth' value='true'/>"),
            "supported: <emitter>, <bsdf>, <transform name=\"to_world\">");
  expectAt4(shape("<bsdf type='diffuse'><texture type='wood' name='reflectance'/></bsdf>"),
            "bitmap, checkerboard");
  expectAt4(shape("<transform name='to_world'><shear/></transform>"), "supported: matrix, translate");
}

TEST(MitsubaErrors, NamesThatLeadNowhere) {
  expectAt4(shape("<float name='x' value='$nothing'/>"), "$nothing is not defined; defined: none");
  expectAt4(shape("<ref id='varnish'/>"), "ref to 'varnish'");
  expectAt4(shape("<ref id='varnish'/>"), "ids: paint");
  expectAt4("<bsdf type='twosided' id='loop'><ref id='loop'/></bsdf>" + shape("<ref id='loop'/>"),
            "ref to 'loop'");
  expectAt4(
      "<bsdf type='twosided' id='a'><ref id='b'/></bsdf><bsdf type='twosided' id='b'><ref id='a'/></bsdf>" +
          shape("<ref id='a'/>"),
      "nested more than 16 deep");
  expectAt4("<bsdf type='diffuse' id='paint'/>", "the id 'paint' is taken");
  expectAt4("<shape type='obj'><string name='filename' value='absent.obj'/></shape>",
            "absent.obj: cannot be read");
  expectAt4("<shape type='obj'><string name='filename' value='bad.obj'/></shape>",
            "bad.obj:2: vertex index '2'");
  expectAt4("<shape type='ply'/>", "the shape needs <string name=\"filename\">");
  expectAt4(shape("<bsdf type='diffuse'><texture type='bitmap' name='reflectance'>"
                  "<string name='filename' value='absent.png'/></texture></bsdf>"),
            "absent.png");
}

TEST(MitsubaErrors, ValuesOutOfRange) {
  const auto placed = [](const std::string& step) {
    return shape("<transform name='to_world'>" + step + "</transform>");
  };
  expectAt4(placed("<matrix value='1 2 3'/>"), "expected 16 numbers");
  expectAt4(placed("<matrix value='1 0 0 0 0 1 0 0 0 0 1 0 0 0 1 1'/>"), "last row");
  expectAt4(placed("<scale value='0'/>"), "flattens space");
  expectAt4(placed("<scale x='nan'/>"), "'nan' is not a finite number");
  expectAt4(placed("<rotate angle='20'/>"), "expected an axis");
  expectAt4(placed("<lookat origin='0,0,0' target='0,1,0'/>"), "parallel");
  expectAt4(shape("<bsdf type='diffuse'><rgb name='reflectance' value='1.5, 0, 0'/></bsdf>"),
            "'reflectance' must be");
  expectAt4(shape("<bsdf type='diffuse'><rgb name='reflectance' value='1, 0'/></bsdf>"), "one or three");
  expectAt4(shape("<emitter type='area'><float name='radiance' value='-1'/></emitter>"),
            "'radiance' must be");
  expectAt4(shape("<emitter type='area'><float name='radiance' value='2e18'/></emitter>"),
            "'radiance' must be");
  expectAt4("<shape type='obj'><string name='filename' value='far.obj'/></shape>", "too far away");
}

// The fault of an emitter's strength; line 4 is the one that holds it.
void expectStrengthFault(const std::string& properties, const std::string& part) {
  expectAt4(shape("<emitter type='area'><float name='radiance' value='1'/>" + properties + "</emitter>"),
            part);
}

TEST(MitsubaErrors, Strengths) {
  const auto fault = [](const std::string& keys, const std::string& part) {
    expectStrengthFault("<string name='strength' value='" + keys + "'/>", part);
  };
  fault("", "at least one key");
  for (const std::string word : {"0.5", "0:", ":1", "0:1:2", "zero:1", "0:one", "0:inf", "nan:1"})
    fault("0:1 " + word, "'" + word + "' is not seconds:factor");
  fault("-0.1:1", "'-0.1:1' has a time outside");
  fault("1e10:1", "'1e10:1' has a time outside");
  fault("0:-0.5", "'0:-0.5' has a factor below 0");
  fault("0:2e18", "'0:2e18' has a factor below 0 or too large");
  fault("0:1, 0.2:1, 0.1:0", "'0.1:0' is earlier");
  const auto periodFault = [](const std::string& keys, const std::string& period) {
    expectStrengthFault("<string name='strength' value='" + keys +
                            "'/><float name='strength_period' value='" + period + "'/>",
                        "strength_period must be");
  };
  for (const std::string period : {"0", "-1", "1e-12", "1e10"}) periodFault("0:1", period);
  periodFault("0:1, 0.2:0", "0.19");
  expectStrengthFault("<float name='strength_period' value='1'/>", "needs a <string name=\"strength\">");
}

TEST(MitsubaErrors, ShapesThatCannotBe) {
  const std::string stretched = "<transform name='to_world'><scale x='2'/></transform>";
  expectAt4("<shape type='sphere'>" + stretched + "</shape>", "same factor in all directions");
  expectAt4("<shape type='sphere'><float name='radius' value='0'/></shape>", "radius above 0");
  expectAt4("<shape type='cylinder'><float name='radius' value='0'/></shape>",
            "a radius and a length above 0");
  expectAt4("<shape type='cylinder'><float name='radius' value='-1'/></shape>",
            "a radius and a length above 0");
  expectAt4("<shape type='cylinder'><point name='p1' x='0' y='0' z='0'/></shape>", "a length above 0");
  expectAt4(shape("<ref id='paint'/><ref id='paint'/>"), "a second <bsdf>");
  expectAt4(shape("<bsdf type='twosided'/>"), "needs a <bsdf>");
}

std::string sensorError(const std::string& content) {
  const Scratch files;
  const std::string path =
      files.write("scene.xml", "<scene>\n<sensor type='perspective'>" + content + "</sensor></scene>");
  return errorOf([&] { loadMitsubaXml(path); });
}

TEST(MitsubaErrors, Sensors) {
  const std::string fov = "<float name='fov' value='40'/>";
  expectContains(sensorError("<float name='fov' value='180'/>"),
                 "scene.xml:2: the fov must be within (0, 180)");
  expectContains(sensorError(fov + "<string name='fov_axis' value='z'/>"),
                 "supported: x, y, smaller, larger, diagonal");
  expectContains(sensorError(fov + "<film type='hdrfilm'><integer name='width' value='0'/></film>"),
                 "film's width");
}

TEST(MitsubaErrors, FaultyFiles) {
  const Scratch files;
  const auto error = [&](const std::string& bytes) {
    const std::string path = files.write("scene.xml", bytes);
    return errorOf([&] { loadMitsubaXml(path); });
  };
  expectContains(error("<scene>\n<shape type='cube'>\n"), "scene.xml:2: faulty XML");
  expectContains(error(""), "faulty XML");
  expectContains(error("<model/>"), "not <scene>");
  expectContains(error("<scene/>"), "no <sensor");
  expectContains(error("<scene/>\n<scene/><!-- end -->"), "scene.xml:2: a second root element");
  expectContains(errorOf([] { loadMitsubaXml("/no/such/scene.xml"); }), "cannot be read");
  std::filesystem::resize_file(files.path("scene.xml"), kMaxXmlBytes + 1);
  expectContains(errorOf([&] { loadMitsubaXml(files.path("scene.xml")); }), "has more than 67108864 bytes");
}

TEST(MitsubaErrors, DeepNestingIsAnErrorNotACrash) {
  std::string line;
  for (int i = 0; i < 100000; ++i) line += "<bsdf type='twosided'>";
  line += "<bsdf type='diffuse'/>";
  for (int i = 0; i < 100000; ++i) line += "</bsdf>";
  expectAt4(shape(line), "nested more than 64 deep");
}

// Ten times longer with each line: the billion laughs, by <default> and by entities.
TEST(MitsubaErrors, NamesThatGrowWithoutEndAreAnError) {
  std::string line = "<default name='a0' value='aaaaaaaaaa'/>";
  for (int i = 1; i < 12; ++i) {
    line += "<default name='a" + std::to_string(i) + "' value='";
    for (int k = 0; k < 10; ++k) line += "$a" + std::to_string(i - 1);
    line += "'/>";
  }
  expectAt4(line, "the values of $names take more than");
}

TEST(MitsubaErrors, EntitiesAreNotExpanded) {
  std::string entities = "<!DOCTYPE scene [<!ENTITY e0 '40'>";
  for (int i = 1; i < 30; ++i) {
    const std::string before = "&e" + std::to_string(i - 1) + ";";
    entities += "<!ENTITY e" + std::to_string(i) + " '" + before + before + "'>";
  }
  const Scratch files;
  const std::string path = files.write(
      "scene.xml",
      entities + "]><scene><sensor type='perspective'><float name='fov' value='&e29;'/></sensor></scene>");
  expectContains(errorOf([&] { loadMitsubaXml(path); }), "'&e29;' is not a finite number");
}

}  // namespace
}  // namespace saccade
