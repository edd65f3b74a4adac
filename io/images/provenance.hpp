#pragma once

#include <string>
#include <utility>
#include <vector>

namespace raycat {

/// Where an image comes from, written into the file: as text chunks in PNG, attributes in EXR,
/// comments in PPM. What is empty is left out.
struct Provenance {
  std::string command;  ///< that makes it again
  std::string scene;    ///< the scene file
  std::string legend;   ///< what colours mean, where it needs saying
};

/// What a file says of it, each on one line after its keyword: the command after "Software", the
/// scene after `scene_keyword`, for which formats have words of their own, and the legend, if there
/// is one, after "Legend".
std::vector<std::pair<std::string, std::string>> provenance_texts(const Provenance& from,
                                                                  const std::string& scene_keyword);

}  // namespace raycat
