#include "categories/path_names.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include <fmt/format.h>

#include "categories/path_error.hpp"
#include "categories/path_text.hpp"

namespace raycat::paths {
namespace {

constexpr std::size_t most_suggestions = 3;
constexpr std::size_t longest_misspelt = 64;

// How many characters must be added, left out or replaced to make one of the other.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (const char letter : a) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (letter == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row[b.size()];
}

// Those of `names` that differ in up to two characters from `wrong`, nearest first.
std::vector<std::string_view> near(std::string_view wrong,
                                   const std::vector<std::string_view>& names) {
  std::vector<std::string_view> found;
  for (std::size_t differences = 0; differences <= 2; ++differences) {
    for (const std::string_view name : names) {
      const bool possible = wrong.size() <= longest_misspelt && differences < wrong.size() &&
                            name.size() <= wrong.size() + 2 && wrong.size() <= name.size() + 2;
      if (found.size() < most_suggestions && possible && distance(wrong, name) == differences) {
        found.push_back(name);
      }
    }
  }
  return found;
}

// "'a', 'b' and 3 more", of which `names` are the first.
std::string listed(const std::vector<std::string_view>& names, std::size_t more) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const bool last = i + 1 == names.size() && more == 0;
    text += i == 0 ? "" : last ? " and " : ", ";
    text += quote(names[i]);
  }
  return more == 0 ? text : fmt::format("{} and {} more", text, more);
}

class Names {
 public:
  Names(const SurfaceTable& surfaces, std::span<const std::string> lights) {
    for (std::size_t i = 0; i < surfaces.objects(); ++i) {
      add(objects_, surfaces.name(ObjectId{static_cast<std::uint32_t>(i)}));
    }
    for (const std::string& name : lights) {
      add(lights_, name);
    }
  }

  // Throws unless something that `use` could mean is called `name`.
  void require(const NameUse& use, std::string_view name) const {
    const bool object = (use.types & (scattering_events | hit_event)) != 0;
    const bool light = (use.types & light_event) != 0;
    if ((object && objects_.known.contains(name)) || (light && lights_.known.contains(name))) {
      return;
    }
    const std::string what = object && light ? "object or light" : object ? "object" : "light";
    std::string message = fmt::format("no {} is named {}", what, quote(name));
    Known candidates;
    for (const Known* known : {object ? &objects_ : nullptr, light ? &lights_ : nullptr}) {
      for (std::size_t i = 0; known != nullptr && i < known->names.size(); ++i) {
        add(candidates, known->names[i]);
      }
    }
    if (!object && objects_.known.contains(name)) {
      message += ", but an object is";
    } else if (!light && lights_.known.contains(name)) {
      message += ", but a light is";
    } else if (candidates.names.empty()) {
      message += fmt::format(": there is no {}", what);
    } else {
      message += ": " + suggestion(name, std::move(candidates.names));
    }
    throw PathError(use.column, message);
  }

 private:
  struct Known {
    std::vector<std::string_view> names;  // distinct, in the order of the scene
    std::unordered_set<std::string_view> known;
  };

  static void add(Known& to, std::string_view name) {
    if (to.known.insert(name).second) {
      to.names.push_back(name);
    }
  }

  static std::string suggestion(std::string_view wrong, std::vector<std::string_view> names) {
    const std::vector<std::string_view> alike = near(wrong, names);
    if (!alike.empty()) {
      return (alike.size() == 1 ? "near it is " : "near it are ") + listed(alike, 0);
    }
    const std::size_t more = names.size() - std::min(names.size(), most_suggestions);
    names.resize(names.size() - more);
    return (names.size() == 1 ? "there is only " : "there are ") + listed(names, more);
  }

  Known objects_;
  Known lights_;
};

}  // namespace

Classes classify(const PathSyntax& syntax, const SurfaceTable& surfaces,
                 std::span<const std::string> lights) {
  if (lights.size() > most_lights) {
    throw std::length_error(fmt::format("path expressions know at most {} lights, but there are {}",
                                        most_lights, lights.size()));
  }
  const Names names(surfaces, lights);
  std::unordered_map<std::string_view, NameClass> class_of;
  for (const NameUse& use : syntax.uses) {
    const std::string& name = syntax.names[use.name - 1];
    names.require(use, name);
    class_of.emplace(name, use.name);
  }
  const auto find = [&](std::string_view name) {
    const auto found = class_of.find(name);
    return found == class_of.end() ? NameClass{0} : found->second;
  };
  Classes classes{.lights = std::vector<LightMask>(syntax.classes(), 0)};
  for (std::size_t i = 0; i < surfaces.objects(); ++i) {
    classes.of_object.push_back(find(surfaces.name(ObjectId{static_cast<std::uint32_t>(i)})));
  }
  LightMask mentioned = 0;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    if (const NameClass named = find(lights[i]); named != 0) {
      classes.lights[named] |= LightMask{1} << i;
      mentioned |= LightMask{1} << i;
    }
  }
  classes.lights[0] = ~mentioned;
  return classes;
}

}  // namespace raycat::paths
