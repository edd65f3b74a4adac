#include "modelling/text_outline.hpp"

#include <stdexcept>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "modelling/extrusion.hpp"
#include "modelling/font_file.hpp"
#include "tests/modelling/openscad_oracle.hpp"

namespace raycat {
namespace {

bool has_dejavu() {
  try {
    font_file("DejaVu Sans");
    return true;
  } catch (const std::runtime_error&) {
    WARN("skipped: no font DejaVu Sans");
    return false;
  }
}

TEST_CASE("a font that is not there is named", "[modelling][text]") {
  CHECK_THROWS_WITH(text_outline("a", {.font = "No Such Font:style=Bold"}),
                    "the font \"No Such Font\" is not on this machine");
  CHECK_THROWS_WITH(text_outline("a", {.font = ":style=Bold"}), "\":style=Bold\" names no font");
}

TEST_CASE("letters have the holes that they have", "[modelling][text]") {
  if (!has_dejavu()) {
    return;
  }
  const auto contours = [](const std::string& text) {
    return text_outline(text, {.font = "DejaVu Sans"}).contours.size();
  };
  CHECK(contours("I") == 1);
  CHECK(contours("i") == 2);
  CHECK(contours("B") == 3);
  CHECK(contours(" ") == 0);
  CHECK(contours("") == 0);
  CHECK(contours("II") == 2);
  const double small = area(text_outline("B", {.font = "DejaVu Sans", .size = 5}));
  CHECK(area(text_outline("B", {.font = "DejaVu Sans", .size = 50})) == Approx(100.0 * small));
}

TEST_CASE("text is OpenSCAD's", "[modelling][text][openscad]") {
  if (!openscad_is_installed() || !has_dejavu()) {
    return;
  }
  const TextStyle plain{.font = "DejaVu Sans"};
  std::vector<std::pair<std::string, TextStyle>> cases;
  const auto add = [&](const std::string& text, auto change) {
    TextStyle style = plain;
    change(style);
    cases.emplace_back(text, style);
  };
  add("Hog, AVA & \u00fc", [](TextStyle&) {});
  add("Hog", [](TextStyle& s) { s.size = 0.7; });
  add("Hog", [](TextStyle& s) { s.size = 33.0; });
  add("Hog", [](TextStyle& s) { s.font = "DejaVu Serif:style=Bold"; });
  for (const char* const direction : {"ltr", "rtl", "ttb", "btt"}) {
    for (const char* const horizontal : {"left", "center", "right"}) {
      add("Hog", [&](TextStyle& s) {
        s.direction = direction;
        s.horizontal = horizontal;
        s.spacing = 1.3;
      });
    }
    for (const char* const vertical : {"top", "center", "bottom"}) {
      add("gyp", [&](TextStyle& s) {
        s.direction = direction;
        s.vertical = vertical;
      });
    }
  }
  for (const auto& [text, style] : cases) {
    for (const double number : {0.0, 5.0, 50.0}) {
      const std::string csg = fmt::format(
          "linear_extrude(height=1,center=false){{text(text=\"{}\",size={},spacing={},font=\"{}\","
          "direction=\"{}\",language=\"en\",script=\"Latn\",halign=\"{}\",valign=\"{}\",$fn={},"
          "$fa=12,$fs=2);}}",
          text, style.size, style.spacing, style.font, style.direction, style.horizontal,
          style.vertical, number);
      INFO(csg);
      TextStyle ours = style;
      ours.facets = facet_count(style.size, {.number = number});
      const TriangleMesh mesh = linear_extrusion(text_outline(text, ours), {.height = 1.0});
      const TriangleMesh reference = openscad_mesh(csg);
      CHECK(volume(mesh) == Approx(volume(reference)).epsilon(3e-3));
      CHECK(compare(ClosedMesh(mesh), ClosedMesh(reference)).bad == 0);
      if (number == 0.0 && style.direction != "ltr") {
        break;
      }
    }
  }
}

}  // namespace
}  // namespace raycat
