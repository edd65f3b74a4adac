#include "io/meshes/plain_ply.hpp"

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include "io/meshes/mesh_words.hpp"

namespace raycat {
namespace {

struct Element {
  std::string_view name;
  std::uint64_t count = 0;
  std::uint64_t least_bytes = 0;  // of one
  bool skipped = false;
};

std::uint64_t type_size(std::string_view type, std::size_t line) {
  if (type == "char" || type == "uchar" || type == "int8" || type == "uint8") {
    return 1;
  }
  if (type == "short" || type == "ushort" || type == "int16" || type == "uint16") {
    return 2;
  }
  if (type == "int" || type == "uint" || type == "int32" || type == "uint32" || type == "float" ||
      type == "float32") {
    return 4;
  }
  if (type == "double" || type == "float64") {
    return 8;
  }
  refuse_line(line, fmt::format("unknown type '{:.40}'", type));
}

// The header, taken line by line.
class Header {
 public:
  // False at its end.
  bool take(const MeshWords& words, std::size_t line);

  // Throws `std::invalid_argument` if the data cannot be as much as is promised.
  void require_data(std::size_t bytes) const;

  bool binary() const { return binary_; }
  std::string plain() const { return plain_ + "end_header\n"; }

 private:
  void take_format(std::string_view format, std::size_t line);
  void take_element(std::string_view name, std::string_view count, std::size_t line);
  void take_number(std::string_view type, std::string_view name, std::size_t line);
  void take_list(const MeshWords& words, std::size_t line);

  static constexpr std::string_view magic = "ply\n";

  std::string plain_;
  bool binary_ = false;
  std::vector<Element> elements_;
};

bool Header::take(const MeshWords& words, std::size_t line) {
  if (plain_.empty()) {
    if (words.size() != 1 || words[0] != "ply") {
      refuse_line(line, "expected ply");
    }
    plain_ = magic;
    return true;
  }
  if (words.empty() || words[0] == "comment" || words[0] == "obj_info") {
    return true;
  }
  if (words.size() == 1 && words[0] == "end_header") {
    return false;
  }
  const bool has_format = plain_.size() > magic.size();
  if (words[0] == "format" && words.size() == 3 && !has_format) {
    take_format(words[1], line);
  } else if (words[0] == "element" && words.size() == 3 && has_format) {
    take_element(words[1], words[2], line);
  } else if (words[0] == "property" && words.size() == 3 && !elements_.empty()) {
    take_number(words[1], words[2], line);
  } else if (words[0] == "property" && words.size() == 5 && words[1] == "list" &&
             !elements_.empty()) {
    take_list(words, line);
  } else {
    refuse_line(line, fmt::format("'{:.40}' is not expected here", words[0]));
  }
  return true;
}

void Header::take_format(std::string_view format, std::size_t line) {
  if (format != "ascii" && format != "binary_little_endian" && format != "binary_big_endian") {
    refuse_line(line, fmt::format("unknown format '{:.40}'", format));
  }
  binary_ = format != "ascii";
  plain_ += fmt::format("format {} 1.0\n", format);
}

void Header::take_element(std::string_view name, std::string_view count, std::size_t line) {
  Element element{.name = name};
  if (!read_integer(count, element.count)) {
    refuse_line(line, "an element needs a number");
  }
  // What comes after the faces need not be read.
  element.skipped =
      !elements_.empty() && (elements_.back().skipped || elements_.back().name == "face");
  if (!element.skipped) {
    if (name != "vertex" && name != "face") {
      refuse_line(line, fmt::format("elements '{:.40}' before the faces are not supported", name));
    }
    plain_ += fmt::format("element {} {}\n", name, element.count);
  }
  elements_.push_back(element);
}

void Header::take_number(std::string_view type, std::string_view name, std::size_t line) {
  const std::uint64_t size = type_size(type, line);
  elements_.back().least_bytes += binary_ ? size : 2;
  if (!elements_.back().skipped) {
    plain_ += fmt::format("property {} {}\n", type, name);
  }
}

// property list SIZE_TYPE TYPE NAME
void Header::take_list(const MeshWords& words, std::size_t line) {
  const std::uint64_t size = type_size(words[2], line);
  elements_.back().least_bytes += binary_ ? size : 2;
  type_size(words[3], line);
  if (elements_.back().skipped) {
    return;
  }
  const bool corners = words[4] == "vertex_indices" || words[4] == "vertex_index";
  if (elements_.back().name != "face" || !corners) {
    refuse_line(line, fmt::format("the list '{:.40}' is not supported", words[4]));
  }
  plain_ += fmt::format("property list {} {} vertex_indices\n", words[2], words[3]);
}

void Header::require_data(std::size_t bytes) const {
  for (const Element& element : elements_) {
    if (!element.skipped &&
        (element.least_bytes == 0 || element.count > (bytes + 1) / element.least_bytes)) {
      throw std::invalid_argument(
          fmt::format("the header promises {} of '{:.40}', more than the file holds", element.count,
                      element.name));
    }
  }
}

}  // namespace

PlainPly plain_ply(std::string_view bytes) {
  Header header;
  MeshWords words;
  std::string_view rest = bytes;
  for (std::size_t line = 1;; ++line) {
    if (rest.empty()) {
      refuse_line(line, "expected end_header");
    }
    split(take_line(rest), words);
    if (!header.take(words, line)) {
      break;
    }
  }
  header.require_data(rest.size());
  PlainPly plain{.binary = header.binary(), .bytes = header.plain()};
  plain.bytes += rest;
  return plain;
}

}  // namespace raycat
