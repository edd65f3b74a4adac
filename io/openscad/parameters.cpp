#include "io/openscad/parameters.hpp"

#include <algorithm>
#include <variant>

#include <fmt/format.h>

namespace raycat::openscad {

Parameters::Parameters(Context& context, const Node& node,
                       std::initializer_list<std::string_view> names,
                       std::initializer_list<std::string_view> others)
    : context_(context), node_(node), names_(names) {
  std::size_t unnamed = 0;
  for (const Argument& argument : node.arguments) {
    const bool known = argument.name.empty()
                           ? unnamed++ < names_.size()
                           : std::ranges::count(names_, argument.name) != 0 ||
                                 std::ranges::count(others, argument.name) != 0 ||
                                 argument.name.starts_with('$') || argument.name == "timestamp";
    if (!known) {
      context.warn(node,
                   fmt::format("{} is ignored",
                               argument.name.empty()
                                   ? std::string("a surplus parameter")
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

std::string Parameters::text(std::string_view name, const std::string& otherwise) const {
  const Value* const value = find(name);
  if (value == nullptr) {
    return otherwise;
  }
  if (!std::holds_alternative<std::string>(value->is)) {
    fail(fmt::format("{} must be a string", name));
  }
  return std::get<std::string>(value->is);
}

const Vector& Parameters::vector(std::string_view name) const {
  const Value* const value = find(name);
  if (value == nullptr || value->vector() == nullptr) {
    fail(fmt::format("{} must be a vector", name));
  }
  return *value->vector();
}

double Parameters::radius(std::string_view by_radius, std::string_view by_diameter,
                          double otherwise) const {
  return find(by_diameter) != nullptr ? 0.5 * number(by_diameter, 2.0 * otherwise)
                                      : number(by_radius, otherwise);
}

glm::dvec3 Parameters::axes(std::string_view name, std::size_t count,
                            const glm::dvec3& otherwise) const {
  constexpr std::string_view names = "x, y, z";
  const auto refuse = [&]() {
    fail(fmt::format("{} must be a number or [{}]", name, names.substr(0, 3 * count - 2)));
  };
  const Value* const value = find(name);
  if (value == nullptr) {
    return otherwise;
  }
  if (value->number() != nullptr) {
    return glm::dvec3(*value->number());
  }
  if (value->vector() == nullptr || value->vector()->size() != count) {
    refuse();
  }
  glm::dvec3 out = otherwise;
  for (std::size_t axis = 0; axis < count; ++axis) {
    const Value& one = (*value->vector())[axis];
    if (std::holds_alternative<Unknown>(one.is)) {
      break;  // OpenSCAD reads no further
    }
    if (one.number() == nullptr) {
      refuse();
    }
    out[static_cast<int>(axis)] = *one.number();
  }
  return out;
}

FacetRule Parameters::facets() const {
  return {.number = number("$fn", context_.facets.number),
          .angle = number("$fa", context_.facets.angle),
          .size = number("$fs", context_.facets.size)};
}

std::uint32_t Parameters::corners(double radius) const {
  return context_.corners(node_, facets(), radius);
}

}  // namespace raycat::openscad
