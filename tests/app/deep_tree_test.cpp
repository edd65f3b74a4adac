// Trees of any depth are read and traced, or refused with one line, on a stack that recursion on
// their depth would overflow.

#include <algorithm>
#include <string>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "app/program.hpp"
#include "support/sanitized.hpp"

namespace raycat {
namespace {

// 13 bytes a level, where no frame is so small; 205 with a sanitizer, which widens all frames.
constexpr int depth = sanitized ? 10'000 : 40'000;
constexpr int stack_kilobytes = sanitized ? 2048 : 512;

std::string times(const std::string& text) {
  std::string all;
  for (int i = 0; i < depth; ++i) {
    all += text;
  }
  return all;
}

std::string gltf(const std::string& nodes) {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[)" + nodes +
         "]}";
}

// A chain of nodes, each with `extras` and the next as its only child.
std::string chain(const std::string& extras) {
  std::string nodes;
  for (int i = 0; i < depth; ++i) {
    nodes += fmt::format(R"({{{}"children":[{}]}},)", extras, i + 1);
  }
  return gltf(nodes + R"({"extras":{"shape":{"type":"sphere"}}})");
}

// Each a difference of a ball and the next, or of the next and a ball.
std::string differences(bool next_first) {
  std::string nodes;
  for (int i = 0; i < depth; ++i) {
    nodes +=
        fmt::format(R"({{"extras":{{"csg":"difference","cut_material":"base"}},
        "children":[{},{}]}},{{"translation":[{},0,0],"extras":{{"shape":{{"type":"sphere"}}}}}},)",
                    next_first ? 2 * i + 2 : 2 * i + 1, next_first ? 2 * i + 1 : 2 * i + 2, i + 3);
  }
  return gltf(nodes + R"({"extras":{"shape":{"type":"box","size":[2,2,2]}}})");
}

std::string scene_text(const std::string& kind) {
  const std::string close = times("}");
  const std::string cutter = "multmatrix([[1,0,0,5],[0,1,0,0],[0,0,1,0],[0,0,0,1]]){cube(1);}";
  if (kind == "union.csg") {
    return times("union(){") + "cube(1);" + close;
  }
  if (kind == "multmatrix.csg") {
    return times("multmatrix([[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]){") + "cube(1);" + close;
  }
  if (kind == "left.csg") {
    return times("difference(){") + "cube(1);" + times(cutter + "}");
  }
  if (kind == "right.csg") {
    return times("difference(){" + cutter) + "cube(1);" + close;
  }
  if (kind == "intersection.csg") {
    return times("intersection(){cube(1);") + "sphere(1);" + close;
  }
  if (kind == "colour.csg") {
    return times("color([1,0,0,1]){group(){") + "cube(1);" + close + close;
  }
  if (kind == "hull.csg") {
    return times("hull(){") + "cube(1);" + close;
  }
  if (kind == "extrude.csg") {
    return "linear_extrude(height=1){" + times("union(){") + "square(1);" + close + "}";
  }
  if (kind == "offset.csg") {
    return "linear_extrude(height=1){" + times("offset(delta=0){") + "square(1);" + close + "}";
  }
  if (kind == "vector.csg") {
    return "cube(" + times("[") + times("]") + ");";
  }
  if (kind == "open.csg") {
    return times("union(){");
  }
  if (kind == "union.gltf") {
    return chain(R"("extras":{"csg":"union"},)");
  }
  if (kind == "nodes.gltf") {
    return chain("");
  }
  if (kind == "left.gltf") {
    return differences(true);
  }
  if (kind == "right.gltf") {
    return differences(false);
  }
  return gltf(R"({"extras":{"shape":{"type":"sphere"},"other":)" + times("[") + times("]") + "}}");
}

TEST_CASE("a tree of any depth is traced or refused on a small stack", "[app][deep]") {
  const std::string kind =
      GENERATE("union.csg", "multmatrix.csg", "left.csg", "right.csg", "intersection.csg",
               "colour.csg", "hull.csg", "extrude.csg", "offset.csg", "vector.csg", "open.csg",
               "union.gltf", "nodes.gltf", "left.gltf", "right.gltf", "extras.gltf");
  CAPTURE(kind);
  const TemporaryFolder folder;
  const std::string file = folder.write(kind, scene_text(kind));
  const Outcome ran = shell(fmt::format("ulimit -s {}; '{}' render '{}' -o '{}' --size 8x8 --quiet",
                                        stack_kilobytes, RAYCAT_PROGRAM, file, folder / "out.png"));
  CAPTURE(ran.err);
  if (ran.code == 2) {
    CHECK(ran.err.starts_with("raycat: "));
    CHECK(std::ranges::count(ran.err, '\n') == 1);
    CHECK(ran.err.size() < 400);
  } else {
    CHECK(ran.code == 0);
  }
  // What is plain set operations must load.
  CHECK((ran.code == 0 || kind == "hull.csg" || kind == "extrude.csg" || kind == "offset.csg" ||
         kind == "vector.csg" || kind == "open.csg" || kind == "extras.gltf"));
}

}  // namespace
}  // namespace raycat
