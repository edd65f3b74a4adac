// check trees|colours|ball|outline SCENE NAME: is NAME-edges.pgm, which spheres_raycat drew, right,
// or NAME-outlines.pgm, which more drew?

#define main spheres_main
#include "spheres_raycat.cpp"
#undef main

#include <cstdlib>
#include <functional>
#include <iterator>
#include <map>
#include <utility>

struct Bytes {
  std::string data;
  int channels;

  int at(int x, int y, int channel = 0) const {
    const auto pixel = static_cast<std::size_t>(y * width + x);
    const auto i = pixel * static_cast<std::size_t>(channels) + static_cast<std::size_t>(channel);
    return static_cast<unsigned char>(data.at(data.size() - size() + i));
  }
  std::size_t size() const { return static_cast<std::size_t>(width * height * channels); }
};

Bytes load(const std::string& path, int channels) {
  std::ifstream file(path, std::ios::binary);
  Bytes bytes{std::string(std::istreambuf_iterator<char>(file), {}), channels};
  if (bytes.data.size() < bytes.size()) {
    std::fprintf(stderr, "check: %s is missing or short\n", path.c_str());
    std::exit(2);
  }
  return bytes;
}

Vec towards(int x, int y) {
  return {(2 * x + 1.0 - width) / height, (height - 2 * y - 1.0) / height - 0.9, -3.2};
}

// What the sample (x, y) is of, for samples to be alike or not.
using Kind = std::map<std::uint64_t, std::pair<std::uint64_t, std::uint32_t>>;

// May a ray of the scene have come to `position`? To an odd one from a mirror or from inside glass,
// to an even one through glass.
bool explained(const Tracer& tracer, const Kind& kind, std::uint64_t position) {
  if (position == 1) {
    return true;
  }
  const auto parent = kind.find(position / 2);
  if (parent == kind.end()) {
    return false;
  }
  const Ball& ball = tracer.balls.at(parent->second.second);
  return ball.glass > 0 || (position % 2 == 1 && ball.mirror > 0);
}

// Its tree as it is, by position: no order, no encoder, no table.
Kind tree_kind(Tracer& tracer, int x, int y, int& misplaced) {
  tracer.look({0, 0, 0}, unit(towards(x, y)));
  Kind kind;
  for (const raycat::RayNode& node : tracer.tree) {
    kind[node.position] = {node.lights, static_cast<std::uint32_t>(node.surface)};
  }
  for (const raycat::RayNode& node : tracer.tree) {
    misplaced += explained(tracer, kind, node.position) ? 0 : 1;
  }
  return kind;
}

// The one ball is missed, lit or dark there, in closed form.
Kind ball_kind(const Tracer& tracer, int x, int y, bool lights) {
  const Vec d = towards(x, y);
  const Vec c = tracer.balls.at(0).centre;
  const double r = tracer.balls.at(0).radius;
  const double root = dot(d, c) * dot(d, c) - dot(d, d) * (dot(c, c) - r * r);
  if (root < 0) {
    return {};
  }
  const Vec point = (dot(d, c) - std::sqrt(root)) / dot(d, d) * d;
  const bool lit = dot(point - c, tracer.lamps.at(0) - point) > 0;
  return {{1, {lights && lit ? 1 : 0, 0}}};
}

// Edges must be the pixels whose four samples are not of one kind.
int check_kinds(const Bytes& edges, const std::function<Kind(int, int)>& kind) {
  int wrong = 0, right = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Kind here = kind(x, y);
      const bool edge =
          here != kind(x + 1, y) || here != kind(x, y + 1) || here != kind(x + 1, y + 1);
      wrong += (edges.at(x, y) == 0) != edge ? 1 : 0;
      right += (edges.at(x, y) == 0) && edge ? 1 : 0;
    }
  }
  std::printf("%d edge pixels as expected, %d pixels not\n", right, wrong);
  return wrong == 0 && right > 500 ? 0 : 1;
}

// Colours must not leap from a pixel to the next where there is no edge: within one category
// nothing new comes into sight and no shadow begins.
int check_colours(const Bytes& edges, const Bytes& picture) {
  int most_without = 0, leaps = 0;
  for (int y = 0; y + 1 < height; ++y) {
    for (int x = 0; x + 1 < width; ++x) {
      int step = 0;
      for (int channel = 0; channel < 3; ++channel) {
        for (const auto& [i, j] : {std::pair{x + 1, y}, std::pair{x, y + 1}}) {
          step = std::max(step, std::abs(picture.at(x, y, channel) - picture.at(i, j, channel)));
        }
      }
      if (edges.at(x, y) != 0) {
        most_without = std::max(most_without, step);
      } else {
        leaps += step > 32 ? 1 : 0;
      }
    }
  }
  std::printf("steps of up to %d without an edge; %d edge pixels with more than 32\n", most_without,
              leaps);
  return most_without <= 32 && leaps > 500 ? 0 : 1;
}

int main(int argc, char** argv) {
  Tracer tracer;
  std::ifstream scene(argc == 4 ? argv[2] : "");
  if (!tracer.read(scene)) {
    std::fputs("usage: check trees|colours|ball|outline SCENE NAME\n", stderr);
    return 2;
  }
  const std::string what = argv[1];
  const std::string name = argv[3];
  const Bytes edges = load(name + (what == "outline" ? "-outlines.pgm" : "-edges.pgm"), 1);
  if (what == "colours") {
    return check_colours(edges, load(name + ".ppm", 3));
  }
  int misplaced = 0;
  const int failed = check_kinds(edges, [&](int x, int y) {
    return what == "trees" ? tree_kind(tracer, x, y, misplaced)
                           : ball_kind(tracer, x, y, what == "ball");
  });
  std::printf("%d nodes at positions that no ray can have\n", misplaced);
  return misplaced == 0 ? failed : 1;
}
