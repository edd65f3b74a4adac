#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <variant>

#include <fmt/format.h>

#include "io/files/excerpt.hpp"
#include "io/meshes/binary_numbers.hpp"
#include "io/meshes/mesh_words.hpp"
#include "io/meshes/polygon_mesh.hpp"

namespace raycat {
namespace {

using Type = std::variant<std::int8_t, std::uint8_t, std::int16_t, std::uint16_t, std::int32_t,
                          std::uint32_t, float, double>;

struct TypeName {
  std::string_view name;
  std::string_view sized_name;
  Type type;
};

constexpr std::array<TypeName, 8> types{{{"char", "int8", std::int8_t{}},
                                         {"uchar", "uint8", std::uint8_t{}},
                                         {"short", "int16", std::int16_t{}},
                                         {"ushort", "uint16", std::uint16_t{}},
                                         {"int", "int32", std::int32_t{}},
                                         {"uint", "uint32", std::uint32_t{}},
                                         {"float", "float32", float{}},
                                         {"double", "float64", double{}}}};

Type type_named(std::string_view name, std::size_t line) {
  for (const TypeName& type : types) {
    if (name == type.name || name == type.sized_name) {
      return type.type;
    }
  }
  refuse_line(line, fmt::format("unknown type '{}'", excerpt(name)));
}

std::size_t size_of(const Type& type) {
  return std::visit([](auto number) { return sizeof number; }, type);
}

struct Property {
  std::string_view name;
  Type type;
  std::optional<Type> count;  ///< of a list
};

struct Element {
  std::string_view name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  enum class Format { none, ascii, little_endian, big_endian };

  Format format = Format::none;
  std::vector<Element> elements;
};

void take_format(std::string_view format, std::size_t line, Header& out) {
  if (format == "ascii") {
    out.format = Header::Format::ascii;
  } else if (format == "binary_little_endian") {
    out.format = Header::Format::little_endian;
  } else if (format == "binary_big_endian") {
    out.format = Header::Format::big_endian;
  } else {
    refuse_line(line, fmt::format("unknown format '{}'", excerpt(format)));
  }
}

// A line that is neither the first nor the last.
void take_header_line(const MeshWords& words, std::size_t line, Header& out) {
  const auto is = [&](std::string_view what, std::size_t size) {
    return words[0] == what && words.size() == size;
  };
  const bool has_format = out.format != Header::Format::none;
  if (is("format", 3) && !has_format) {
    take_format(words[1], line, out);
  } else if (is("element", 3) && has_format) {
    Element& element = out.elements.emplace_back();
    element.name = words[1];
    if (!read_integer(words[2], element.count)) {
      refuse_line(line, "an element needs a number");
    }
  } else if (is("property", 3) && !out.elements.empty()) {
    out.elements.back().properties.push_back(
        {.name = words[2], .type = type_named(words[1], line), .count = {}});
  } else if (is("property", 5) && words[1] == "list" && !out.elements.empty()) {
    out.elements.back().properties.push_back({.name = words[4],
                                              .type = type_named(words[3], line),
                                              .count = type_named(words[2], line)});
  } else if (words[0] != "comment" && words[0] != "obj_info") {
    refuse_line(line, fmt::format("'{}' is not expected here", excerpt(words[0])));
  }
}

// Takes the header off `bytes`, and counts its lines.
Header take_header(std::string_view& bytes, std::size_t& line) {
  Header out;
  MeshWords words;
  for (line = 1;; ++line) {
    if (bytes.empty()) {
      refuse_line(line, "expected end_header");
    }
    split(take_line(bytes), words);
    if (line == 1) {
      if (words.size() != 1 || words[0] != "ply") {
        refuse_line(line, "expected ply");
      }
    } else if (words.size() == 1 && words[0] == "end_header") {
      return out;
    } else if (!words.empty()) {
      take_header_line(words, line, out);
    }
  }
}

// The numbers of a text file, which has no comments.
class TextNumbers {
 public:
  TextNumbers(std::string_view text, std::size_t line) : words_(text, line, "", "is truncated") {}

  double take(const Type& /*type*/) {
    const std::string_view word = words_.take();
    const std::optional<double> number = read_number(word);
    if (!number) {
      refuse_line(words_.line(), fmt::format("'{}' is not a number", excerpt(word)));
    }
    return *number;
  }
  void skip(const Type& /*type*/) { words_.take(); }

  std::size_t left() const noexcept { return words_.left(); }

 private:
  MeshWordReader words_;
};

class PlyNumbers : public BinaryNumbers {
 public:
  using BinaryNumbers::BinaryNumbers;

