#include <cstdint>
#include <limits>

#include <fmt/format.h>

#include "io/files/excerpt.hpp"
#include "io/meshes/mesh_words.hpp"
#include "io/meshes/polygon_mesh.hpp"

namespace raycat {
namespace {

// The point of a corner POINT[/TEXTURE[/NORMAL]], counted from 1, or back from the last one so far.
std::uint32_t corner(std::string_view word, std::size_t points, std::size_t line) {
  std::int64_t index = 0;
  if (!read_integer(word.substr(0, word.find('/')), index) || index == 0) {
    refuse_line(line, fmt::format("'{}' is no corner of a face", excerpt(word)));
  }
  const std::int64_t from_0 = index > 0 ? index - 1 : static_cast<std::int64_t>(points) + index;
  if (from_0 < 0 || from_0 >= std::numeric_limits<std::uint32_t>::max()) {
    refuse_line(line, fmt::format("there is no vertex {}", index));
  }
  return static_cast<std::uint32_t>(from_0);
}

}  // namespace

PolygonMesh read_obj(std::string_view bytes) {
  PolygonMesh out;
  std::string joined;
  MeshWords words;
  std::size_t number = 0;
  while (!bytes.empty()) {
    std::string_view line = take_line(bytes);
    ++number;
    // A backslash at the end continues the line.
    for (joined.clear(); line.ends_with('\\') || line.ends_with("\\\r"); ++number) {
      joined += line.substr(0, line.rfind('\\'));
      joined += ' ';
      line = take_line(bytes);
    }
    if (!joined.empty()) {
      line = joined += line;
    }
    split(without_comment(line, "#"), words);
    if (words.empty()) {
      continue;
    }
    if (words[0] == "v") {
      out.points.push_back(read_point(words, 1, number));
    } else if (words[0] == "f") {
      if (words.size() < 4) {
        refuse_line(number, "a face needs three corners");
      }
      std::vector<std::uint32_t>& polygon = out.polygons.emplace_back();
      for (std::size_t i = 1; i < words.size(); ++i) {
        polygon.push_back(corner(words[i], out.points.size(), number));
      }
    }
  }
  return out;
}

}  // namespace raycat
