#include "io/openscad_parameters.hpp"

#include <algorithm>
#include <variant>

#include <fmt/format.h>

#include "io/openscad_lexer.hpp"
#include "io/scene_file.hpp"

namespace raycat::openscad {

Parameters::Parameters(const std::filesystem::path& file, const Node& node,
                       std::initializer_list<std::string_view> names,
                       std::initializer_list<std::string_view> others,
                       std::vector<std::string>& warnings)
    : file_(file), node_(node), names_(names) {
  std::size_t unnamed = 0;
  for (const Argument& argument : node.arguments) {
    const bool known = argument.name.empty()
                           ? unnamed++ < names_.size()
                           : std::ranges::count(names_, argument.name) != 0 ||
                                 std::ranges::count(others, argument.name) != 0 ||
                                 argument.name.starts_with('$') || argument.name == "timestamp";
    if (!known) {
      warnings.push_back(fmt::format(
          "line {}: {}: {} is ignored", node.line, node.name,
          argument.name.empty() ? std::string("a surplus parameter")
                                : fmt::format("the unknown parameter {:.40}", argument.name)));
    }
  }
}

const Value* Parameters::find(std::string_view name) const {
  const Value* found = nullptr;
  std::size_t unnamed = 0;
  for (const Argument& argument : node_.arguments) {
    std::string_view meant = argument.name;
    if (meant.empty()) {
      meant = unnamed < names_.size() ? names_[unnamed] : std::string_view();
      ++unnamed;
    }
    if (meant == name) {
      found = std::holds_alternative<Unknown>(argument.value.is) ? nullptr : &argument.value;
    }
  }
  return found;
}

double Parameters::number(std::string_view name, double otherwise) const {
  const Value* const value = find(name);
  if (value == nullptr) {
    return otherwise;
  }
  if (value->number() == nullptr) {
    fail(fmt::format("{} must be a number", name));
  }
  return *value->number();
}

bool Parameters::flag(std::string_view name, bool otherwise) const {
  const Value* const value = find(name);
  if (value == nullptr) {
    return otherwise;
  }
  if (value->number() != nullptr) {
    return *value->number() != 0.0;
  }
  if (!std::holds_alternative<bool>(value->is)) {
    fail(fmt::format("{} must be true or false", name));
  }
  return std::get<bool>(value->is);
}

const Vector& Parameters::vector(std::string_view name) const {
  const Value* const value = find(name);
  if (value == nullptr || value->vector() == nullptr) {
    fail(fmt::format("{} must be a vector", name));
  }
  return *value->vector();
}

void Parameters::fail(const std::string& what) const {
  throw LoadError(file_, line_place(node_.line), fmt::format("{}: {}", node_.name, what));
}

}  // namespace raycat::openscad
