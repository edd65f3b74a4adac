#include <algorithm>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "app/program.hpp"

namespace raycat {
namespace {

using Json = nlohmann::json;

TEST_CASE("render writes every map of one pass and says what it did", "[app][render]") {
  const TemporaryFolder folder;
  const Outcome outcome = raycat(fmt::format(
      "render {} --size 96x64 --json -o '{}' --edges '{}' --overlay '{}' --lines '{}' --segments "
      "'{}' --stats '{}'",
      scene("fig10"), folder / "out.exr", folder / "edges.png", folder / "overlay.ppm",
      folder / "lines.png", folder / "segments.png", folder / "stats.json"));
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK(outcome.err.empty());
  CHECK(folder.files() == 6);
  const Json stats = Json::parse(outcome.out);
  CHECK(Json::parse(read_file(folder / "stats.json")).size() == stats.size());
  CHECK(stats["width"] == 96);
  CHECK(stats["height"] == 64);
  CHECK(stats["categories"]["method"] == "heap");
  CHECK(stats["categories"]["ids"] == "face");
  CHECK(stats["categories"]["levels"] == 8);
  CHECK(stats["categories"]["lights"] == true);
  CHECK(stats["categories"]["distinct"] > 10);
  CHECK(stats["categories"]["textured_pixels"] == 0);
  CHECK(stats["edges"]["pixels"] > 100);
  CHECK(stats["edges"]["fraction"] == Approx(stats["edges"]["pixels"].get<double>() / (96 * 64)));
  CHECK(stats["samples"]["colour"] == 96 * 64);
  CHECK(stats["samples"]["category_only"] == 96 + 64 + 1);
  CHECK(stats["rays"]["camera"] == 97 * 65);
  CHECK(stats["seconds"]["trace"] > 0.0);
  CHECK(stats["load"]["parse"] > 0.0);
  CHECK(stats["peak_memory_bytes"] > 1'000'000);
}

TEST_CASE("files have the same bytes whatever the number of threads", "[app][render]") {
  const TemporaryFolder folder;
  for (const int threads : {1, 2, 5}) {
    REQUIRE(raycat(fmt::format("render {} --size 120x90 --threads {} -o '{}' --segments '{}'",
                               scene("fig9"), threads, folder / fmt::format("{}.png", threads),
                               folder / fmt::format("{}-s.exr", threads)))
                .code == 0);
  }
  CHECK((read_file(folder / "1.png") == read_file(folder / "2.png")));
  CHECK((read_file(folder / "1.png") == read_file(folder / "5.png")));
  CHECK((read_file(folder / "1-s.exr") == read_file(folder / "5-s.exr")));
}

TEST_CASE("images say what made them", "[app][render]") {
  const TemporaryFolder folder;
  const std::string name = GENERATE("a.png", "a.exr", "a.ppm");
  REQUIRE(
      raycat(fmt::format("render {} --size 32x32 --levels 3 -o '{}'", scene("fig1"), folder / name))
          .code == 0);
  const std::string bytes = read_file(folder / name);
  CHECK(bytes.find("raycat render") != std::string::npos);
  CHECK(bytes.find("--size 32x32 --levels 3") != std::string::npos);
  CHECK(bytes.find("fig1.gltf") != std::string::npos);
}

TEST_CASE("names that are no UTF-8 or no word do not stand in the way", "[app][render]") {
  const TemporaryFolder folder;
  const std::string name = folder / "it's \xff a\nscene.gltf";
  std::filesystem::copy_file(std::string(RAYCAT_ASSETS) + "/scenes/fig1.gltf", name);
  const Outcome outcome = raycat(
      fmt::format("render \"$(printf '%b' '{}')\" --size 16x16 --json -o '{}'",
                  (folder.path() / "it\\047s \\0377 a\\nscene.gltf").string(), folder / "out.png"));
  INFO(outcome.err);
  CHECK(outcome.code == 0);
  CHECK(Json::parse(outcome.out)["width"] == 16);
  CHECK((read_file(folder / "out.png").find("'\\''s ") != std::string::npos));
}

TEST_CASE("less detail makes fewer categories", "[app][render]") {
  const auto distinct = [](const std::string& options, const std::string& name = "fig8") {
    const Outcome outcome =
        raycat(fmt::format("render {} --size 128x128 --json {}", scene(name), options));
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    return Json::parse(outcome.out)["categories"]["distinct"].get<int>();
  };
  const int all = distinct("");
  CHECK(distinct("--category-levels 2") < all);
  CHECK(distinct("--lights off") < all);
  CHECK(distinct("--ids object", "fig10") < distinct("--ids primitive", "fig10"));
  CHECK(distinct("--ids primitive", "fig10") < distinct("", "fig10"));
  CHECK(distinct("--min-weight 0.2") < all);
  CHECK(distinct("--category-levels 1 --lights off --ids object") <= 24);
}

// A ball on a floor of one material under a lamp, and a single-sided sheet that turns its back to
// the camera.
std::string scene_of(const TemporaryFolder& folder, const std::string& material) {
  const std::string text = R"({"asset":{"version":"2.0"},
    "extensionsUsed":["KHR_lights_punctual","KHR_materials_unlit"],
    "extensions":{"KHR_lights_punctual":{"lights":[{"name":"lamp","type":"point"}]}},
    "scenes":[{"nodes":[0,1,2,3,4]}],
    "nodes":[{"translation":[0,1,0],"extras":{"shape":{"type":"sphere"},"material":0}},
             {"extras":{"shape":{"type":"plane"},"material":0}},
             {"mesh":0,"translation":[1,1,2]},
             {"translation":[3,6,2],"extensions":{"KHR_lights_punctual":{"light":0}}},
             {"camera":0,"extras":{"look_at":{"eye":[0,4,8],"target":[0,0,0]}}}],
    "cameras":[{"type":"perspective","perspective":{"yfov":0.7,"znear":0.1}}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",
                  "min":[0,0,0],"max":[1,1,0]}],
    "bufferViews":[{"buffer":0,"byteLength":36}],
    "buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,)"
                           "AAAAAAAAAAAAAAAAAAAAAAAAgD8AAAAAAACAPwAAAAAAAAAA"
                           R"("}],"materials":[{)";
  return folder.write("scene.gltf", text + material + "}]}");
}

