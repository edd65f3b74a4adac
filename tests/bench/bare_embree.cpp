#include "tests/bench/bare_embree.hpp"

#include <atomic>
#include <limits>
#include <stdexcept>

#include <embree3/rtcore.h>
#include <glm/geometric.hpp>

namespace raycat::bench {
namespace {

constexpr int side = 4;  // of a packet, in pixels
constexpr int lanes = side * side;

double plane_distance(const TriangleMesh& mesh, std::uint32_t triangle, const Ray& ray) {
  const glm::uvec3 i = mesh.triangles[triangle];
  const glm::dvec3 a = mesh.positions[i.x];
  const glm::dvec3 normal = glm::cross(mesh.positions[i.y] - a, mesh.positions[i.z] - a);
  return glm::dot(normal, a - ray.origin) / glm::dot(normal, ray.direction);
}

}  // namespace

struct BareEmbree::Handles {
  RTCDevice device = rtcNewDevice(nullptr);
  RTCScene scene = nullptr;
  std::atomic<std::int64_t> bytes = 0;
  std::atomic<std::int64_t> peak_bytes = 0;

  Handles() {
    rtcSetDeviceMemoryMonitorFunction(device, count, this);
    scene = rtcNewScene(device);
  }
  Handles(const Handles&) = delete;
  Handles& operator=(const Handles&) = delete;
  ~Handles() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }

  static bool count(void* self, ssize_t change, bool) {
    auto& handles = *static_cast<Handles*>(self);
    const std::int64_t now = handles.bytes += change;
    std::int64_t peak = handles.peak_bytes;
    while (now > peak && !handles.peak_bytes.compare_exchange_weak(peak, now)) {
    }
    return true;
  }
};

BareEmbree::BareEmbree(const TriangleMesh& mesh)
    : mesh_(mesh), handles_(std::make_unique<Handles>()) {
  rtcSetSceneFlags(handles_->scene, RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = rtcNewGeometry(handles_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                               RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                                               mesh.positions.size()));
  for (const glm::dvec3& position : mesh.positions) {
    for (int axis = 0; axis < 3; ++axis) {
      *vertices++ = static_cast<float>(position[axis]);
    }
  }
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                             mesh.triangles.data(), 0, sizeof(glm::uvec3), mesh.triangles.size());
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(handles_->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(handles_->scene);
  if (rtcGetDeviceError(handles_->device) != RTC_ERROR_NONE) {
    throw std::runtime_error("Embree cannot build the benchmark's mesh");
  }
}

BareEmbree::~BareEmbree() = default;

std::size_t BareEmbree::peak_bytes() const noexcept {
  return static_cast<std::size_t>(handles_->peak_bytes);
}

void BareEmbree::single_rays(const ImagePlane& plane, int left, int top, SeenImage& out) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  for (int y = top; y < top + tile; ++y) {
    for (int x = left; x < left + tile; ++x) {
      const Ray ray = plane.sample_ray(x, y);
      RTCRayHit found;
      found.ray = {.org_x = static_cast<float>(ray.origin.x),
                   .org_y = static_cast<float>(ray.origin.y),
                   .org_z = static_cast<float>(ray.origin.z),
                   .tnear = 0.0f,
                   .dir_x = static_cast<float>(ray.direction.x),
                   .dir_y = static_cast<float>(ray.direction.y),
                   .dir_z = static_cast<float>(ray.direction.z),
                   .time = 0.0f,
                   .tfar = std::numeric_limits<float>::infinity(),
                   .mask = ~0u,
                   .id = 0,
                   .flags = 0};
      found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      rtcIntersect1(handles_->scene, &context, &found);
      Seen seen;
      if (found.hit.geomID != RTC_INVALID_GEOMETRY_ID) {
        seen = {.geometry = found.hit.geomID,
                .triangle = found.hit.primID,
                .t = plane_distance(mesh_, found.hit.primID, ray)};
      }
      out.at(x, y) = seen;
    }
  }
}

void BareEmbree::packets(const ImagePlane& plane, int left, int top, SeenImage& out) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  alignas(64) int valid[lanes];
  for (int& lane : valid) {
    lane = -1;
  }
  for (int block = 0; block < tile * tile / lanes; ++block) {
    const int x0 = left + block % (tile / side) * side;
    const int y0 = top + block / (tile / side) * side;
    alignas(64) RTCRayHit16 found;
    for (int lane = 0; lane < lanes; ++lane) {
      const Ray ray = plane.ray(x0 + lane % side + 0.5, y0 + lane / side + 0.5);
      found.ray.org_x[lane] = static_cast<float>(ray.origin.x);
      found.ray.org_y[lane] = static_cast<float>(ray.origin.y);
      found.ray.org_z[lane] = static_cast<float>(ray.origin.z);
      found.ray.tnear[lane] = 0.0f;
      found.ray.dir_x[lane] = static_cast<float>(ray.direction.x);
      found.ray.dir_y[lane] = static_cast<float>(ray.direction.y);
      found.ray.dir_z[lane] = static_cast<float>(ray.direction.z);
      found.ray.time[lane] = 0.0f;
      found.ray.tfar[lane] = std::numeric_limits<float>::infinity();
      found.ray.mask[lane] = ~0u;
      found.ray.id[lane] = 0;
      found.ray.flags[lane] = 0;
      found.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
    }
    rtcIntersect16(valid, handles_->scene, &context, &found);
    for (int lane = 0; lane < lanes; ++lane) {
      Seen seen;
      if (found.hit.geomID[lane] != RTC_INVALID_GEOMETRY_ID) {
        seen = {.geometry = found.hit.geomID[lane],
                .triangle = found.hit.primID[lane],
                .t = static_cast<double>(found.ray.tfar[lane])};
      }
      out.at(x0 + lane % side, y0 + lane / side) = seen;
    }
  }
}

}  // namespace raycat::bench