  double take(const Type& type) {
    return std::visit(
        [&](auto number) { return static_cast<double>(BinaryNumbers::take<decltype(number)>()); },
        type);
  }
  void skip(const Type& type) { BinaryNumbers::skip(size_of(type)); }
};

template <typename Numbers>
std::size_t take_count(Numbers& in, const Property& property) {
  const double count = in.take(*property.count);
  if (!(count >= 0.0) || count != std::floor(count)) {
    throw std::invalid_argument(
        fmt::format("a list '{}' has {} items", excerpt(property.name), count));
  }
  if (count > static_cast<double>(in.left())) {
    throw std::invalid_argument("is truncated");
  }
  return static_cast<std::size_t>(count);
}

// An index is a whole number; less than 0 is what ends a strip.
template <typename Numbers>
void take_list(Numbers& in, const Property& property, std::vector<std::int64_t>& out) {
  out.clear();
  for (std::size_t left = take_count(in, property); left > 0; --left) {
    const double index = in.take(property.type);
    if (index != std::floor(index) || !(std::abs(index) < 0x1p32)) {
      throw std::invalid_argument(fmt::format("'{}' holds {}", excerpt(property.name), index));
    }
    out.push_back(static_cast<std::int64_t>(index));
  }
}

template <typename Numbers>
void skip_property(Numbers& in, const Property& property) {
  if (!property.count) {
    in.skip(property.type);
    return;
  }
  for (std::size_t left = take_count(in, property); left > 0; --left) {
    in.skip(property.type);
  }
}

template <typename Numbers>
void take_point(Numbers& in, const Element& element, PolygonMesh& out) {
  glm::dvec3 point(0.0);
  for (const Property& property : element.properties) {
    const std::size_t axis = std::string_view("xyz").find(property.name);
    if (property.name.size() == 1 && axis < 3 && !property.count) {
      point[static_cast<int>(axis)] = in.take(property.type);
    } else {
      skip_property(in, property);
    }
  }
  out.points.push_back(point);
}

std::uint32_t corner(std::int64_t index) {
  if (index < 0 || index > std::numeric_limits<std::uint32_t>::max()) {
    throw std::invalid_argument(fmt::format("there is no vertex {}", index));
  }
  return static_cast<std::uint32_t>(index);
}

void add_polygon(const std::vector<std::int64_t>& indices, PolygonMesh& out) {
  std::vector<std::uint32_t>& polygon = out.polygons.emplace_back();
  for (const std::int64_t index : indices) {
    polygon.push_back(corner(index));
  }
}

// Strips of triangles, every other one the other way round, each ended by an index less than 0.
void add_strips(const std::vector<std::int64_t>& indices, PolygonMesh& out) {
  std::size_t begin = 0;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (indices[i] < 0) {
      begin = i + 1;
    } else if (i >= begin + 2) {
      const std::uint32_t a = corner(indices[i - 2]);
      const std::uint32_t b = corner(indices[i - 1]);
      const std::uint32_t c = corner(indices[i]);
      if (a != b && b != c && c != a) {  // strips turn corners by repeating
        const bool odd = (i - begin) % 2 != 0;
        out.polygons.push_back(odd ? std::vector{b, a, c} : std::vector{a, b, c});
      }
    }
  }
}

template <typename Numbers>
void take_polygons(Numbers& in, const Element& element, std::vector<std::int64_t>& indices,
                   PolygonMesh& out) {
  for (const Property& property : element.properties) {
    if (!property.count || (property.name != "vertex_indices" && property.name != "vertex_index")) {
      skip_property(in, property);
      continue;
    }
    take_list(in, property, indices);
    if (element.name == "face") {
      add_polygon(indices, out);
    } else {
      add_strips(indices, out);
    }
  }
}

bool is_wanted(const Element& element) {
  return element.name == "vertex" || element.name == "face" || element.name == "tristrips";
}

// Throws unless the vertices have coordinates, and there may be as much as the header says.
void check(const Header& header, std::size_t bytes) {
  if (header.format == Header::Format::none) {
    throw std::invalid_argument("the header has no format");
  }
  const bool text = header.format == Header::Format::ascii;
  for (const Element& element : header.elements) {
    std::size_t least = 0;
    std::size_t axes = 0;
    for (const Property& property : element.properties) {
      least += text ? 2 : size_of(property.count ? *property.count : property.type);
      axes +=
          !property.count && (property.name == "x" || property.name == "y" || property.name == "z");
    }
    if (least > 0 && element.count > (bytes + 1) / least) {
      throw std::invalid_argument(
          fmt::format("the header promises {} of '{}', more than the file holds", element.count,
                      excerpt(element.name)));
    }
    if (element.name == "vertex" && axes != 3) {
      throw std::invalid_argument("the header gives vertices no x, y and z");
    }
  }
}

template <typename Numbers>
PolygonMesh read_elements(const Header& header, Numbers in) {
  PolygonMesh out;
  std::vector<std::int64_t> indices;
  std::size_t needed = header.elements.size();
  while (needed > 0 && !is_wanted(header.elements[needed - 1])) {
    --needed;
  }
  for (std::size_t e = 0; e < needed; ++e) {
    const Element& element = header.elements[e];
    for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
      if (element.name == "vertex") {
        take_point(in, element, out);
      } else if (is_wanted(element)) {
        take_polygons(in, element, indices, out);
      } else {
        for (const Property& property : element.properties) {
          skip_property(in, property);
        }
      }
    }
  }
  return out;
}

}  // namespace

PolygonMesh read_ply(std::string_view bytes) {
  std::size_t line = 0;
  const Header header = take_header(bytes, line);
  check(header, bytes.size());
  if (header.format == Header::Format::ascii) {
    return read_elements(header, TextNumbers(bytes, line + 1));
  }
  const bool little = header.format == Header::Format::little_endian;
  return read_elements(header, PlyNumbers(bytes, little ? std::endian::little : std::endian::big));
}

}  // namespace raycat
