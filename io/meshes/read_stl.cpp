#include <algorithm>
#include <cctype>
#include <cstdint>
#include <stdexcept>

#include <fmt/format.h>

#include "io/files/excerpt.hpp"
#include "io/meshes/binary_numbers.hpp"
#include "io/meshes/mesh_words.hpp"
#include "io/meshes/polygon_mesh.hpp"

namespace raycat {
namespace {

constexpr std::size_t header_size = 80;
constexpr std::size_t facet_size = 50;

// Is the word this one, in letters of either size? `expected` is in small ones.
bool is(std::string_view word, std::string_view expected) {
  return std::ranges::equal(word, expected, [](unsigned char a, unsigned char b) {
    return std::tolower(a) == static_cast<int>(b);
  });
}

// Some binary files begin with solid too, but text has no byte 0, which is in any number of
// triangles that fits a file.
bool is_text(std::string_view bytes) {
  const std::string_view start =
      bytes.substr(std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size()));
  return is(start.substr(0, 5), "solid") &&
         bytes.substr(std::min(bytes.size(), header_size), 4).find('\0') == std::string_view::npos;
}

// The triangles of a text file, taken line by line.
class Facets {
 public:
  explicit Facets(PolygonMesh& out) : out_(out) {}

  // `words` are not empty.
  void take(const MeshWords& words, std::size_t line);

  // At the end of the file.
  void end();

 private:
  enum class In { file, solid, facet, loop };

  // Is it `end` with what it ends, in one word or two?
  static bool ends(const MeshWords& words, std::string_view what) {
    return (is(words[0], "end") && words.size() > 1 && is(words[1], what)) ||
           (words[0].size() > 3 && is(words[0].substr(0, 3), "end") &&
            is(words[0].substr(3), what));
  }

  PolygonMesh& out_;
  In in_ = In::file;
};

void Facets::take(const MeshWords& words, std::size_t line) {
  const auto need = [&](bool found, std::string_view what) {
    if (!found) {
      refuse_line(line, fmt::format("expected {}, but found '{}'", what, excerpt(words[0])));
    }
  };
  switch (in_) {
    case In::file:
    case In::solid:
      if (is(words[0], "facet")) {
        in_ = In::facet;
      } else if (ends(words, "solid")) {
        in_ = In::file;
      } else {
        need(is(words[0], "solid"), "facet");
        in_ = In::solid;
      }
      return;
    case In::facet:
      if (ends(words, "facet")) {
        in_ = In::solid;
      } else {
        need(is(words[0], "outer") && words.size() > 1 && is(words[1], "loop"), "outer loop");
        out_.polygons.emplace_back();
        in_ = In::loop;
      }
      return;
    case In::loop:
      if (is(words[0], "vertex")) {
        if (words.size() > 4) {
          refuse_line(line, "a vertex needs three finite numbers");
        }
        out_.polygons.back().push_back(static_cast<std::uint32_t>(out_.points.size()));
        out_.points.push_back(read_point(words, 1, line));
        return;
      }
      need(out_.polygons.back().size() >= 3, "vertex");
      need(ends(words, "loop"), "endloop");
      in_ = In::facet;
  }
}

void Facets::end() {
  if (in_ == In::facet || in_ == In::loop) {
    throw std::invalid_argument("ends within a facet");
  }
  if (in_ == In::solid) {
    out_.warning = "ends without endsolid, and may have been longer";
  }
}

void read_text(std::string_view text, PolygonMesh& out) {
  Facets facets(out);
  MeshWords words;
  for (std::size_t line = 1; !text.empty(); ++line) {
    split(take_line(text), words);
    if (!words.empty()) {
      facets.take(words, line);
    }
  }
  facets.end();
}

void read_binary(std::string_view bytes, PolygonMesh& out) {
  if (bytes.size() < header_size + 4) {
    throw std::invalid_argument("is neither a text STL file nor long enough for a binary one");
  }
  BinaryNumbers in(bytes.substr(header_size), std::endian::little);
  const auto promised = in.take<std::uint32_t>();
  const std::size_t held = (bytes.size() - header_size - 4) / facet_size;
  if (promised > held) {
    throw std::invalid_argument(
        fmt::format("the header promises {} triangles, but the file holds {}", promised, held));
  }
  out.points.reserve(3 * std::size_t{promised});
  out.polygons.reserve(promised);
  for (std::uint32_t i = 0; i < promised; ++i) {
    in.skip(3 * sizeof(float));  // the normal
    const auto first = static_cast<std::uint32_t>(out.points.size());
    for (int corner = 0; corner < 3; ++corner) {
      const auto x = in.take<float>();
      const auto y = in.take<float>();
      out.points.emplace_back(x, y, in.take<float>());
    }
    out.polygons.push_back({first, first + 1, first + 2});
    in.skip(2);  // attributes
  }
}

}  // namespace

PolygonMesh read_stl(std::string_view bytes) {
  PolygonMesh out;
  if (is_text(bytes)) {
    read_text(bytes, out);
  } else {
    read_binary(bytes, out);
  }
  return out;
}

}  // namespace raycat
