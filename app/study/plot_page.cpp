#include "app/study/plot_page.hpp"

#include <algorithm>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <cairo-svg.h>
#include <cairo.h>
#include <fmt/format.h>

namespace raycat {
namespace {

cairo_status_t append(void* text, const unsigned char* bytes, unsigned int count) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

void require(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS) {
    throw std::runtime_error(fmt::format("a plot: {}", cairo_status_to_string(status)));
  }
}

// The font has no letters but these.
std::string ascii(std::string text) {
  std::ranges::replace_if(
      text, [](unsigned char c) { return c < 0x20 || c > 0x7e; }, '?');
  return text;
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&' || c == '<' || c == '>') {
      result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : "&gt;";
    } else {
      result += c;
    }
  }
  return result;
}

// Cairo numbers its surfaces throughout the process, and what was drawn before is not to show.
void drop_surface_number(std::string& file) {
  const std::string before = "id=\"surface";
  if (const std::size_t at = file.find(before); at != std::string::npos) {
    const std::size_t number = at + before.size();
    file.erase(number, file.find('"', number) - number);
  }
}

}  // namespace

struct PlotPage::Cairo {
  Kind kind;
  std::string file;   // what has been written of it
  std::string words;  // SVG elements
  cairo_surface_t* surface;
  cairo_t* context;

  Cairo(Kind kind_in, int width, int height)
      : kind(kind_in),
        surface(kind == Kind::svg
                    ? cairo_svg_surface_create_for_stream(append, &file, width, height)
                    : cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height)),
        context(cairo_create(surface)) {}
  ~Cairo() {
    cairo_destroy(context);
    cairo_surface_destroy(surface);
  }
  Cairo(const Cairo&) = delete;
  Cairo& operator=(const Cairo&) = delete;

  void set_colour(const glm::dvec3& colour) const {
    cairo_set_source_rgb(context, colour.r, colour.g, colour.b);
  }

  void path(std::span<const glm::dvec2> points) const {
    cairo_new_path(context);  // words leave a point behind
    for (const glm::dvec2& point : points) {
      cairo_line_to(context, point.x, point.y);
    }
  }
};

PlotPage::PlotPage(Kind kind, int width, int height)
    : cairo_(std::make_unique<Cairo>(kind, width, height)) {
  cairo_set_line_join(cairo_->context, CAIRO_LINE_JOIN_ROUND);
  cairo_->set_colour({1, 1, 1});
  cairo_paint(cairo_->context);
  // The font that cairo brings along, so that files do not depend on the fonts of the machine.
  cairo_select_font_face(cairo_->context, "@cairo:", CAIRO_FONT_SLANT_NORMAL,
                         CAIRO_FONT_WEIGHT_NORMAL);
}

PlotPage::~PlotPage() = default;

void PlotPage::line(std::span<const glm::dvec2> points, const glm::dvec3& colour, double width,
                    bool dashed) {
  const double dash[] = {7.0, 5.0};
  cairo_set_dash(cairo_->context, dash, dashed ? 2 : 0, 0.0);
  cairo_->set_colour(colour);
  cairo_set_line_width(cairo_->context, width);
  cairo_->path(points);
  cairo_stroke(cairo_->context);
}

void PlotPage::polygon(std::span<const glm::dvec2> corners, const glm::dvec3& colour, bool hollow) {
  cairo_set_dash(cairo_->context, nullptr, 0, 0.0);
  cairo_->path(corners);
  cairo_close_path(cairo_->context);
  cairo_->set_colour(hollow ? glm::dvec3(1.0) : colour);
  cairo_fill_preserve(cairo_->context);
  cairo_->set_colour(colour);
  cairo_set_line_width(cairo_->context, hollow ? 1.6 : 0.8);
  cairo_stroke(cairo_->context);
}

void PlotPage::text(const glm::dvec2& at, const std::string& words, Align align, double size,
                    bool upright) {
  const std::string line = ascii(words);
  if (cairo_->kind == Kind::svg) {
    // Cairo would write the shapes of the letters; as elements they stay words.
    static const char* const anchors[] = {"start", "middle", "end"};
    cairo_->words += fmt::format(
        "<text x=\"{:.2f}\" y=\"{:.2f}\" font-family=\"sans-serif\" font-size=\"{}\" "
        "text-anchor=\"{}\"{}>{}</text>\n",
        at.x, at.y, size, anchors[static_cast<int>(align)],
        upright ? fmt::format(" transform=\"rotate(-90 {:.2f} {:.2f})\"", at.x, at.y) : "",
        escaped(line));
    return;
  }
  cairo_t* context = cairo_->context;
  cairo_save(context);
  cairo_->set_colour({0, 0, 0});
  cairo_set_font_size(context, size);
  cairo_text_extents_t extents;
  cairo_text_extents(context, line.c_str(), &extents);
  cairo_translate(context, at.x, at.y);
  cairo_rotate(context, upright ? -std::numbers::pi / 2 : 0.0);
  cairo_move_to(context, -0.5 * static_cast<double>(align) * extents.x_advance, 0);
  cairo_show_text(context, line.c_str());
  cairo_restore(context);
}

std::string PlotPage::finish() {
  require(cairo_status(cairo_->context));
  std::string& file = cairo_->file;
  if (cairo_->kind == Kind::png) {
    require(cairo_surface_write_to_png_stream(cairo_->surface, append, &file));
    return std::move(file);
  }
  cairo_surface_finish(cairo_->surface);
  require(cairo_surface_status(cairo_->surface));
  drop_surface_number(file);
  file.insert(file.rfind("</svg>"), cairo_->words);
  return std::move(file);
}

}  // namespace raycat
