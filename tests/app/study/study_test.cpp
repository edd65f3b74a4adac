#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "app/program.hpp"

namespace raycat {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.insert(entry.path().filename().string());
  }
  return names;
}

// Of a CSV file without quotes: its lines by the names of the columns.
std::vector<std::map<std::string, std::string>> rows_of(const std::string& file) {
  std::istringstream text(read_file(file));
  std::vector<std::map<std::string, std::string>> rows;
  std::vector<std::string> columns;
  for (std::string line; std::getline(text, line);) {
    std::vector<std::string> cells;
    line += ",";
    for (std::size_t at = 0; at < line.size();) {
      const std::size_t end = line.find(',', at);
      cells.push_back(line.substr(at, end - at));
      at = end + 1;
    }
    if (columns.empty()) {
      columns = cells;
      continue;
    }
    REQUIRE(cells.size() == columns.size());
    rows.emplace_back();
    for (std::size_t i = 0; i < cells.size(); ++i) {
      rows.back()[columns[i]] = cells[i];
    }
  }
  return rows;
}

// The files that a page shows or links to.
std::set<std::string> links_of(const std::string& html) {
  std::set<std::string> links;
  for (const std::string& attribute : {std::string("href=\""), std::string("src=\"")}) {
    for (std::size_t at = html.find(attribute); at != std::string::npos;
         at = html.find(attribute, at + 1)) {
      const std::size_t begin = at + attribute.size();
      const std::string link = html.substr(begin, html.find('"', begin) - begin);
      if (!link.starts_with('#')) {
        links.insert(link);
      }
    }
  }
  return links;
}

void require_study(const std::string& arguments, const TemporaryFolder& folder) {
  const Outcome outcome = raycat(fmt::format("study {} -o '{}' --size 64x64 --largest 128 --quick",
                                             arguments, folder.path().string()));
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK(outcome.err.empty());
}

// What a render of its own counts.
Json rendered(const std::string& name, int size, int levels, const std::string& options) {
  const Outcome outcome = raycat(fmt::format("render {} --size {}x{} --levels {} {} --json",
                                             scene(name), size, size, levels, options));
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  return Json::parse(outcome.out);
}

std::string edge_pixels(const Json& stats) { return stats["edges"]["pixels"].dump(); }
std::string categories(const Json& stats) { return stats["categories"]["distinct"].dump(); }

using Names = std::set<std::string>;

Names table2_files() {
  Names files{"table2.csv", "table2-paper.csv", "table2-ratios.csv"};
  for (const std::string scene :
       {"fig8", "fig9", "fig10", "csg_part", "sphereflake", "mesh_csg", "tiles"}) {
    const std::string stem = "table2-" + scene;
    files.insert(
        {stem + "-adaptive.png", stem + "-whitted.png", "table2-samples-" + scene + ".csv"});
    for (const std::string plot : {"", "-encoded", "-ssim", "-cpu"}) {
      files.insert({stem + "-64x64" + plot + ".svg", stem + "-64x64" + plot + ".png"});
    }
  }
  return files;
}

const std::map<std::string, Names>& files_by_study() {
  static const std::map<std::string, Names> files{
      {"fig7",
       {"fig7.csv", "fig7-original.png", "fig7-depth1.png", "fig7-depth2.png", "fig7-depth4.png",
        "fig7-depth6-lights.png", "fig7-segments.png"}},
      {"fig8", {"fig8.csv", "fig8-picture.png", "fig8-overlay.png", "fig8-lines.png"}},
      {"fig9", {"fig9.csv", "fig9-picture.png", "fig9-overlay.png", "fig9-lines.png"}},
      {"fig10", {"fig10.csv", "fig10-picture.png", "fig10-overlay.png", "fig10-lines.png"}},
      {"fig12",
       {"fig12.csv", "fig12-depths.csv", "fig12.svg", "fig12.png", "fig12-linear.svg",
        "fig12-linear.png", "fig12-exponents.svg", "fig12-exponents.png", "fig12-depths.svg",
        "fig12-depths.png"}},
      {"fig15",
       {"fig15.csv", "fig15.svg", "fig15.png", "fig15-depth1.png", "fig15-depth2.png",
        "fig15-depth3.png", "fig15-depth4.png", "fig15-depth5.png", "fig15-depth6.png",
        "fig15-depth7.png", "fig15-depth8.png"}},
      {"fig13", {"fig13-original.png", "fig13-chosen.png", "fig13-result.png"}},
      {"table1", {"table1.csv"}},
      {"table2", table2_files()}};
  return files;
}

