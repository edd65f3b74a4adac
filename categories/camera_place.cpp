#include "categories/camera_place.hpp"

#include "categories/path_error.hpp"

namespace raycat::paths {
namespace {

// Where a part of an expression can be in a word, for some word.
struct Place {
  bool first = false;  ///< with nothing before it
  bool later = false;  ///< with something before it
};

struct Check {
  Place place;

  void operator()(const CameraEvent&, std::size_t column) const {
    if (place.later) {
      throw PathError(column, "expected no C here: C, the camera, comes first and once");
    }
  }

  void operator()(const EventSet&, std::size_t column) const {
    if (place.first) {
      throw PathError(column, "expected C, the camera, before anything else");
    }
  }

  void operator()(const Sequence& sequence, std::size_t) const {
    Place next = place;
    for (const PathNode& part : sequence.parts) {
      check(part, next);
      next = {.first = next.first && part.optional, .later = true};
    }
  }

  void operator()(const Choice& choice, std::size_t) const {
    for (const PathNode& part : choice.parts) {
      check(part, place);
    }
  }

  void operator()(const Repetition& repetition, std::size_t) const {
    const bool again = repetition.most != 1;
    check(repetition.part.front(), {.first = place.first, .later = place.later || again});
  }

  static void check(const PathNode& node, const Place& place) {
    std::visit([&](const auto& form) { Check{place}(form, node.column); }, node.form);
  }
};

}  // namespace

void require_camera_first(const PathNode& expression) {
  Check::check(expression, {.first = true});
  if (expression.optional) {
    throw PathError(expression.column, "expected C, the camera, but all of this can be left out");
  }
}

}  // namespace raycat::paths
