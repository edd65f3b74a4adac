#pragma once

#include <string>
#include <string_view>

namespace raycat {

/// `text` on one line of at most 100 characters, for messages that quote a file.
std::string excerpt(std::string_view text);

}  // namespace raycat
