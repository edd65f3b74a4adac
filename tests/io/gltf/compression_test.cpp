#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <fmt/format.h>
#include <meshoptimizer.h>

#include "io/gltf/draco_header.hpp"
#include "tests/io/gltf/text.hpp"

namespace raycat {
namespace {

const std::vector<float> corners{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0.25f};
const std::vector<std::uint32_t> indices{0, 1, 2, 0, 2, 3};

std::string text_of(const std::vector<unsigned char>& bytes) {
  return {bytes.begin(), bytes.end()};
}

std::string encoded_corners() {
  std::vector<unsigned char> bytes(meshopt_encodeVertexBufferBound(4, 12));
  bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), corners.data(), 4, 12));
  return text_of(bytes);
}

std::string encoded_triangles() {
  std::vector<unsigned char> bytes(meshopt_encodeIndexBufferBound(6, 4));
  bytes.resize(meshopt_encodeIndexBuffer(bytes.data(), bytes.size(), indices.data(), 6));
  return text_of(bytes);
}

std::string encoded_sequence() {
  std::vector<unsigned char> bytes(meshopt_encodeIndexSequenceBound(6, 4));
  bytes.resize(meshopt_encodeIndexSequence(bytes.data(), bytes.size(), indices.data(), 6));
  return text_of(bytes);
}

// A square whose two buffer views are compressed; `fallback` is what the plain buffer holds.
std::string meshopt_square(const std::string& positions, const std::string& triangles,
                           const std::string& mode, const std::string& extension,
                           const std::string& filter = "NONE", std::size_t count = 4,
                           const std::string& fallback = "") {
  return gltf("0", R"({"mesh":0})",
              fmt::format(
                  R"(,"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1}}]}}],
"accessors":[{{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"}},
{{"bufferView":1,"componentType":5125,"count":6,"type":"SCALAR"}}],
"bufferViews":[{{"buffer":1,"byteLength":48,"byteStride":12,"extensions":{{"{0}":
{{"buffer":0,"byteLength":{1},"byteStride":12,"count":{2},"mode":"ATTRIBUTES","filter":"{3}"}}}}}},
{{"buffer":1,"byteOffset":48,"byteLength":24,"extensions":{{"{0}":
{{"buffer":0,"byteOffset":{1},"byteLength":{4},"byteStride":4,"count":6,"mode":"{5}"}}}}}}],
"buffers":[{{"byteLength":{6},"uri":"{7}"}},{{"byteLength":72{8}}}],
"extensionsUsed":["{0}"])",
                  extension, positions.size(), count, filter, triangles.size(), mode,
                  positions.size() + triangles.size(), data_uri(positions + triangles),
                  fallback.empty() ? "" : fmt::format(R"(,"uri":"{}")", data_uri(fallback))));
}

void require_square(const SceneFile& file) {
  REQUIRE(file.scene.meshes.size() == 1);
  const TriangleMesh& mesh = file.scene.meshes[0].mesh->triangles;
  REQUIRE(mesh.positions.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(mesh.positions[i] == glm::dvec3(corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]));
  }
  CHECK(mesh.triangles.size() == 2);
  CHECK(file.warnings.empty());
}

TEST_CASE("what meshopt has compressed is read as it was", "[io][gltf][compression]") {
  const std::string extension = GENERATE("EXT_meshopt_compression", "KHR_meshopt_compression");
  require_square(load_text("scene.gltf", meshopt_square(encoded_corners(), encoded_triangles(),
                                                        "TRIANGLES", extension)));
  require_square(load_text(
      "scene.gltf", meshopt_square(encoded_corners(), encoded_sequence(), "INDICES", extension)));
}

TEST_CASE("meshopt's filter for exponents is undone", "[io][gltf][compression]") {
  // 2^E M with E in the upper 8 bits: 0.25 is 2^-2 and 1, and 3 is 2^0 and 3.
  std::vector<std::int32_t> values(12, 0);
  values[0] = static_cast<std::int32_t>(0xfe000001);
  values[4] = 3;
  std::vector<unsigned char> bytes(meshopt_encodeVertexBufferBound(4, 12));
  bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), values.data(), 4, 12));
  const SceneFile file =
      load_text("scene.gltf", meshopt_square(text_of(bytes), encoded_triangles(), "TRIANGLES",
                                             "EXT_meshopt_compression", "EXPONENTIAL"));
  const TriangleMesh& mesh = file.scene.meshes.at(0).mesh->triangles;
  CHECK(mesh.positions.at(0) == glm::dvec3(0.25, 0, 0));
  CHECK(mesh.positions.at(1) == glm::dvec3(0, 3, 0));
}

TEST_CASE("meshopt data that cannot be decoded is refused", "[io][gltf][compression]") {
  const auto error = [](const std::string& mode, const std::string& filter, std::size_t count,
                        const std::string& positions) {
    return gltf_error(meshopt_square(positions, encoded_triangles(), mode,
                                     "EXT_meshopt_compression", filter, count));
  };
  const std::string good = encoded_corners();
  CHECK(error("TRIANGLES", "NONE", 4, std::string(good.size(), 'x')) ==
        "bufferViews[0]: meshopt: the compressed data is broken");
  CHECK(error("LINES", "NONE", 4, good) ==
        "bufferViews[1]: meshopt: mode: 'LINES' is not ATTRIBUTES, TRIANGLES or INDICES");
  CHECK(error("ATTRIBUTES", "OCTAHEDRAL", 4, good) ==
        "bufferViews[0]: meshopt: filter: OCTAHEDRAL needs a byteStride of 4 or 8");
  CHECK(error("TRIANGLES", "COLOR", 4, good) ==
        "bufferViews[0]: meshopt: filter: 'COLOR' is not supported");
  CHECK(error("TRIANGLES", "NONE", std::size_t{1} << 52, good).find("--max-memory") !=
        std::string::npos);
}