TEST_CASE("each study writes its files and a page that shows them all", "[app][study]") {
  const TemporaryFolder folder;
  const std::string name =
      GENERATE("fig7", "fig8", "fig9", "fig10", "fig12", "fig13", "fig15", "table1", "all");
  INFO(name);
  require_study(name, folder);
  Names expected;
  for (const auto& [study, files] : files_by_study()) {
    if (name == study || name == "all") {
      expected.insert(files.begin(), files.end());
    }
  }
  const std::string html = read_file(folder / "report.html");
  CHECK(links_of(html) == expected);
  expected.insert("report.html");
  CHECK(names_in(folder.path()) == expected);
  for (const std::string& file : expected) {
    const std::string bytes = read_file(folder / file);
    INFO(file);
    if (file.ends_with(".png")) {
      CHECK(bytes.starts_with("\x89PNG\r\n"));
      // Width and height are at 16, 64 of a picture and 800 x 600 of a plot.
      const bool plot = expected.contains(file.substr(0, file.size() - 4) + ".svg");
      CHECK(bytes.substr(16, 8) == (plot ? std::string("\0\0\x03\x20\0\0\x02\x58", 8)
                                         : std::string("\0\0\0\x40\0\0\0\x40", 8)));
    }
    CHECK(bytes.size() > 60);
  }
}

TEST_CASE("one trace of Fig. 7 gives what a render of each level of detail gives", "[app][study]") {
  const TemporaryFolder folder;
  require_study("fig7", folder);
  const auto rows = rows_of(folder / "fig7.csv");
  REQUIRE(rows.size() == 4);
  const char* const levels[] = {"1", "2", "4", "6"};
  for (std::size_t i = 0; i < 4; ++i) {
    const bool lights = i == 3;
    const Json alone =
        rendered("fig7", 64, 6,
                 fmt::format("--category-levels {} --lights {}", levels[i], lights ? "on" : "off"));
    CHECK(rows[i].at("levels") == levels[i]);
    CHECK(rows[i].at("lights") == (lights ? "on" : "off"));
    CHECK(rows[i].at("edge_pixels") == edge_pixels(alone));
    CHECK(rows[i].at("categories") == categories(alone));
  }
  CHECK(std::stoi(rows[0].at("edge_pixels")) < std::stoi(rows[1].at("edge_pixels")));
}

TEST_CASE("the pictures of a study are those that a render makes", "[app][study]") {
  const TemporaryFolder folder;
  require_study("fig9", folder);
  const auto size_of_text = [](const std::string& png) { return png.find("IDAT"); };
  REQUIRE(raycat(fmt::format("render {} --size 64x64 -o '{}' --overlay '{}' --lines '{}'",
                             scene("fig9"), folder / "a.png", folder / "b.png", folder / "c.png"))
              .code == 0);
  for (const auto& [ours, theirs] :
       {std::pair{"fig9-picture.png", "a.png"}, std::pair{"fig9-overlay.png", "b.png"},
        std::pair{"fig9-lines.png", "c.png"}}) {
    const std::string one = read_file(folder / ours);
    const std::string other = read_file(folder / theirs);
    CHECK((one.substr(size_of_text(one)) == other.substr(size_of_text(other))));
  }
  CHECK(read_file(folder / "fig9-lines.png").find("raycat study fig9 --size 64x64") !=
        std::string::npos);
}

TEST_CASE("edge pixels stand beside the paper's", "[app][study]") {
  const TemporaryFolder folder;
  for (const auto& [name, paper] :
       {std::pair{"fig8", "23656"}, std::pair{"fig9", "43340"}, std::pair{"fig10", ""}}) {
    require_study(name, folder);
    const auto rows = rows_of(folder / fmt::format("{}.csv", name));
    const Json alone = rendered(name, 64, 8, "");
    CHECK(rows[0].at("edge_pixels") == edge_pixels(alone));
    CHECK(rows[0].at("categories") == categories(alone));
    CHECK(std::stod(rows[0].at("edge_percent")) ==
          Approx(100.0 * alone["edges"]["fraction"].get<double>()).margin(0.0051));
    REQUIRE(rows.size() == (*paper == '\0' ? 1 : 2));
    if (rows.size() == 2) {
      CHECK(rows[1].at("edge_pixels") == paper);
      CHECK(read_file(folder / "report.html").find(fmt::format("<td>{}</td>", paper)) !=
            std::string::npos);
    }
  }
}

