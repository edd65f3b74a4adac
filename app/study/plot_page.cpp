#include "app/study/plot_page.hpp"

#include <algorithm>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <cairo-svg.h>
#include <cairo.h>
#include <fmt/format.h>

#include "dynamic/shared_library.hpp"

namespace raycat {
namespace {

// What is called of cairo, by its names without "cairo_".
struct CairoFunctions {
  SharedLibrary library{"libcairo.so.2"};
  decltype(cairo_close_path)* close_path = library["cairo_close_path"];
  decltype(cairo_create)* create = library["cairo_create"];
  decltype(cairo_destroy)* destroy = library["cairo_destroy"];
  decltype(cairo_fill_preserve)* fill_preserve = library["cairo_fill_preserve"];
  decltype(cairo_line_to)* line_to = library["cairo_line_to"];
  decltype(cairo_move_to)* move_to = library["cairo_move_to"];
  decltype(cairo_new_path)* new_path = library["cairo_new_path"];
  decltype(cairo_paint)* paint = library["cairo_paint"];
  decltype(cairo_restore)* restore = library["cairo_restore"];
  decltype(cairo_rotate)* rotate = library["cairo_rotate"];
  decltype(cairo_save)* save = library["cairo_save"];
  decltype(cairo_select_font_face)* select_font_face = library["cairo_select_font_face"];
  decltype(cairo_set_dash)* set_dash = library["cairo_set_dash"];
  decltype(cairo_set_font_size)* set_font_size = library["cairo_set_font_size"];
  decltype(cairo_set_line_join)* set_line_join = library["cairo_set_line_join"];
  decltype(cairo_set_line_width)* set_line_width = library["cairo_set_line_width"];
  decltype(cairo_set_source_rgb)* set_source_rgb = library["cairo_set_source_rgb"];
  decltype(cairo_show_text)* show_text = library["cairo_show_text"];
  decltype(cairo_status)* status = library["cairo_status"];
  decltype(cairo_status_to_string)* status_to_string = library["cairo_status_to_string"];
  decltype(cairo_stroke)* stroke = library["cairo_stroke"];
  decltype(cairo_text_extents)* text_extents = library["cairo_text_extents"];
  decltype(cairo_translate)* translate = library["cairo_translate"];
  decltype(cairo_image_surface_create)* image_surface_create =
      library["cairo_image_surface_create"];
  decltype(cairo_surface_destroy)* surface_destroy = library["cairo_surface_destroy"];
  decltype(cairo_surface_finish)* surface_finish = library["cairo_surface_finish"];
  decltype(cairo_surface_status)* surface_status = library["cairo_surface_status"];
  decltype(cairo_surface_write_to_png_stream)* surface_write_to_png_stream =
      library["cairo_surface_write_to_png_stream"];
  decltype(cairo_svg_surface_create_for_stream)* svg_surface_create_for_stream =
      library["cairo_svg_surface_create_for_stream"];
};

cairo_status_t append(void* text, const unsigned char* bytes, unsigned int count) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

void require(const CairoFunctions& call, cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS) {
    throw std::runtime_error(fmt::format("a plot: {}", call.status_to_string(status)));
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
  CairoFunctions call;
  Kind kind;
  std::string file;   // what has been written of it
  std::string words;  // SVG elements
  cairo_surface_t* surface;
  cairo_t* context;

  Cairo(Kind kind_in, int width, int height)
      : kind(kind_in),
        surface(kind == Kind::svg ? call.svg_surface_create_for_stream(append, &file, width, height)
                                  : call.image_surface_create(CAIRO_FORMAT_RGB24, width, height)),
        context(call.create(surface)) {}
  ~Cairo() {
    call.destroy(context);
    call.surface_destroy(surface);
  }
  Cairo(const Cairo&) = delete;
  Cairo& operator=(const Cairo&) = delete;

  void set_colour(const glm::dvec3& colour) const {
    call.set_source_rgb(context, colour.r, colour.g, colour.b);
  }

  void path(std::span<const glm::dvec2> points) const {
    call.new_path(context);  // words leave a point behind
    for (const glm::dvec2& point : points) {
      call.line_to(context, point.x, point.y);
    }
  }
};

PlotPage::PlotPage(Kind kind, int width, int height)
    : cairo_(std::make_unique<Cairo>(kind, width, height)) {
  cairo_->call.set_line_join(cairo_->context, CAIRO_LINE_JOIN_ROUND);
  cairo_->set_colour({1, 1, 1});
  cairo_->call.paint(cairo_->context);
  // The font that cairo brings along, so that files do not depend on the fonts of the machine.
  cairo_->call.select_font_face(cairo_->context, "@cairo:", CAIRO_FONT_SLANT_NORMAL,
                                CAIRO_FONT_WEIGHT_NORMAL);
}

PlotPage::~PlotPage() = default;

void PlotPage::line(std::span<const glm::dvec2> points, const glm::dvec3& colour, double width,
                    bool dashed) {
  const double dash[] = {7.0, 5.0};
  cairo_->call.set_dash(cairo_->context, dash, dashed ? 2 : 0, 0.0);
  cairo_->set_colour(colour);
  cairo_->call.set_line_width(cairo_->context, width);
  cairo_->path(points);
  cairo_->call.stroke(cairo_->context);
}

void PlotPage::polygon(std::span<const glm::dvec2> corners, const glm::dvec3& colour, bool hollow) {
  cairo_->call.set_dash(cairo_->context, nullptr, 0, 0.0);
  cairo_->path(corners);
  cairo_->call.close_path(cairo_->context);
  cairo_->set_colour(hollow ? glm::dvec3(1.0) : colour);
  cairo_->call.fill_preserve(cairo_->context);
  cairo_->set_colour(colour);
  cairo_->call.set_line_width(cairo_->context, hollow ? 1.6 : 0.8);
  cairo_->call.stroke(cairo_->context);
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
  cairo_->call.save(context);
  cairo_->set_colour({0, 0, 0});
  cairo_->call.set_font_size(context, size);
  cairo_text_extents_t extents;
  cairo_->call.text_extents(context, line.c_str(), &extents);
  cairo_->call.translate(context, at.x, at.y);
  cairo_->call.rotate(context, upright ? -std::numbers::pi / 2 : 0.0);
  cairo_->call.move_to(context, -0.5 * static_cast<double>(align) * extents.x_advance, 0);
  cairo_->call.show_text(context, line.c_str());
  cairo_->call.restore(context);
}

std::string PlotPage::finish() {
  require(cairo_->call, cairo_->call.status(cairo_->context));
  std::string& file = cairo_->file;
  if (cairo_->kind == Kind::png) {
    require(cairo_->call, cairo_->call.surface_write_to_png_stream(cairo_->surface, append, &file));
    return std::move(file);
  }
  cairo_->call.surface_finish(cairo_->surface);
  require(cairo_->call, cairo_->call.surface_status(cairo_->surface));
  drop_surface_number(file);
  file.insert(file.rfind("</svg>"), cairo_->words);
  return std::move(file);
}

}  // namespace raycat
