#include <cmath>
#include <string>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "app/program.hpp"

namespace raycat {
namespace {

using Json = nlohmann::json;

TEST_CASE("measure gives each object and all of them united", "[app][measure]") {
  const Outcome outcome = raycat("measure " + scene("fig10") + " --json --rays 60000");
  REQUIRE(outcome.code == 0);
  const Json found = Json::parse(outcome.out);
  CHECK(found["rays"] == 60000);
  const Json& objects = found["objects"];
  REQUIRE(objects.size() == 4);
  CHECK(objects[0]["name"] == "union");
  // Six caps of a ball of radius 1.3 look out of a cube of side 2.
  const double pi = std::acos(-1.0);
  const double ball = 4.0 / 3.0 * pi * 1.3 * 1.3 * 1.3;
  const double common = ball - 6.0 * pi * 0.3 * 0.3 * (3.0 * 1.3 - 0.3) / 3.0;
  CHECK(objects[0]["volume"].get<double>() == Approx(8.0 + ball - common).epsilon(0.003));
  CHECK(objects[1]["volume"].get<double>() == Approx(common).epsilon(0.003));
  CHECK(objects[2]["volume"].get<double>() == Approx(8.0 - common).epsilon(0.02));
  CHECK(found["volume"].get<double>() == Approx(16.0 + ball - common).epsilon(0.003));
  for (const char* key : {"volume_stderr", "area", "area_stderr"}) {
    CHECK(found[key].get<double>() > 0.0);
    CHECK(objects[2][key].get<double>() > 0.0);
  }
  for (const char* key : {"centroid", "centroid_stderr"}) {
    CHECK(found[key].size() == 3);
    CHECK(objects[2][key].size() == 3);
  }
  CHECK(objects[0]["bounds"]["max"][1].get<double>() == Approx(1.3));
  CHECK(objects[0]["bounds_error"]["max"][1].get<double>() < 1e-5);
  CHECK(found["bounds"]["min"][2] == objects[2]["bounds"]["min"][2]);
  const Json& floor = objects[3];
  CHECK(floor["name"] == "floor");
  for (const char* key : {"volume", "volume_stderr", "area", "centroid", "bounds"}) {
    CHECK(floor[key].is_null());
  }
  CHECK(found["warnings"] == Json{"'floor' has no volume: a half-space leaves it unbounded"});
  CHECK(outcome.err ==
        "raycat: warning: 'floor' has no volume: a half-space leaves it unbounded\n");
}

TEST_CASE("measure says the same whatever the number of threads", "[app][measure]") {
  const std::string command = "measure " + scene("csg_part") + " --json --quiet --rays 9999";
  const Outcome one = raycat(command + " --threads 1");
  const Outcome many = raycat(command + " --threads 5");
  CHECK(one.code == 0);
  CHECK(one.err.empty());
  CHECK(one.out == many.out);
}

TEST_CASE("measure shows values with as many digits as they are sure of", "[app][measure]") {
  const TemporaryFolder folder;
  const std::string file = folder.write(
      "cube.gltf", R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[)"
                   R"({"name":"cube","extras":{"shape":{"type":"box","size":[2,2,2]}}}]})");
  const Outcome outcome = raycat(fmt::format("measure '{}' --rays 4800", file));
  CHECK(outcome.code == 0);
  INFO(outcome.out);
  CHECK(outcome.out.starts_with("cube\n  volume    8 +- "));
  CHECK(outcome.out.find("  bounds    -1, -1, -1 to 1, 1, 1\n"
                         "all objects united, 4800 rays\n") != std::string::npos);
}

TEST_CASE("an open mesh is one warning, and a wrong number of rays one error", "[app][measure]") {
  const TemporaryFolder folder;
  const std::string file = folder.write("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const Outcome open = raycat(fmt::format("measure '{}' --json", file));
  CHECK(open.code == 0);
  const Json found = Json::parse(open.out);
  CHECK(found["volume"] == 0.0);
  CHECK(found["objects"][0]["volume"].is_null());
  CHECK(found["objects"][0]["area"] == 0.5);
  CHECK(found["objects"][0]["bounds"]["max"] == Json{1.0, 1.0, 0.0});
  CHECK(open.err.find("has no volume: edge (") != std::string::npos);
  const Outcome none = raycat(fmt::format("measure '{}' --rays 0", file));
  CHECK(none.code == 2);
  CHECK(none.out.empty());
  CHECK(none.err.find("--rays") != std::string::npos);
}

}  // namespace
}  // namespace raycat