TEST_CASE("Fig. 12 counts edges at each size and how fast they fall", "[app][study]") {
  const TemporaryFolder folder;
  require_study("fig12", folder);
  const auto rows = rows_of(folder / "fig12.csv");
  REQUIRE(rows.size() == 3 * 2 * 2);  // scenes, levels of detail, sizes
  for (std::size_t i = 0; i < rows.size(); i += 2) {
    const std::string name = rows[i].at("scene").substr(0, rows[i].at("scene").find('.'));
    CHECK(rows[i].at("exponent").empty());
    double share[2];
    for (std::size_t j = 0; j < 2; ++j) {
      const auto& row = rows[i + j];
      const Json alone = rendered(
          name, j == 0 ? 64 : 128, 6,
          fmt::format("--category-levels {} --lights {}", row.at("levels"), row.at("lights")));
      CHECK(row.at("n") == (j == 0 ? "64" : "128"));
      CHECK(row.at("edge_pixels") == edge_pixels(alone));
      CHECK(row.at("categories") == categories(alone));
      share[j] = alone["edges"]["fraction"].get<double>();
    }
    CHECK(std::stod(rows[i + 1].at("exponent")) ==
          Approx(std::log2(share[0] / share[1])).margin(0.00051));
  }
  CHECK(rows_of(folder / "fig12-depths.csv").size() == 3 * 12 * 2);
  // The law holds for surfaces, and later for what mirrors show.
  CHECK(std::stod(rows[1].at("exponent")) > 0.9);
  CHECK(std::stod(rows[3].at("exponent")) < 0.7);
  const std::string svg = read_file(folder / "fig12.svg");
  CHECK(svg.find("fig8.gltf, depth 6 with lights") != std::string::npos);
  CHECK(svg.find("1/n") != std::string::npos);
}

TEST_CASE("Fig. 15 draws every depth, and deeper ones have more edges", "[app][study]") {
  const TemporaryFolder folder;
  require_study("fig15", folder);
  const auto rows = rows_of(folder / "fig15.csv");
  REQUIRE(rows.size() == 16);
  CHECK(rows[4].at("levels") == "3");
  CHECK(rows[4].at("lights") == "on");
  CHECK(rows[4].at("edge_pixels") == edge_pixels(rendered("fig9", 64, 8, "--category-levels 3")));
  CHECK(rows[5].at("edge_pixels") ==
        edge_pixels(rendered("fig9", 64, 8, "--category-levels 3 --lights off")));
  for (std::size_t i = 2; i < rows.size(); ++i) {
    CHECK(std::stoi(rows[i].at("edge_pixels")) >= std::stoi(rows[i - 2].at("edge_pixels")));
  }
}

TEST_CASE("Table 1 has the paper's rows with ours beside them", "[app][study]") {
  const TemporaryFolder folder;
  require_study("table1", folder);
  const auto rows = rows_of(folder / "table1.csv");
  REQUIRE(rows.size() == 10);
  CHECK(rows[0].at("method") == "none");
  CHECK(rows[0].at("edge_pixels") == "0");
  CHECK(rows[1].at("paper_edge_pixels") == "43280");
  CHECK(rows[2].at("paper_ratio") == "2.106");  // 97.5 / 46.3
  CHECK(rows[9].at("paper_ratio") == "1.322");  // 11.9 / 9.0
  const Json compared =
      Json::parse(raycat(fmt::format("compare {} --size 64x64 --json", scene("fig9"))).out);
  for (const Json& method : compared["methods"]) {
    const auto row = std::ranges::find_if(rows, [&](const auto& each) {
      return each.at("method") == method["method"].get<std::string>() &&
             each.at("scene") == "fig9.gltf";
    });
    REQUIRE(row != rows.end());
    CHECK(row->at("edge_pixels") == method["edge_pixels"].dump());
    CHECK(row->at("missed") == method["missed"].dump());
    CHECK(row->at("over_64_bits") == method["overflowed"].dump());
    CHECK(std::stod(row->at("ratio")) > 0.2);
  }
}

