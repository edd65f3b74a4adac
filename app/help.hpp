#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace raycat::app {

/// The groups of options in `--help`.
namespace groups {
inline const std::string picture = "Picture";
inline const std::string maps = "Maps";
inline const std::string view = "View";
inline const std::string scene = "Scene";
inline const std::string categories = "Categories";
inline const std::string limits = "Limits";
inline const std::string general = "General";
}  // namespace groups

/// Options that are added to `command` from now on are of this group.
void start_group(CLI::App& command, const std::string& group);

/// Lists options group by group, in the order above, which does not depend on where they are added.
class GroupedHelp : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* command, std::string name,
                        CLI::AppFormatMode mode) const override;

  /// Without the options that it excludes, which an error names where they meet.
  std::string make_option_opts(const CLI::Option* option) const override {
    const std::string text = Formatter::make_option_opts(option);
    return text.substr(0, text.find(" Excludes:"));
  }
};

}  // namespace raycat::app
