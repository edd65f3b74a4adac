#include "io/meshes/mesh_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

namespace raycat {

namespace {

using Words = std::vector<std::string_view>;

[[noreturn]] void fail(std::size_t line, std::string_view what) {
  throw std::invalid_argument(fmt::format("line {}: {}", line, what));
}

// Takes the next line off `text`.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

void split(std::string_view line, Words& words) {
  constexpr std::string_view blanks = " \t\r\v\f";
  words.clear();
  for (std::size_t at = line.find_first_not_of(blanks); at != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(blanks, end);
  }
}

// As `float`, which is what OpenMesh keeps.
bool is_coordinate(std::string_view word) {
  word.remove_prefix(word.starts_with('+') ? 1 : 0);
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  // Numbers too small for a double are written by some tools and mean 0.
  const bool small = error == std::errc::result_out_of_range &&
                     word.find_first_of("eE") != std::string_view::npos &&
                     word.find("e-") != std::string_view::npos;
  return (error == std::errc() || small) && end == word.data() + word.size() &&
         std::isfinite(static_cast<float>(value));
}

template <typename Integer>
bool read_integer(std::string_view word, Integer& value) {
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}

}  // namespace

std::string plain_obj(std::string_view bytes) {
  std::string plain;
  std::string joined;
  Words words;
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
    split(line.substr(0, line.find('#')), words);
    if (words.empty() || (words[0] != "v" && words[0] != "f")) {
      continue;
    }
    plain += words[0];
    if (words[0] == "v") {
      if (words.size() < 4 || !std::all_of(words.begin() + 1, words.begin() + 4, is_coordinate)) {
        fail(number, "a vertex needs three finite numbers");
      }
      words.resize(4);
    } else if (words.size() < 4) {
      fail(number, "a face needs three corners");
    }
    for (std::size_t i = 1; i < words.size(); ++i) {
      const std::string_view word = words[i].substr(0, words[i].find('/'));
      std::int32_t index = 0;
      if (words[0] == "f" && (!read_integer(word, index) || index == 0)) {
        fail(number, fmt::format("'{:.40}' is no corner of a face", words[i]));
      }
      plain += ' ';
      plain += word;
    }
    plain += '\n';
  }
  return plain;
}

std::string plain_off(std::string_view bytes) {
  std::string plain;
  Words words;
  std::uint64_t vertices = 0;
  std::uint64_t faces = 0;
  std::size_t normal_words = 0;
  std::size_t texture_words = 0;
  enum class Expect { header, counts, data } expect = Expect::header;
  std::string_view rest = bytes;
  for (std::size_t number = 1; !rest.empty(); ++number) {
    const std::string_view line = take_line(rest);
    split(line.substr(0, line.find('#')), words);
    if (!words.empty() && expect == Expect::header) {
      constexpr std::array<std::string_view, 8> known = {"OFF",   "COFF",   "NOFF",   "CNOFF",
                                                         "STOFF", "STCOFF", "STNOFF", "STCNOFF"};
      if (std::ranges::find(known, words[0]) == known.end()) {
        fail(number, "expected OFF");
      }
      if (words.size() > 1 && words[1] == "BINARY") {
        return std::string(bytes);
      }
      plain.append(words[0]).append("\n");
      normal_words = words[0].ends_with("NOFF") ? 3 : 0;
      texture_words = words[0].starts_with("ST") ? 2 : 0;
      words.erase(words.begin());
      expect = Expect::counts;
    }
    if (words.empty()) {
      continue;
    }
    std::size_t kept = 3;
    if (expect == Expect::counts) {
      if (words.size() < 2 || !read_integer(words[0], vertices) || !read_integer(words[1], faces)) {
        fail(number, "expected the numbers of vertices and faces");
      }
      words.resize(2);
      words.emplace_back("0");  // edges, which nobody needs
      expect = Expect::data;
    } else if (vertices > 0) {
      kept += normal_words;
      if (words.size() < kept || !std::all_of(words.begin(), words.begin() + 3, is_coordinate)) {
        fail(number, "a vertex needs three finite numbers");
      }
      --vertices;
      words.resize(kept);
      words.insert(words.end(), texture_words, "0");
      kept = words.size();
    } else if (faces > 0) {
      std::size_t corners = 0;
      if (!read_integer(words[0], corners) || corners >= words.size()) {
        fail(number, "a face needs a number of corners, and as many corners");
      }
      kept = 1 + corners;
      --faces;
    } else {
      break;
    }
    for (std::size_t i = 0; i < kept; ++i) {
      plain.append(words[i]).append(i + 1 < kept ? " " : "");
    }
    plain.append("\n");
  }
  if (expect != Expect::data || vertices + faces > 0) {
    throw std::invalid_argument("ends before its last vertex or face");
  }
  return plain;
}

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
  fail(line, fmt::format("unknown type '{:.40}'", type));
}

}  // namespace

