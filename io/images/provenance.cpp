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
  std::vector<std::pair<std::string, std::string>> texts;
  const auto add = [&](const std::string& keyword, const std::string& text) {
    if (!text.empty()) {
      texts.emplace_back(keyword, one_line(text));
    }
  };
  add("Software", from.command);
  add(scene_keyword, from.scene.empty() ? "" : "scene " + from.scene);
  add("Legend", from.legend);
  return texts;
}

}  // namespace raycat