TEST_CASE("there is no edge of a shadow that is not in the picture", "[app][render]") {
  const TemporaryFolder folder;
  const auto render = [&](const std::string& material, const std::string& options) {
    const Outcome outcome =
        raycat(fmt::format("render '{}' --size 96x96 --json --edge-classes '{}' {}",
                           scene_of(folder, material), folder / "classes.png", options));
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    return Json::parse(outcome.out);
  };
  const auto shadow = [&](const std::string& material, const std::string& options) {
    return render(material, options)["edges"]["classes"]["shadow"].get<int>();
  };
  const std::string stone = R"("pbrMetallicRoughness":{"metallicFactor":0})";
  const std::string unlit = R"("extensions":{"KHR_materials_unlit":{}})";
  const std::string mirror = R"("extras":{"whitted":{"reflection":0.5}})";
  const int all = shadow(stone, "");
  CHECK(all > 50);
  CHECK(shadow(stone, "--lights visible") == all);
  CHECK(shadow(unlit, "") == 0);
  CHECK(shadow(unlit, "--lights visible") == all);
  CHECK(shadow(mirror, "") == 0);
  CHECK(shadow(mirror, "--lights visible") > 0);
  for (const std::string& material : {unlit, mirror}) {
    CHECK(render(material, "")["edges"] == render(material, "--lights off")["edges"]);
    CHECK(render(material, "")["rays"]["shadow"] == 0);
  }
  CHECK(render(stone, "--lights visible")["categories"]["lights"] == true);
  CHECK(render(stone, "--lights off")["categories"]["lights"] == false);
  CHECK(read_file(folder / "classes.png").find("--lights off") != std::string::npos);
}

TEST_CASE("back faces are hidden, and shown when they are asked for", "[app][render]") {
  const TemporaryFolder folder;
  const std::string file = scene_of(folder, R"("pbrMetallicRoughness":{"metallicFactor":0})");
  const auto objects = [&](const std::string& options) {
    const Outcome outcome = raycat(fmt::format(
        "render '{}' --size 96x96 --json --ids object --category-levels 1 {}", file, options));
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    return Json::parse(outcome.out)["categories"]["distinct"].get<int>();
  };
  // The ball and the floor; the sheet.
  CHECK(objects("--lights off") == 2);
  CHECK(objects("--lights off --back-faces hide") == 2);
  CHECK(objects("--lights off --back-faces show") == 3);
}

