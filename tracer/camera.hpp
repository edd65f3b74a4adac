#pragma once

#include <string>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "geometry/bounds.hpp"
#include "geometry/ray.hpp"

namespace raycat {

/// A pinhole or orthographic camera. Pixels are square; the image's height spans the field of
/// view and its width follows.
struct Camera {
  std::string name;
  glm::dvec3 eye{0.0, 0.0, 0.0};
  glm::dvec3 right{1.0, 0.0, 0.0};     ///< unit
  glm::dvec3 up{0.0, 1.0, 0.0};        ///< unit
  glm::dvec3 forward{0.0, 0.0, -1.0};  ///< unit; the three are perpendicular
  bool orthographic = false;
  double half_height = 0.5;  ///< of the view: at unit distance, or of the slab if orthographic
};

/// Points `camera` from `eye` to `target`. Throws `std::invalid_argument` if they coincide, or a
/// coordinate is not finite. If the view is along `up`, +X is to the right: in a view from above,
/// -Z is then up in the picture if `up` is +Y, and +Y if it is +Z.
Camera look_at(const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up);

/// An orthographic camera in place of `camera`, which keeps the size of what lies at `distance`
/// from the eye.
Camera orthographic(Camera camera, double distance);

/// Where a scene is seen from: a direction around its middle.
struct Orbit {
  glm::dvec3 towards_eye{0.0};  ///< unit
  glm::dvec3 up{0.0};           ///< unit, upright in the picture
};

/// From `azimuth` round the axis `up`, and `elevation` above the plane across it, in radians. The
/// azimuth is 0 from the front, which is +Z if `up` is +Y and -Y if it is +Z, and grows to the
/// right, so that +X is seen from a quarter turn.
Orbit orbit(const glm::dvec3& up, double azimuth, double elevation);

/// From the front right and above, 35 degrees round and 25 up: the unit vector towards the eye of a
/// three-quarter view.
glm::dvec3 three_quarter(const glm::dvec3& up);

/// Views `bounds` whole from where `towards_eye`, a unit vector, points, with `up` upright: for
/// files without a camera. `aspect` is width over height.
Camera frame(const Bounds& bounds, const glm::dvec3& towards_eye, const glm::dvec3& up,
             double aspect, bool orthographic);

/// An image plane of `width` x `height` pixels for a camera.
class ImagePlane {
 public:
  ImagePlane(const Camera& camera, int width, int height);

  /// The ray through the point (x, y) in pixels from the top left corner of the image: the
  /// centre of pixel (i, j) is (i + 0.5, j + 0.5). The direction is of unit length.
  Ray ray(double x, double y) const noexcept;

  /// The ray of sample (x, y) of a picture, which goes through the centre of pixel (x, y). The
  /// lattice of samples is that of a `CategoryImage`; between them, coordinates may be broken.
  Ray sample_ray(double x, double y) const noexcept { return ray(x + to_centre, y + to_centre); }

  /// From a pixel's top left corner to its centre, in each coordinate.
  static constexpr double to_centre = 0.5;

  /// Where `point` is seen, in pixels. Points behind the camera give no sensible place.
  glm::dvec2 project(const glm::dvec3& point) const noexcept;

 private:
  Camera camera_;
  double pixel_;  // side of a pixel on the plane
  double centre_x_;
  double centre_y_;
};

}  // namespace raycat
