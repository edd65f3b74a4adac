#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "io/meshes/binary_numbers.hpp"
#include "io/meshes/mesh_words.hpp"
#include "io/meshes/polygon_mesh.hpp"

namespace raycat {
namespace {

// What a vertex has after its coordinates, by the letters before OFF.
struct Columns {
  std::size_t texture = 0;
  std::size_t colour = 0;
  std::size_t normal = 0;

  std::size_t all() const { return texture + colour + normal; }
};

// Of [ST][C][N]OFF; none if it is something else.
std::optional<Columns> columns(std::string_view name) {
  Columns out;
  const auto take = [&](std::string_view letters) {
    const bool found = name.starts_with(letters);
    name.remove_prefix(found ? letters.size() : 0);
    return found;
  };
  out.texture = take("ST") ? 2 : 0;
  out.colour = take("C") ? 4 : 0;
  out.normal = take("N") ? 3 : 0;
  return name == "OFF" ? std::optional(out) : std::nullopt;
}

constexpr std::string_view comment = "#";

std::size_t take_size(MeshWordReader& in, std::string_view what) {
  std::size_t count = 0;
  if (!read_integer(in.take(), count)) {
    refuse_line(in.line(), what);
  }
  return count;
}

// Files have a line for each vertex and face, and what the line holds beyond is colours and the
// like; or they run over lines as they like, and hold what the header says.
void read_text(MeshWordReader& in, const Columns& columns, PolygonMesh& out) {
  constexpr std::string_view counts = "expected the numbers of vertices and faces";
  const std::size_t vertices = take_size(in, counts);
  const std::size_t line = in.line();
  const std::size_t faces = take_size(in, counts);
  if (in.left_of_line() > 0 || in.line() > line) {
    in.take();  // of edges, often missing
  }
  const std::size_t lines = in.lines();
  const bool line_each = vertices <= lines && faces <= lines - vertices;
  MeshWords words(3);
  for (std::size_t i = 0; i < vertices; ++i) {
    std::ranges::generate(words, [&] { return in.take(); });
    out.points.push_back(read_point(words, 0, in.line()));
    for (std::size_t k = 0; k < columns.all() && !line_each; ++k) {
      in.take();
    }
    if (line_each) {
      in.pass_line();
    }
  }
  for (std::size_t i = 0; i < faces; ++i) {
    constexpr std::string_view needed = "a face needs a number of corners, and as many corners";
    const std::size_t corners = take_size(in, needed);
    std::vector<std::uint32_t>& polygon = out.polygons.emplace_back();
    for (std::size_t k = 0; k < corners; ++k) {
      if (!read_integer(in.take(), polygon.emplace_back())) {
        refuse_line(in.line(), needed);
      }
    }
    if (line_each) {
      in.pass_line();
    }
  }
}

// Of big-endian numbers of 32 bits.
void read_binary(std::string_view bytes, const Columns& columns, PolygonMesh& out) {
  BinaryNumbers in(bytes, std::endian::big);
  const auto vertices = in.take<std::uint32_t>();
  const auto faces = in.take<std::uint32_t>();
  in.skip(4);  // edges
  for (std::uint32_t i = 0; i < vertices; ++i) {
    const auto x = in.take<float>();
    const auto y = in.take<float>();
    out.points.emplace_back(x, y, in.take<float>());
    in.skip(4 * columns.all());
  }
  for (std::uint32_t i = 0; i < faces; ++i) {
    std::vector<std::uint32_t>& polygon = out.polygons.emplace_back();
    for (auto left = in.take<std::uint32_t>(); left > 0; --left) {
      polygon.push_back(in.take<std::uint32_t>());
    }
    in.skip(4 * std::size_t{in.take<std::uint32_t>()});  // of colour
  }
}

}  // namespace

PolygonMesh read_off(std::string_view bytes) {
  constexpr std::string_view name = "OFF";
  std::string_view rest = bytes;
  MeshWords words;
  std::size_t line = 0;
  while (words.empty() && !rest.empty()) {
    split(without_comment(take_line(rest), comment), words);
    ++line;
  }
  // The numbers may follow it without a blank.
  const std::string_view first = words.empty() ? std::string_view() : words[0];
  const std::size_t end = first.find(name) + name.size();
  const std::optional<Columns> found =
      end <= first.size() && end >= name.size() ? columns(first.substr(0, end)) : std::nullopt;
  if (!found) {
    refuse_line(line, "expected OFF");
  }
  PolygonMesh out;
  if (words.size() > 1 && words[1] == "BINARY") {
    read_binary(rest, *found, out);
  } else {
    const auto begin = static_cast<std::size_t>(first.data() - bytes.data()) + end;
    MeshWordReader in(bytes.substr(begin), line, comment, "ends before its last vertex or face");
    read_text(in, *found, out);
  }
  return out;
}

}  // namespace raycat
