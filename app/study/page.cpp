#include "app/study/page.hpp"

#include <utility>

#include <fmt/format.h>

namespace raycat::app {
namespace {

constexpr const char* style = R"(
body { font: 16px/1.5 sans-serif; color: #222; max-width: 70rem; margin: 2rem auto; padding: 0 1rem }
h2 { margin-top: 3rem; border-bottom: 1px solid #ccc }
.beside { display: grid; grid-template-columns: 1fr 1fr; gap: 1rem }
.beside > div { border: 1px solid #ccc; border-radius: 4px; padding: 0 1rem }
.beside > .paper { background: #f6f6f2 }
.pictures { display: flex; flex-wrap: wrap; gap: 1rem; margin: 1rem 0 }
figure { margin: 0; max-width: 20rem }
figure.plot { max-width: 50rem }
figure img { max-width: 100%; border: 1px solid #ccc; background: #fff }
figcaption { font-size: .9rem; color: #444 }
table { border-collapse: collapse; margin: 1rem 0 .3rem; font-variant-numeric: tabular-nums }
th, td { border: 1px solid #ccc; padding: .15rem .6rem; text-align: right }
th { background: #f6f6f2 }
)";

// As HTML writes it.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string cells(const std::vector<std::string>& row, const char* element) {
  std::string text = "<tr>";
  for (const std::string& cell : row) {
    text += fmt::format("<{0}>{1}</{0}>", element, escaped(cell));
  }
  return text + "</tr>\n";
}

std::string csv_line(const std::vector<std::string>& row) {
  std::string line;
  for (std::size_t i = 0; i < row.size(); ++i) {
    line += i == 0 ? "" : ",";
    if (row[i].find_first_of(",\"\r\n") == std::string::npos) {
      line += row[i];
      continue;
    }
    line += '"';
    for (const char c : row[i]) {
      line.append(c == '"' ? 2 : 1, c);
    }
    line += '"';
  }
  return line + "\n";
}

}  // namespace

std::string csv(const Table& table) {
  std::string text = csv_line(table.columns);
  for (const auto& row : table.rows) {
    text += csv_line(row);
  }
  return text;
}

ReportPage::ReportPage(std::string title) : title_(std::move(title)) {}

void ReportPage::section(const std::string& id, const std::string& heading) {
  contents_ += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", escaped(id), escaped(heading));
  body_ += fmt::format("<h2 id=\"{}\">{}</h2>\n", escaped(id), escaped(heading));
}

void ReportPage::paragraph(const std::string& text) {
  body_ += fmt::format("<p>{}</p>\n", escaped(text));
}

void ReportPage::beside(const std::string& paper, const std::string& ours) {
  body_ += fmt::format(
      "<div class=\"beside\"><div class=\"paper\"><h3>The paper</h3><p>{}</p></div>\n"
      "<div><h3>Here</h3><p>{}</p></div></div>\n",
      escaped(paper), escaped(ours));
}

void ReportPage::pictures(const std::vector<Picture>& pictures) {
  body_ += "<div class=\"pictures\">\n";
  for (const Picture& picture : pictures) {
    body_ += fmt::format(
        "<figure><a href=\"{0}\"><img src=\"{0}\" alt=\"{1}\"></a><figcaption>{1}</figcaption>"
        "</figure>\n",
        escaped(picture.file), escaped(picture.caption));
  }
  body_ += "</div>\n";
}

void ReportPage::plot(const std::string& name, const std::string& caption) {
  body_ += fmt::format(
      "<figure class=\"plot\"><a href=\"{0}.svg\"><img src=\"{0}.svg\" alt=\"{1}\"></a>"
      "<figcaption>{1} (<a href=\"{0}.svg\">SVG</a>, <a href=\"{0}.png\">PNG</a>)</figcaption>"
      "</figure>\n",
      escaped(name), escaped(caption));
}

void ReportPage::table(const Table& table, const std::string& file) {
  body_ += "<table>\n" + cells(table.columns, "th");
  for (const auto& row : table.rows) {
    body_ += cells(row, "td");
  }
  body_ += fmt::format("</table>\n<p><a href=\"{0}\">{0}</a></p>\n", escaped(file));
}

void ReportPage::link(const std::string& file, const std::string& what) {
  body_ += fmt::format("<p><a href=\"{0}\">{0}</a>: {1}</p>\n", escaped(file), escaped(what));
}

std::string ReportPage::html() const {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width\">\n<title>{0}</title>\n"
      "<style>{1}</style>\n</head>\n<body>\n<h1>{0}</h1>\n<ul>\n{2}</ul>\n{3}</body>\n</html>\n",
      escaped(title_), style, contents_, body_);
}

}  // namespace raycat::app