TEST_CASE("Table 2 says what each method costs and how good it is", "[app][study]") {
  const TemporaryFolder folder;
  require_study(fmt::format("table2 --scene {}", scene("fig10")), folder);
  const auto rows = rows_of(folder / "table2.csv");
  REQUIRE(rows.size() > 8);
  const auto value = [](const auto& row, const char* column) { return std::stod(row.at(column)); };
  for (const auto& row : rows) {
    INFO(row.at("method") << " " << row.at("options"));
    CHECK(value(row, "rays_per_pixel") > 1.0);
    CHECK(value(row, "psnr") > 25.0);
    CHECK(value(row, "ssim") > 0.8);
    CHECK(value(row, "ssim") <= 1.0);
    CHECK(value(row, "cpu_seconds") > 0.0);
  }
  // Of one method, more rays make a better picture.
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i].at("method") == "adaptive" && rows[i - 1].at("method") == "adaptive") {
      CHECK(value(rows[i], "rays_per_pixel") > value(rows[i - 1], "rays_per_pixel"));
      CHECK(value(rows[i], "psnr") > value(rows[i - 1], "psnr"));
    }
  }
  for (const auto& row : rows_of(folder / "table2-ratios.csv")) {
    CHECK((row.at("rays").empty() || std::stod(row.at("rays")) < 1.0));
  }
}

TEST_CASE("what a study counts is the same on stdout", "[app][study]") {
  const TemporaryFolder folder;
  const Outcome outcome = raycat(fmt::format(
      "study all -o '{}' --size 64x64 --largest 128 --quick --json", folder.path().string()));
  REQUIRE(outcome.code == 0);
  const Json json = Json::parse(outcome.out);
  CHECK(json["report"] == folder / "report.html");
  CHECK(json["figures"].size() == 9);
  CHECK(json["figures"]["fig8"]["edge_pixels"].dump() ==
        rows_of(folder / "fig8.csv")[0].at("edge_pixels"));
  CHECK(json["figures"]["fig8"]["paper_edge_pixels"] == 23656);
  CHECK(json["figures"]["fig7"]["levels"][2]["edge_pixels"].dump() ==
        rows_of(folder / "fig7.csv")[2].at("edge_pixels"));
  CHECK(json["figures"]["fig12"]["points"].size() == 12);
  CHECK(json["figures"]["fig15"]["levels"].size() == 16);
  CHECK(json["figures"]["table1"]["figures"][1]["methods"][4]["method"] == "heap");
}

TEST_CASE("a study has the same bytes whatever the number of threads", "[app][study]") {
  const TemporaryFolder one;
  const TemporaryFolder three;
  const std::string name = GENERATE("fig7", "fig12");
  require_study(name + " --threads 1", one);
  require_study(name + " --threads 3", three);
  for (const std::string& file : names_in(one.path())) {
    INFO(file);
    CHECK((read_file(one / file) == read_file(three / file)));
  }
}

TEST_CASE("any scene can take the place of the paper's, whatever it is called", "[app][study]") {
  const TemporaryFolder folder;
  const TemporaryFolder out;
  const std::string file = folder.write("a,b \"c\" <&>.csg", "cube([1,2,3]);\n");
  require_study(fmt::format("all --quiet --scene '{}'", file), out);
  CHECK(read_file(out / "fig8.csv").find("/a,b \"\"c\"\" <&>.csg\",64,64,") != std::string::npos);
  const std::string html = read_file(out / "report.html");
  CHECK(html.find("a,b &quot;c&quot; &lt;&amp;&gt;.csg") != std::string::npos);
  CHECK(html.find("<&>") == std::string::npos);
  CHECK(read_file(out / "fig12.svg").find("&lt;&amp;&gt;.csg, depth 1") != std::string::npos);
  CHECK(read_file(out / "fig12.csv").find("fig8.gltf") == std::string::npos);
}

TEST_CASE("a scene in which nothing is to be seen is no obstacle", "[app][study]") {
  const TemporaryFolder folder;
  const TemporaryFolder out;
  const std::string file = folder.write(
      "away.gltf",
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],"cameras":[{"type":"perspective","perspective":{"yfov":0.5,"znear":0.1}}],)"
      R"("nodes":[{"extras":{"shape":{"type":"sphere","radius":1}}},)"
      R"({"camera":0,"extras":{"look_at":{"eye":[0,0,5],"target":[0,0,9],"up":[0,1,0]}}}]})");
  require_study(fmt::format("all --quiet --scene '{}'", file), out);
  CHECK(links_of(read_file(out / "report.html")).contains("fig12.csv"));
  CHECK_FALSE(fs::exists(out.path() / "fig12-exponents.svg"));  // nothing falls
  for (const std::string& link : links_of(read_file(out / "report.html"))) {
    CHECK(fs::exists(out.path() / link));
  }
}