TEST_CASE("standard views are orbits, and orbits are views", "[app][render]") {
  const TemporaryFolder folder;
  const auto picture = [&](const std::string& options) {
    const Outcome outcome = raycat(
        fmt::format("render {} --size 24x24 {} -o '{}'", scene("fig1"), options, folder / "a.ppm"));
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    const std::string bytes = read_file(folder / "a.ppm");
    return bytes.substr(bytes.find("\n255\n"));  // past the command that made it
  };
  CHECK(picture("--top") == picture("--orbit 0,90"));
  CHECK(picture("--front") == picture("--orbit 0,0"));
  CHECK(picture("--right") == picture("--orbit 90,0"));
  CHECK(picture("--iso") == picture("--orbit 45,35.264389682754654"));
  CHECK(picture("--top") != picture("--front"));
  // Straight down, -Z is up, and what --up says is.
  const std::string down = "--view 0,9,0,0,0,0";
  CHECK(picture(down) == picture(down + " --up 0,0,-1"));
  CHECK(picture(down) != picture(down + " --up 1,0,0"));
}

TEST_CASE("a view that cannot be is one line", "[app][render]") {
  const auto [options, says] = GENERATE(table<std::string, std::string>(
      {{"--top --front", "--top excludes --front"},
       {"--view 0,9,0,0,0,0 --iso", "--view excludes --iso"},
       {"--orbit 1", "--orbit 1: expected AZIMUTH,ELEVATION"},
       {"--orbit 0,91", "the elevation is between -90 and 90 degrees"},
       {"--orbit 0,0,0", "the distance must be more than 0"},
       {"--orbit 0,inf", "'inf' is not a number"},
       {"--up 0,0,0 --top", "--up 0,0,0: has no direction"},
       {"--up 0,1,0", "--up goes with --view, --orbit or a view such as --front"},
       {"--view '1 2 3 0 0 0'",
        "'1 2 3 0 0 0' is not a number: numbers need commas between them"}}));
  const Outcome outcome = raycat(fmt::format("render {} {} -o out.png", scene("fig1"), options));
  INFO(outcome.err);
  CHECK(outcome.code == 2);
  CHECK(std::ranges::count(outcome.err, '\n') == 1);
  CHECK(outcome.err.find(says) != std::string::npos);
}

TEST_CASE("what was meant is asked where a word is not known", "[app]") {
  const std::string file = scene("fig1");
  const auto [arguments, says] = GENERATE_COPY(table<std::string, std::string>(
      {{"render " + file + " --sise 3x3 -o a.png",
        "--sise is no option here: did you mean --size?"},
       {"render " + file + " --linse a.png b.png",
        "--linse is no option here: did you mean --lines?"},
       {"info " + file + " --rubbish=3", "--rubbish is no option here; see raycat --help"},
       {"info " + file + " more", "'more' is not expected; see raycat --help"},
       {"rendr " + file,
        "'rendr' is not one of render, info, probe, compare, study, measure, "
        "convert: did you mean render?"},
       {"info " + file + " --max-nodes -1", "'-1' is not a number of 0 or more"},
       {"info " + file + " --max-memory -1", "'-1' is not a number of 0 or more"},
       {file, "is a file: say before it what to do, as in raycat render"}}));
  const Outcome outcome = raycat(arguments);
  INFO(outcome.err);
  CHECK(outcome.code == 2);
  CHECK(std::ranges::count(outcome.err, '\n') == 1);
  CHECK(outcome.err.find(says) != std::string::npos);
}

