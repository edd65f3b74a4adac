// spheres SCENE NAME: draws the balls of the scene file into NAME.ppm.
//
// A small ray tracer of its own design: it does not recurse, but keeps a stack of the rays that it
// has yet to follow.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

struct Vec {
  double x, y, z;
};

Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec operator*(Vec a, Vec b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
Vec operator*(double s, Vec a) { return {s * a.x, s * a.y, s * a.z}; }
double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec unit(Vec a) { return 1.0 / std::sqrt(dot(a, a)) * a; }
std::istream& operator>>(std::istream& in, Vec& a) { return in >> a.x >> a.y >> a.z; }

struct Ball {
  Vec centre;
  double radius;
  Vec colour;
  double mirror, glass;  // shares of the light that it reflects and lets through
};

struct Pending {
  Vec from, along;
  double weight;
  int depth;
};

constexpr int width = 480, height = 320, deepest = 6;
constexpr double glass_index = 1.5;
constexpr Vec sky{0.55, 0.7, 0.9};

struct Tracer {
  std::vector<Ball> balls;
  std::vector<Vec> lamps;
  std::vector<Pending> pending;

  bool read(std::istream& in);
  int nearest(Vec from, Vec along, double& t) const;
  Vec look(Vec from, Vec along);
};

// Lines of "ball CENTRE RADIUS COLOUR MIRROR GLASS" and "lamp POSITION".
bool Tracer::read(std::istream& in) {
  for (std::string kind; in >> kind;) {
    Ball ball{};
    if (kind == "ball" &&
        in >> ball.centre >> ball.radius >> ball.colour >> ball.mirror >> ball.glass) {
      balls.push_back(ball);
    } else if (Vec lamp{}; kind == "lamp" && in >> lamp) {
      lamps.push_back(lamp);
    } else {
      return false;
    }
  }
  return !balls.empty();
}

// The ball that the ray meets first, before `t`, which becomes where; -1 if it meets none.
int Tracer::nearest(Vec from, Vec along, double& t) const {
  int found = -1;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const Vec offset = from - balls[i].centre;
    const double b = dot(offset, along);
    const double root = b * b - dot(offset, offset) + balls[i].radius * balls[i].radius;
    if (root < 0) {
      continue;
    }
    for (const double at : {-b - std::sqrt(root), -b + std::sqrt(root)}) {
      if (at > 1e-6 && at < t) {
        t = at;
        found = static_cast<int>(i);
      }
    }
  }
  return found;
}

// The colour seen from a point in a direction, a unit vector.
Vec Tracer::look(Vec from, Vec along) {
  Vec sum{0, 0, 0};
  pending.push_back({from, along, 1.0, 1});
  while (!pending.empty()) {
    const Pending ray = pending.back();
    pending.pop_back();
    double t = std::numeric_limits<double>::infinity();
    const int hit = nearest(ray.from, ray.along, t);
    if (hit < 0) {
      sum = sum + ray.weight * sky;
      continue;
    }
    const Ball& ball = balls[static_cast<std::size_t>(hit)];
    const Vec point = ray.from + t * ray.along;
    const Vec outward = 1.0 / ball.radius * (point - ball.centre);
    const bool inside = dot(outward, ray.along) > 0;
    const Vec normal = inside ? -1.0 * outward : outward;

    Vec light{0.15, 0.15, 0.15};
    for (std::size_t i = 0; i < lamps.size(); ++i) {
      const Vec way = unit(lamps[i] - point);
      double free = dot(lamps[i] - point, way);
      if (dot(normal, way) <= 0 || nearest(point, way, free) >= 0) {
        continue;
      }
      const double share = 0.85 / static_cast<double>(lamps.size()) * dot(normal, way);
      light = light + Vec{share, share, share};
    }
    sum = sum + ray.weight * (1 - ball.mirror - ball.glass) * (ball.colour * light);
    if (ray.depth == deepest) {
      continue;
    }

    const double cosine = -dot(normal, ray.along);
    const double ratio = inside ? glass_index : 1 / glass_index;
    const double bent = 1 - ratio * ratio * (1 - cosine * cosine);
    double mirror = ball.mirror;
    if (ball.glass > 0 && bent < 0) {
      mirror += ball.glass;  // total reflection
    } else if (ball.glass > 0) {
      const Vec into = ratio * ray.along + (ratio * cosine - std::sqrt(bent)) * normal;
      pending.push_back({point, unit(into), ray.weight * ball.glass, ray.depth + 1});
    }
    if (mirror > 0) {
      const Vec back = unit(ray.along + 2 * cosine * normal);
      pending.push_back({point, back, ray.weight * mirror, ray.depth + 1});
    }
  }
  return sum;
}

int main(int argc, char** argv) {
  Tracer tracer;
  std::ifstream scene(argc == 3 ? argv[1] : "");
  if (!tracer.read(scene)) {
    std::fputs("usage: spheres SCENE NAME, where SCENE holds balls and lamps\n", stderr);
    return 2;
  }
  std::ofstream picture(std::string(argv[2]) + ".ppm", std::ios::binary);
  picture << "P6\n" << width << ' ' << height << "\n255\n";
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double right = (2 * (x + 0.5) - width) / height;
      const double up = 1 - 2 * (y + 0.5) / height;
      const Vec colour = tracer.look({0, 0, 0}, unit({right, up - 0.9, -3.2}));
      for (const double part : {colour.x, colour.y, colour.z}) {
        picture.put(static_cast<char>(std::lround(255 * std::sqrt(std::clamp(part, 0.0, 1.0)))));
      }
    }
  }
  return picture.flush() ? 0 : 1;
}
