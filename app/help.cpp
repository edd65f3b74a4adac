#include "app/help.hpp"

#include <array>

namespace raycat::app {

void start_group(CLI::App& command, const std::string& group) {
  command.option_defaults()->group(group);
}

std::string GroupedHelp::make_help(const CLI::App* command, std::string name,
                                   CLI::AppFormatMode mode) const {
  if (mode == CLI::AppFormatMode::Sub) {
    return make_expanded(command);
  }
  std::string text =
      make_description(command) + make_usage(command, std::move(name)) + make_positionals(command);
  const std::array order{groups::picture,    groups::maps,   groups::view,   groups::scene,
                         groups::categories, groups::limits, groups::general};
  for (const std::string& group : order) {
    const std::vector<const CLI::Option*> options =
        command->get_options([&](const CLI::Option* option) {
          return option->get_group() == group && option->nonpositional();
        });
    if (!options.empty()) {
      text += make_group(group, false, options);
    }
  }
  return text + make_subcommands(command, mode) + "\n" + make_footer(command);
}

}  // namespace raycat::app