TEST_CASE("every method makes a map, and numbers say what overflows", "[app][render]") {
  const auto stats = [](const std::string& method) {
    return Json::parse(
        raycat(fmt::format("render {} --size 96x96 --json --method {}", scene("fig9"), method))
            .out);
  };
  const Json heap = stats("heap");
  CHECK(heap["categories"]["overflowed_pixels"] == 0);
  for (const std::string method : {"string", "primes", "godel"}) {
    const Json other = stats(method);
    CHECK(other["categories"]["method"] == method);
    CHECK(other["edges"]["pixels"] <= heap["edges"]["pixels"]);
    CHECK(other["categories"]["distinct"] <= heap["categories"]["distinct"]);
  }
  CHECK(stats("godel")["categories"]["overflowed_pixels"] > 1000);
  CHECK(stats("string")["categories"]["overflowed_pixels"] == 0);
  CHECK(stats("none")["categories"] == Json{{"method", "none"}});
}

TEST_CASE("render writes classes, regions, views and refined edges", "[app][render]") {
  const TemporaryFolder folder;
  const Outcome outcome = raycat(fmt::format(
      "render {} --size 90x60 --json --edge-classes '{}' --regions '{}' --segments '{}' "
      "--selected '{}' --view-as nodes -o '{}' --view-as depth='{}' --subpixel 2 --edges '{}'",
      scene("fig9"), folder / "classes.png", folder / "regions.png", folder / "segments.png",
      folder / "selected.png", folder / "nodes.png", folder / "depth.ppm", folder / "edges.ppm"));
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK(outcome.err.empty());
  CHECK(folder.files() == 7);
  const Json stats = Json::parse(outcome.out);
  const Json& edges = stats["edges"];
  CHECK(edges["selected"] == edges["pixels"]);  // nothing is textured
  CHECK(edges["classes"]["object"] > 100);
  CHECK(edges["classes"]["refraction"] > 100);
  CHECK(edges["classes"]["shadow"] <= edges["pixels"]);
  CHECK(edges["subpixels"]["width"] == 360);
  CHECK(edges["subpixels"]["height"] == 240);
  CHECK(edges["subpixels"]["pixels"] >= edges["pixels"]);
  CHECK(read_file(folder / "edges.ppm").find("\n360 240\n") != std::string::npos);
  CHECK(stats["samples"]["category_only"] ==
        90 + 60 + 1 + edges["subpixels"]["sampled"].get<int>());
  const auto total = [](const Json& sizes) {
    std::uint64_t sum = 0;
    for (const Json& size : sizes) {
      sum += size.get<std::uint64_t>();
    }
    return sum;
  };
  CHECK(total(stats["segments"]["sizes"]) == 90 * 60);
  CHECK(total(stats["regions"]["sizes"]) == 90 * 60);
  CHECK(stats["regions"]["count"] >= stats["segments"]["count"]);
  CHECK(stats["regions"]["sizes"].size() == stats["regions"]["count"]);
  CHECK(read_file(folder / "nodes.png").find("--view-as nodes") != std::string::npos);
  CHECK(read_file(folder / "depth.ppm").find("viridis") != std::string::npos);
  CHECK(read_file(folder / "classes.png").find("8 shadow") != std::string::npos);
}

TEST_CASE("path expressions have levels and lights as special cases", "[app][render]") {
  const auto map = [](const std::string& options) {
    const Json stats = Json::parse(
        raycat(fmt::format("render {} --size 96x96 --json {}", scene("fig8"), options)).out);
    return std::pair(stats["edges"]["pixels"].get<int>(),
                     stats["categories"]["distinct"].get<int>());
  };
  CHECK(map("--paths 'C'") == map("--category-levels 1 --lights off"));
  CHECK(map("--paths 'CL?'") == map("--category-levels 1"));
  CHECK(map("--paths 'C[^L]*'") == map("--lights off"));
  CHECK(map("--paths 'C.*'") == map(""));
  CHECK(map("--paths 'C<R.>.*'") != map(""));
  CHECK(map("--paths CL --lights off") == std::pair(0, 1));
}