PlainPly plain_ply(std::string_view bytes) {
  PlainPly plain;
  std::string header;
  std::vector<Element> elements;
  Words words;
  std::string_view rest = bytes;
  for (std::size_t number = 1;; ++number) {
    if (rest.empty()) {
      fail(number, "expected end_header");
    }
    split(take_line(rest), words);
    if (number == 1) {
      if (words.size() != 1 || words[0] != "ply") {
        fail(number, "expected ply");
      }
      header += "ply\n";
    } else if (words.empty() || words[0] == "comment" || words[0] == "obj_info") {
      continue;
    } else if (words[0] == "format" && words.size() == 3 && header.size() == 4) {
      if (words[1] != "ascii" && words[1] != "binary_little_endian" &&
          words[1] != "binary_big_endian") {
        fail(number, fmt::format("unknown format '{:.40}'", words[1]));
      }
      plain.binary = words[1] != "ascii";
      header += fmt::format("format {} 1.0\n", words[1]);
    } else if (words[0] == "element" && words.size() == 3 && header.size() > 4) {
      Element element{.name = words[1]};
      if (!read_integer(words[2], element.count)) {
        fail(number, "an element needs a number");
      }
      // What comes after the faces need not be read.
      element.skipped =
          !elements.empty() && (elements.back().skipped || elements.back().name == "face");
      if (!element.skipped && element.name != "vertex" && element.name != "face") {
        fail(number, fmt::format("elements '{:.40}' before the faces are not supported", words[1]));
      }
      if (!element.skipped) {
        header += fmt::format("element {} {}\n", element.name, element.count);
      }
      elements.push_back(element);
    } else if (words[0] == "property" && words.size() == 3 && !elements.empty()) {
      const std::uint64_t size = type_size(words[1], number);
      elements.back().least_bytes += plain.binary ? size : 2;
      if (!elements.back().skipped) {
        header += fmt::format("property {} {}\n", words[1], words[2]);
      }
    } else if (words[0] == "property" && words.size() == 5 && words[1] == "list" &&
               !elements.empty()) {
      const std::uint64_t size = type_size(words[2], number);
      elements.back().least_bytes += plain.binary ? size : 2;
      type_size(words[3], number);
      const bool corners = words[4] == "vertex_indices" || words[4] == "vertex_index";
      if (!elements.back().skipped) {
        if (elements.back().name != "face" || !corners) {
          fail(number, fmt::format("the list '{:.40}' is not supported", words[4]));
        }
        header += fmt::format("property list {} {} vertex_indices\n", words[2], words[3]);
      }
    } else if (words.size() == 1 && words[0] == "end_header") {
      break;
    } else {
      fail(number, fmt::format("'{:.40}' is not expected here", words[0]));
    }
  }
  for (const Element& element : elements) {
    if (!element.skipped &&
        (element.least_bytes == 0 || element.count > (rest.size() + 1) / element.least_bytes)) {
      throw std::invalid_argument(
          fmt::format("the header promises {} of '{:.40}', more than the file holds", element.count,
                      element.name));
    }
  }
  plain.bytes = header + "end_header\n";
  plain.bytes += rest;
  return plain;
}

bool is_binary_stl(std::string_view bytes) {
  constexpr std::size_t head = 84;
  std::uint64_t promised = 0;
  for (std::size_t i = 0; i < 4 && bytes.size() >= head; ++i) {
    promised |= std::uint64_t{static_cast<unsigned char>(bytes[80 + i])} << (8 * i);
  }
  const bool fits = bytes.size() >= head && bytes.size() - head == 50 * promised;
  // Some binary files begin with solid, too.
  const std::size_t begin = bytes.find_first_not_of(" \t\r\n");
  if (fits || begin == std::string_view::npos || !bytes.substr(begin).starts_with("solid")) {
    if (bytes.size() < head || bytes.size() - head < 50 * promised) {
      throw std::invalid_argument(
          bytes.size() < head
              ? "is neither a text STL file nor long enough for a binary one"
              : fmt::format("the header promises {} triangles, but the file holds {}", promised,
                            (bytes.size() - head) / 50));
    }
    return true;
  }
  Words words;
  constexpr std::array<std::string_view, 7> facet = {"facet",  "outer",   "vertex",  "vertex",
                                                     "vertex", "endloop", "endfacet"};
  std::size_t step = 0;
  bool ended = false;
  std::string_view rest = bytes;
  for (std::size_t number = 1; !rest.empty(); ++number) {
    split(take_line(rest), words);
    if (words.empty() || words[0] == "solid") {
      continue;
    }
    ended = words[0] == "endsolid" && step == 0;
    if (ended) {
      continue;
    }
    if (words[0] != facet[step]) {
      fail(number, fmt::format("expected {}, but found '{:.40}'", facet[step], words[0]));
    }
    if (words[0] == "vertex" &&
        (words.size() != 4 || !std::all_of(words.begin() + 1, words.end(), is_coordinate))) {
      fail(number, "a vertex needs three finite numbers");
    }
    step = (step + 1) % facet.size();
  }
  if (!ended) {
    throw std::invalid_argument("ends before endsolid");
  }
  return false;
}

}  // namespace raycat
