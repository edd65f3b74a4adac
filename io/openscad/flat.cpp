#include "io/openscad/flat.hpp"

#include <cmath>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "io/openscad/parameters.hpp"
#include "modelling/text_outline.hpp"

namespace raycat::openscad {

namespace {

Polygons square(Context& context, const Node& node) {
  const Parameters parameters(context, node, {"size", "center"}, {});
  const glm::dvec2 size = parameters.axes("size", 2, glm::dvec3(1.0));
  const bool centred = parameters.flag("center", false);
  if (!(size.x > 0.0 && size.y > 0.0)) {
    return {};
  }
  const glm::dvec2 low = centred ? -0.5 * size : glm::dvec2(0.0);
  const glm::dvec2 high = low + size;
  return {.contours = {{low, {high.x, low.y}, high, {low.x, high.y}}}};
}

Polygons circle(Context& context, const Node& node) {
  const Parameters parameters(context, node, {"r"}, {"d"});
  const double radius = parameters.radius("r", "d", 1.0);
  if (!(radius > 0.0)) {
    return {};
  }
  return {.contours = {circle_corners(radius, parameters.corners(radius))}};
}

glm::dvec2 point(const Parameters& parameters, const Value& value, std::size_t index) {
  const Vector* const from = value.vector();
  if (from == nullptr || from->size() != 2 || (*from)[0].number() == nullptr ||
      (*from)[1].number() == nullptr) {
    parameters.fail(fmt::format("point {} must be [x, y]", index));
  }
  return {*(*from)[0].number(), *(*from)[1].number()};
}

Contour path(const Parameters& parameters, const Value& value, std::size_t index,
             const Contour& points) {
  const auto refuse = [&]() {
    parameters.fail(
        fmt::format("path {} must be a vector of numbers of the {} points", index, points.size()));
  };
  if (value.vector() == nullptr) {
    refuse();
  }
  Contour out;
  for (const Value& corner : *value.vector()) {
    const double* const number = corner.number();
    if (number == nullptr || *number != std::floor(*number) || *number < 0.0 ||
        !(*number < static_cast<double>(points.size()))) {
      refuse();
    }
    out.push_back(points[static_cast<std::size_t>(*number)]);
  }
  return out;
}

Polygons polygon(Context& context, const Node& node) {
  const Parameters parameters(context, node, {"points", "paths", "convexity"}, {});
  Contour points;
  for (const Value& value : parameters.vector("points")) {
    points.push_back(point(parameters, value, points.size()));
  }
  std::vector<Contour> contours;
  if (parameters.find("paths") == nullptr || parameters.vector("paths").empty()) {
    contours.push_back(std::move(points));
  } else {
    const Vector& paths = parameters.vector("paths");
    if (paths.front().vector() == nullptr) {  // one path, not in a vector of its own
      contours.push_back(path(parameters, *parameters.find("paths"), 0, points));
    } else {
      for (const Value& value : paths) {
        contours.push_back(path(parameters, value, contours.size(), points));
      }
    }
  }
  return even_odd(contours);
}

Polygons text(Context& context, const Node& node) {
  const Parameters parameters(context, node, {"text", "size", "font"},
                              {"spacing", "direction", "language", "script", "halign", "valign"});
  TextStyle style;
  style.font = parameters.text("font", style.font);
  style.size = parameters.number("size", style.size);
  style.spacing = parameters.number("spacing", style.spacing);
  style.direction = parameters.text("direction", style.direction);
  style.horizontal = parameters.text("halign", style.horizontal);
  style.vertical = parameters.text("valign", style.vertical);
  style.language = parameters.text("language", style.language);
  style.script = parameters.text("script", style.script);
  style.facets = parameters.corners(std::abs(style.size));
  return text_outline(parameters.text("text", ""), style);
}

}  // namespace

Polygons flat_primitive(Context& context, const Node& node) {
  if (node.name == "square") {
    return square(context, node);
  }
  if (node.name == "circle") {
    return circle(context, node);
  }
  return node.name == "polygon" ? polygon(context, node) : text(context, node);
}

}  // namespace raycat::openscad
