#include "io/images/provenance.hpp"

#include <algorithm>

namespace raycat {
namespace {

std::string one_line(std::string text) {
  std::ranges::replace_if(
      text, [](unsigned char c) { return c < 0x20; }, ' ');
  return text;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> provenance_texts(
    const Provenance& from, const std::string& scene_keyword) {
  std::vector<std::pair<std::string, std::string>> texts{
      {"Software", one_line(from.command)}, {scene_keyword, one_line("scene " + from.scene)}};
  if (!from.legend.empty()) {
    texts.emplace_back("Legend", one_line(from.legend));
  }
  return texts;
}

}  // namespace raycat
