#include "io/meshes/mesh_text.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>

#include <fmt/format.h>

#include "io/meshes/mesh_words.hpp"

namespace raycat {

std::string plain_obj(std::string_view bytes) {
  std::string plain;
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
    split(line.substr(0, line.find('#')), words);
    if (words.empty() || (words[0] != "v" && words[0] != "f")) {
      continue;
    }
    plain += words[0];
    if (words[0] == "v") {
      require_coordinates(words, 1, number);
      words.resize(4);
    } else if (words.size() < 4) {
      refuse_line(number, "a face needs three corners");
    }
    for (std::size_t i = 1; i < words.size(); ++i) {
      const std::string_view word = words[i].substr(0, words[i].find('/'));
      std::int32_t index = 0;
      if (words[0] == "f" && (!read_integer(word, index) || index == 0)) {
        refuse_line(number, fmt::format("'{:.40}' is no corner of a face", words[i]));
      }
      plain += ' ';
      plain += word;
    }
    plain += '\n';
  }
  return plain;
}

namespace {

// An OFF file in text, taken line by line.
class Off {
 public:
  // False past the last face. Words that the header is followed by are those of the next line.
  bool take(MeshWords& words, std::size_t line);

  bool binary() const { return binary_; }

  // Throws `std::invalid_argument` if something is missing.
  const std::string& plain() const;

 private:
  enum class Expect { header, counts, data };

  void take_header(MeshWords& words, std::size_t line);
  void take_counts(const MeshWords& words, std::size_t line);
  void take_vertex(const MeshWords& words, std::size_t line);
  void take_face(const MeshWords& words, std::size_t line);
  void put(const MeshWords& words, std::size_t count);

  Expect expect_ = Expect::header;
  bool binary_ = false;
  std::size_t normal_words_ = 0;
  std::string_view texture_;
  std::uint64_t vertices_ = 0;
  std::uint64_t faces_ = 0;
  std::string plain_;
};

bool Off::take(MeshWords& words, std::size_t line) {
  if (expect_ == Expect::header && !words.empty()) {
    take_header(words, line);
  }
  if (words.empty() || binary_) {
    return true;
  }
  if (expect_ == Expect::counts) {
    take_counts(words, line);
  } else if (vertices_ > 0) {
    take_vertex(words, line);
  } else if (faces_ > 0) {
    take_face(words, line);
  } else {
    return false;
  }
  return true;
}

void Off::take_header(MeshWords& words, std::size_t line) {
  constexpr std::array<std::string_view, 8> known = {"OFF",   "COFF",   "NOFF",   "CNOFF",
                                                     "STOFF", "STCOFF", "STNOFF", "STCNOFF"};
  if (std::ranges::find(known, words[0]) == known.end()) {
    refuse_line(line, "expected OFF");
  }
  binary_ = words.size() > 1 && words[1] == "BINARY";
  plain_.append(words[0]).append("\n");
  normal_words_ = words[0].ends_with("NOFF") ? 3 : 0;
  texture_ = words[0].starts_with("ST") ? " 0 0" : "";
  words.erase(words.begin());
  expect_ = Expect::counts;
}

void Off::take_counts(const MeshWords& words, std::size_t line) {
  if (words.size() < 2 || !read_integer(words[0], vertices_) || !read_integer(words[1], faces_)) {
    refuse_line(line, "expected the numbers of vertices and faces");
  }
  put(words, 2);
  plain_.append(" 0\n");  // edges, which nobody needs
  expect_ = Expect::data;
}

void Off::take_vertex(const MeshWords& words, std::size_t line) {
  require_coordinates(words, 0, line);
  if (words.size() < 3 + normal_words_) {
    refuse_line(line, "a vertex needs three finite numbers");
  }
  put(words, 3 + normal_words_);
  plain_.append(texture_).append("\n");
  --vertices_;
}

void Off::take_face(const MeshWords& words, std::size_t line) {
  std::size_t corners = 0;
  if (!read_integer(words[0], corners) || corners >= words.size()) {
    refuse_line(line, "a face needs a number of corners, and as many corners");
  }
  put(words, 1 + corners);
  plain_.append("\n");
  --faces_;
}

void Off::put(const MeshWords& words, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    plain_.append(i == 0 ? "" : " ").append(words[i]);
  }
}

const std::string& Off::plain() const {
  if (expect_ != Expect::data || vertices_ + faces_ > 0) {
    throw std::invalid_argument("ends before its last vertex or face");
  }
  return plain_;
}

}  // namespace

std::string plain_off(std::string_view bytes) {
  Off off;
  MeshWords words;
  std::string_view rest = bytes;
  for (std::size_t line = 1; !rest.empty(); ++line) {
    const std::string_view text = take_line(rest);
    split(text.substr(0, text.find('#')), words);
    if (!off.take(words, line)) {
      break;
    }
    if (off.binary()) {
      return std::string(bytes);
    }
  }
  return off.plain();
}

namespace {

// Throws `std::invalid_argument` unless all facets are whole.
void require_whole_facets(std::string_view text) {
  MeshWords words;
  constexpr std::array<std::string_view, 7> facet = {"facet",  "outer",   "vertex",  "vertex",
                                                     "vertex", "endloop", "endfacet"};
  std::size_t step = 0;
  bool ended = false;
  for (std::size_t number = 1; !text.empty(); ++number) {
    split(take_line(text), words);
    if (words.empty() || words[0] == "solid") {
      continue;
    }
    ended = words[0] == "endsolid" && step == 0;
    if (ended) {
      continue;
    }
    if (words[0] != facet[step]) {
      refuse_line(number, fmt::format("expected {}, but found '{:.40}'", facet[step], words[0]));
    }
    if (words[0] == "vertex") {
      require_coordinates(words, 1, number);
      if (words.size() > 4) {
        refuse_line(number, "a vertex needs three finite numbers");
      }
    }
    step = (step + 1) % facet.size();
  }
  if (!ended) {
    throw std::invalid_argument("ends before endsolid");
  }
}

}  // namespace

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
  require_whole_facets(bytes);
  return false;
}

}  // namespace raycat