TEST_CASE("meshopt data that is broken falls back on what is not compressed",
          "[io][gltf][compression]") {
  std::string plain(72, '\0');
  std::memcpy(plain.data(), corners.data(), 48);
  std::memcpy(plain.data() + 48, indices.data(), 24);
  const SceneFile file =
      load_text("scene.gltf", meshopt_square(std::string(40, 'x'), encoded_triangles(), "TRIANGLES",
                                             "EXT_meshopt_compression", "NONE", 4, plain));
  CHECK(file.scene.meshes.at(0).mesh->triangles.positions.at(3) == glm::dvec3(0, 1, 0.25));
  CHECK(file.warnings == std::vector<std::string>{"bufferViews[0]: meshopt: the compressed data is "
                                                  "broken; uncompressed data is read"});
}

std::string draco_square(draco::MeshEncoderMethod method) {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(2);
  const int positions =
      builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  for (std::uint32_t i = 0; i < 2; ++i) {
    builder.SetAttributeValuesForFace(positions, draco::FaceIndex(i), &corners[3 * indices[3 * i]],
                                      &corners[3 * indices[3 * i + 1]],
                                      &corners[3 * indices[3 * i + 2]]);
  }
  const auto mesh = builder.Finalize();
  draco::Encoder encoder;
  encoder.SetEncodingMethod(method);  // without quantization: what is decoded is what was there
  draco::EncoderBuffer buffer;
  REQUIRE(encoder.EncodeMeshToBuffer(*mesh, &buffer).ok());
  return {buffer.data(), buffer.size()};
}

std::string draco_gltf(const std::string& data, const std::string& attribute = "0") {
  return gltf(
      "0", R"({"mesh":0})",
      fmt::format(
          R"(,"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1,"extensions":
{{"KHR_draco_mesh_compression":{{"bufferView":0,"attributes":{{"POSITION":{}}}}}}}}}]}}],
"accessors":[{{"componentType":5126,"count":4,"type":"VEC3"}},
{{"componentType":5123,"count":6,"type":"SCALAR"}}],
"bufferViews":[{{"buffer":0,"byteLength":{}}}],{},
"extensionsUsed":["KHR_draco_mesh_compression"],"extensionsRequired":["KHR_draco_mesh_compression"])",
          attribute, data.size(), buffer_of(data)));
}

TEST_CASE("what Draco has compressed is read as it was", "[io][gltf][compression]") {
  const auto method = GENERATE(draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING);
  const SceneFile file = load_text("scene.gltf", draco_gltf(draco_square(method)));
  const TriangleMesh& mesh = file.scene.meshes.at(0).mesh->triangles;
  REQUIRE(mesh.positions.size() == 4);
  REQUIRE(mesh.triangles.size() == 2);
  // The encoder may number the vertices anew.
  double area = 0.0;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 ab = mesh.positions[t.y] - mesh.positions[t.x];
    const glm::dvec3 ac = mesh.positions[t.z] - mesh.positions[t.x];
    area += 0.5 * (ab.x * ac.y - ab.y * ac.x);
  }
  CHECK(area == 1.0);
  CHECK(bounds(mesh).max == glm::dvec3(1, 1, 0.25));
  CHECK(file.triangles == 2);
}

TEST_CASE("a Draco header says how large the mesh is", "[io][compression]") {
  const auto header = [](const std::string& bytes) {
    return draco_header({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
  };
  for (const auto method : {draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING}) {
    const DracoHeader found = header(draco_square(method));
    CHECK(found.faces == 2);
    CHECK(found.points == 4);
  }
  // Metadata: one attribute's, of id 0 with an entry k = xy, and the mesh's with one more inside.
  const std::string metadata("\x01\x00\x01\x01k\x02xy\x00\x00\x01\x01m\x00\x00", 15);
  const DracoHeader found =
      header(std::string("DRACO\x02\x02\x01\x00\x00\x80", 11) + metadata + "\x85\x01\x03");
  CHECK(found.faces == 133);
  CHECK(found.points == 3);
  const std::string whole = draco_square(draco::MESH_SEQUENTIAL_ENCODING);
  for (std::size_t size = 0; size < 12; ++size) {
    CHECK_THROWS_AS(header(whole.substr(0, size)), std::runtime_error);
  }
}

TEST_CASE("Draco data that cannot be decoded is refused before it takes room",
          "[io][gltf][compression]") {
  const std::string good = draco_square(draco::MESH_SEQUENTIAL_ENCODING);
  CHECK(gltf_error(draco_gltf(good, "7")) ==
        "meshes[0]: primitives[0]: Draco: there is no attribute 7 for POSITION");
  CHECK(gltf_error(draco_gltf("DRACO\x02\x01" + good.substr(7))) ==
        "meshes[0]: primitives[0]: Draco: Draco bitstream 2.1 is not supported, only 2.2");
  const std::string points_bomb = good.substr(0, 11) + "\x02\xff\xff\xff\xff\x0f" + good.substr(13);
  CHECK(gltf_error(draco_gltf(points_bomb)).find("--max-memory") != std::string::npos);
  for (std::size_t size = 12; size < good.size(); size += 3) {
    CHECK(gltf_error(draco_gltf(good.substr(0, size))).starts_with("meshes[0]: primitives[0]: "));
  }
}

}  // namespace
}  // namespace raycat