TEST_CASE("the folder of a study is made, and what was there is replaced", "[app][study]") {
  const TemporaryFolder folder;
  const std::string deep = folder / "new/deeper";
  for (int i = 0; i < 2; ++i) {
    const Outcome outcome = raycat(fmt::format("study fig10 -o '{}' --size 32x32", deep));
    CHECK(outcome.code == 0);
    CHECK(outcome.out == deep + "/report.html\n");
  }
  CHECK(names_in(deep).size() == 5);
}

TEST_CASE("scenes of one's own stand in by their names", "[app][study]") {
  const TemporaryFolder folder;
  const TemporaryFolder out;
  fs::copy_file(std::string(RAYCAT_ASSETS) + "/scenes/fig1.gltf", folder.path() / "fig8.gltf");
  require_study(fmt::format("fig8 --scenes '{}'", folder.path().string()), out);
  CHECK(rows_of(out / "fig8.csv")[0].at("edge_pixels") == edge_pixels(rendered("fig1", 64, 8, "")));
}

TEST_CASE("a study that cannot be is one line and exit code 2", "[app][study]") {
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "text");
  const std::string out = folder / "out";
  struct Case {
    std::string arguments;
    std::string says;
  };
  const std::string names =
      "is not one of fig7, fig8, fig9, fig10, fig12, fig13, fig15, table1, table2, all";
  const Case bad[] = {
      {"FIG7 -o '" + out + "'", "'FIG7' " + names},
      {"-o '" + out + "'", "NAME"},
      {"fig7", "--out"},
      {"fig7 -o '" + file + "'", "file: is not a folder"},
      {"fig7 -o '" + file + "/deeper'", "deeper: is not a folder"},
      {"fig7 -o '" + out + "' --size 0x9", "--size"},
      {"fig12 -o '" + out + "' --largest 100", "--largest"},
      {"fig8 -o '" + out + "' --scenes '" + folder.path().string() + "'",
       "fig8.gltf: there is no such scene: --scenes names their folder"},
      {"fig8 -o '" + out + "' --scene '" + folder / "none.gltf" + "'", "none.gltf: "},
      {"fig8 -o '" + out + "' --scene '" + file + "'", "file: unknown kind of scene file"},
      {"fig8 -o '" + out + "' --scene a.gltf --scenes b", "--scene"}};
  for (const auto& [arguments, says] : bad) {
    INFO(arguments);
    const Outcome outcome = raycat("study " + arguments);
    INFO(outcome.err);
    CHECK(outcome.code == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.starts_with("raycat: "));
    CHECK(std::ranges::count(outcome.err, '\n') == 1);
    CHECK(outcome.err.find(says) != std::string::npos);
    CHECK(!fs::exists(out + "/report.html"));
  }
}

TEST_CASE("an interrupted study leaves whole files alone", "[app][study]") {
  const TemporaryFolder folder;
  // SIGINT goes out once the study has written something; it has far more to do.
  const Outcome outcome =
      shell(fmt::format("'{}' study all -o '{}' --size 256x256 & pid=$!; for i in $(seq 1200); do "
                        "[ -e '{}' ] && break; sleep 0.05; done; kill -INT $pid; wait $pid",
                        RAYCAT_PROGRAM, folder.path().string(), folder / "fig7-original.png"));
  CHECK(outcome.code == 1);
  CHECK(outcome.err == "raycat: interrupted\n");
  CHECK(!fs::exists(folder.path() / "report.html"));
  for (const std::string& file : names_in(folder.path())) {
    INFO(file);
    CHECK((file.ends_with(".png") || file.ends_with(".csv") || file.ends_with(".svg")));
    const std::string bytes = read_file(folder / file);
    if (file.ends_with(".png")) {
      CHECK(bytes.find("IEND") == bytes.size() - 8);
    }
  }
}

}  // namespace
}  // namespace raycat
