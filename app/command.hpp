#pragma once

#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/options.hpp"

namespace raycat::app {

/// Adds an option that takes one of a few words. Anything else is refused, naming them.
template <typename Value>
CLI::Option* add_choice(CLI::App& command, const std::string& name, Value& target,
                        const std::vector<std::pair<std::string, Value>>& choices,
                        const std::string& help) {
  return command.add_option_function<std::string>(
      name,
      [&target, name, choices](const std::string& word) {
        std::string words;
        for (const auto& [choice, value] : choices) {
          if (choice == word) {
            target = value;
            return;
          }
          words += (words.empty() ? "" : ", ") + choice;
        }
        throw CLI::ValidationError(name, "'" + word + "' is not one of " + words);
      },
      help);
}

/// Accepts finite numbers from `low` to `high`.
CLI::Validator number_in(double low, double high);

/// Adds the arguments of `options` to `command`.
void add_common(CLI::App& command, CommonOptions& options);

/// Each adds its subcommand to `app`; the parser then calls it.
void add_render(CLI::App& app);
void add_info(CLI::App& app);
void add_probe(CLI::App& app);
void add_compare(CLI::App& app);
void add_study(CLI::App& app);
void add_measure(CLI::App& app);
void add_convert(CLI::App& app);

}  // namespace raycat::app