TEST_CASE("compare makes Table 1", "[app][compare]") {
  const Outcome outcome = raycat("compare " + scene("fig9") + " --size 64x64 --json");
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  const Json table = Json::parse(outcome.out);
  CHECK(table["pixels"] == 64 * 64);
  REQUIRE(table["methods"].size() == 4);
  const Json alone = Json::parse(raycat("render " + scene("fig9") + " --size 64x64 --json").out);
  const Json& heap = table["methods"][0];
  CHECK(heap["method"] == "heap");
  CHECK(heap["edge_pixels"] == alone["edges"]["pixels"]);
  CHECK(heap["distinct"] == alone["categories"]["distinct"]);
  CHECK(heap["missed"] == 0);
  CHECK(heap["false_equalities"] == 0);
  for (const Json& row : table["methods"]) {
    CHECK(row["edge_pixels"].get<int>() + row["missed"].get<int>() == heap["edge_pixels"]);
    CHECK(row["trace_seconds"] > 0.0);
    CHECK(row["ratio_to_none"] > 0.0);
  }
  CHECK(table["methods"][3]["method"] == "godel");
  CHECK(table["methods"][3]["overflowed"] >= table["methods"][3]["overflowed_80"]);
  CHECK(table["methods"][3]["overflowed_80"] > 100);
  const Outcome readable = raycat("compare " + scene("fig1") + " --size 32x32");
  CHECK(readable.out.starts_with("method "));
  CHECK(readable.out.find("\nheap ") != std::string::npos);
}

TEST_CASE("info counts what a scene holds", "[app][info]") {
  const Outcome outcome = raycat("info " + scene("fig10") + " --json");
  REQUIRE(outcome.code == 0);
  const Json info = Json::parse(outcome.out);
  CHECK(info["objects"] == 4);
  CHECK(info["primitives"] == 7);
  CHECK(info["faces"] == 3 * 7 + 1);
  CHECK(info["triangles"] == 0);
  CHECK(info["csg_nodes"] == 9);
  CHECK(info["closed"] == true);
  CHECK(info["cameras"].size() == 1);
  CHECK(info["bounds"]["min"].size() == 3);
  CHECK(info["warnings"].empty());
}

TEST_CASE("a scene without lights is lit, and info says so", "[app][info]") {
  const TemporaryFolder folder;
  const std::string file = folder.write("cube.csg", "cube([1,2,3]);\n");
  const Json info = Json::parse(raycat("info '" + file + "' --json").out);
  CHECK(info["lights"] == 0);
  CHECK(info["warnings"].dump().find("headlight") != std::string::npos);
}

TEST_CASE("probe draws the ray tree of a pixel", "[app][probe]") {
  const Outcome outcome = raycat("probe " + scene("fig1") + " --pixel 400,240");
  REQUIRE(outcome.code == 0);
  CHECK(outcome.out.find("1 camera: B face 0, lit by L, weight 1\n") == 0);
  CHECK(outcome.out.find("heap category: 0101") != std::string::npos);
}

TEST_CASE("probe gives a pixel's code under each method", "[app][probe]") {
  // Symbols are L 1, A 2, B 3, so that their primes are 2, 3, 5; the pixel's string is BLAL.
  const Outcome outcome = raycat("probe " + scene("fig1") + " --pixel 300,210");
  CHECK(outcome.out.find("string category: B face 0, L, A face 0, L\n") != std::string::npos);
  CHECK(outcome.out.find("primes category: 60\n") != std::string::npos);
  CHECK(outcome.out.find("godel category: 4200\n") != std::string::npos);
  CHECK(outcome.out.find("heap category: 03010001 01010000\n") != std::string::npos);
  const Json categories =
      Json::parse(raycat("probe " + scene("fig1") + " --pixel 300,210 --json").out)["categories"];
  CHECK(categories["heap"] == Json{0x03010001, 0x01010000});
  CHECK(categories["string"] == Json{3, 1, 2, 1});
  CHECK(categories["primes"] == "60");   // 5 * 2 * 3 * 2
  CHECK(categories["godel"] == "4200");  // 2^3 * 3^1 * 5^2 * 7^1
  const Json direct = Json::parse(
      raycat("probe " + scene("fig1") + " --pixel 300,210 --json --category-levels 1 --lights off")
          .out)["categories"];
  CHECK(direct["string"] == Json{1});
}

