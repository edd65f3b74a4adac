#pragma once

#include <string>

namespace raycat {

/// A font on this machine.
struct FontFile {
  std::string path;
  int index = 0;  ///< of the font in the file
};

/// What fontconfig finds for a pattern. Throws `std::runtime_error` if it is of another family.
FontFile font_file(const std::string& pattern);

}  // namespace raycat
