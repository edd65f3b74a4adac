#pragma once

#include <string>
#include <vector>

namespace raycat::app {

/// Cells of text under a name for each column.
struct Table {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

/// `table` as comma separated values (RFC 4180).
std::string csv(const Table& table);

/// A web page about pictures and figures in its own folder. It needs nothing else. All text is
/// plain and shown as given; files are named relative to the page.
class ReportPage {
 public:
  struct Picture {
    std::string file;
    std::string caption;
  };

  explicit ReportPage(std::string title);

  void section(const std::string& id, const std::string& heading);
  void paragraph(const std::string& text);

  /// What the paper shows beside what is shown here.
  void beside(const std::string& paper, const std::string& ours);
  void pictures(const std::vector<Picture>& pictures);

  /// A plot that is there as `name`.svg, which is shown, and as `name`.png.
  void plot(const std::string& name, const std::string& caption);

  /// `table`, and a link to `file`, which holds it.
  void table(const Table& table, const std::string& file);

  /// A link to `file`, and what it holds.
  void link(const std::string& file, const std::string& what);

  std::string html() const;

 private:
  std::string title_;
  std::string contents_;
  std::string body_;
};

}  // namespace raycat::app