TEST_CASE("probe lists the crossings of rays with set operations applied", "[app][probe]") {
  const TemporaryFolder folder;
  const std::string file = folder.write(
      "tube.csg", "difference() { cube([4,4,4], center=true); cube([2,2,9], center=true); }");
  const Outcome outcome =
      shell(fmt::format("printf '%s\\n' '-5 0 0 2 0 0' '0 0 9 0 0 -1' '-1.5 0 0 1 0 0' | '{}' "
                        "probe '{}' --rays - --json",
                        RAYCAT_PROGRAM, file));
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  std::istringstream lines(outcome.out);
  std::string line;
  REQUIRE(std::getline(lines, line));
  const Json across = Json::parse(line)["crossings"];
  REQUIRE(across.size() == 4);
  CHECK(across[0]["t"] == 1.5);
  CHECK(across[0]["entering"] == true);
  CHECK(across[0]["normal"] == Json{-1.0, 0.0, 0.0});
  CHECK(across[1]["t"] == 2.0);
  CHECK(across[1]["entering"] == false);
  CHECK(across[1]["normal"] == Json{1.0, 0.0, 0.0});
  CHECK(across[1]["id"] != across[0]["id"]);
  CHECK(across[2]["t"] == 3.0);
  CHECK(across[3]["t"] == 3.5);
  CHECK(across[0]["object"] == across[3]["object"]);
  REQUIRE(std::getline(lines, line));
  CHECK(Json::parse(line)["crossings"].empty());
  REQUIRE(std::getline(lines, line));
  CHECK(Json::parse(line)["crossings"].size() == 3);
}

TEST_CASE("render's help has its options in groups, and examples at the end", "[app]") {
  const std::string help = raycat("render --help").out;
  std::size_t last = 0;
  for (const char* const group :
       {"\nPicture:\n  -o,--out", "\nMaps:\n  --lines", "\nView:\n  --size", "\nScene:\n",
        "\nCategories:\n", "\nLimits:\n", "\nGeneral:\n  -h,--help", "\nExamples:\n"}) {
    INFO(group);
    const std::size_t at = help.find(group);
    REQUIRE(at != std::string::npos);
    CHECK(at > last);
    last = at;
  }
  // No option is without a group, and each is listed once.
  CHECK(help.find("\nOptions:") == std::string::npos);
  for (const char* const option : {"--aa", "--coverage", "--ortho", "--crease", "--ids", "--stats",
                                   "--max-nodes", "--threads"}) {
    INFO(option);
    const std::string line = fmt::format("\n  {} ", option);
    REQUIRE(help.find(line) != std::string::npos);
    CHECK(help.find(line, help.find(line) + 1) == std::string::npos);
  }
  std::size_t examples = 0;
  for (std::size_t at = last;
       (at = help.find("\n  raycat render ", at + 1)) != std::string::npos;) {
    ++examples;
  }
  CHECK(examples == 3);
}

// Every library takes time at every start (docs/design.md, Outputs).
TEST_CASE("the program starts with few shared libraries", "[app]") {
  const Outcome outcome = shell(fmt::format("ldd '{}'", RAYCAT_PROGRAM));
  REQUIRE(outcome.code == 0);
  const auto lines = std::ranges::count(outcome.out, '\n');
  CHECK(lines > 3);
  CHECK(lines <= 25);
}

TEST_CASE("antialiasing does not trace the samples of maps again", "[app][render]") {
  const TemporaryFolder folder;
  const auto camera_rays = [&](const std::string& options) {
    const Outcome outcome =
        raycat(fmt::format("render {} --size 40x30 --json {}", scene("fig8"), options));
    REQUIRE(outcome.code == 0);
    return Json::parse(outcome.out)["rays"]["camera"].get<int>();
  };
  const std::string picture = fmt::format("-o '{}'", folder / "out.png");
  CHECK(camera_rays("--lines '" + (folder / "lines.png") + "'") == 41 * 31);
  CHECK(camera_rays(picture + " --alpha") == 41 * 31);
  CHECK(camera_rays(picture + " --aa uniform --samples 3") == 41 * 31 + 40 * 30 * 8);
}

TEST_CASE("help and version are no errors", "[app]") {
  CHECK(raycat("--version").out == "raycat 0.1.0\n");
  CHECK(raycat("--help").code == 0);
  const Outcome help = raycat("render --help");
  CHECK(help.code == 0);
  CHECK(help.out.find("--overlay") != std::string::npos);
}

}  // namespace
}  // namespace raycat
