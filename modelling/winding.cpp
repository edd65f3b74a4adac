#include "modelling/winding.hpp"

#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include <CGAL/Arr_curve_data_traits_2.h>
#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include "modelling/crossing_limit.hpp"

namespace raycat {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;

// What overlapping edges add up to. A curve's turns are counted along it from its smaller end.
struct Sum {
  int operator()(int a, int b) const { return a + b; }
};

using Traits = CGAL::Arr_curve_data_traits_2<CGAL::Arr_segment_traits_2<Kernel>, int, Sum>;

struct Face {
  int winding = 0;
  bool reached = false;
  bool inside = false;
};

// Of a corner, its place in the row of edges being followed; of an edge, whether it was followed.
constexpr std::size_t nowhere = ~std::size_t{0};
using Plane = CGAL::Arrangement_2<Traits, CGAL::Arr_extended_dcel<Traits, std::size_t, bool, Face>>;
using Edge = Plane::Halfedge_handle;

bool is_finite(const glm::dvec2& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

void arrange(std::span<const WindingEdge> edges, Plane& plane) {
  std::vector<Traits::Curve_2> curves;
  curves.reserve(edges.size());
  for (const auto& [from, to, turns] : edges) {
    if (from == to) {
      continue;
    }
    const Kernel::Segment_2 segment(Kernel::Point_2(from.x, from.y), Kernel::Point_2(to.x, to.y));
    const bool rises = from.x < to.x || (from.x == to.x && from.y < to.y);
    curves.emplace_back(segment, rises ? turns : -turns);
  }
  CGAL::insert(plane, curves.begin(), curves.end());
  for (Edge edge = plane.halfedges_begin(); edge != plane.halfedges_end(); ++edge) {
    edge->set_data(false);
  }
  for (auto corner = plane.vertices_begin(); corner != plane.vertices_end(); ++corner) {
    corner->set_data(nowhere);
  }
}

int turns_to_the_left(const Edge& edge) {
  const int turns = edge->curve().data();
  return edge->direction() == CGAL::ARR_LEFT_TO_RIGHT ? turns : -turns;
}

template <typename Circulator, typename Visit>
void around(Circulator first, Visit visit) {
  Circulator edge = first;
  do {
    visit(edge);
  } while (++edge != first);
}

// Calls `visit` on every halfedge with `face` to its left.
template <typename Visit>
void along_boundaries(Plane::Face_handle face, Visit visit) {
  for (auto outer = face->outer_ccbs_begin(); outer != face->outer_ccbs_end(); ++outer) {
    around(*outer, visit);
  }
  for (auto hole = face->inner_ccbs_begin(); hole != face->inner_ccbs_end(); ++hole) {
    around(*hole, visit);
  }
}

template <typename Inside>
void wind(Plane& plane, Inside inside) {
  std::vector<Plane::Face_handle> waiting{plane.unbounded_face()};
  plane.unbounded_face()->data().reached = true;
  while (!waiting.empty()) {
    const Plane::Face_handle face = waiting.back();
    waiting.pop_back();
    const int winding = face->data().winding;
    face->data().inside = inside(winding);
    along_boundaries(face, [&](const Edge& edge) {
      Face& beyond = edge->twin()->face()->data();
      if (!beyond.reached) {
        beyond.reached = true;
        beyond.winding = winding - turns_to_the_left(edge);
        waiting.push_back(edge->twin()->face());
      }
    });
  }
}

bool is_boundary(const Edge& edge) {
  return edge->face()->data().inside && !edge->twin()->face()->data().inside;
}

// The boundary edge after this one, turning through the inside.
Edge next_boundary(const Edge& edge) {
  Edge next = edge->next();
  while (!is_boundary(next)) {
    next = next->twin()->next();
  }
  return next;
}

// A corner in the straight, which nothing else touches.
bool is_straight(const Edge& in, const Edge& out) {
  int boundaries = 0;
  around(in->target()->incident_halfedges(), [&](const Edge& edge) {
    boundaries += is_boundary(edge) || is_boundary(edge->twin()) ? 1 : 0;
  });
  return boundaries == 2 &&
         CGAL::collinear(in->source()->point(), in->target()->point(), out->target()->point());
}

double rounded(const Kernel::FT& exact) {
  const CGAL::Interval_nt<false> bounds = exact.approx();
  return bounds.is_point() ? bounds.inf() : CGAL::to_double(exact.exact());
}

void append_contour(std::span<const Edge> loop, Polygons& out) {
  Contour contour;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (is_straight(loop[i], loop[(i + 1) % loop.size()])) {
      continue;
    }
    const Kernel::Point_2& exact = loop[i]->target()->point();
    const glm::dvec2 corner(rounded(exact.x()), rounded(exact.y()));
    if (contour.empty() || contour.back() != corner) {
      contour.push_back(corner);
    }
  }
  while (contour.size() > 1 && contour.front() == contour.back()) {
    contour.pop_back();
  }
  if (contour.size() > 2) {
    out.contours.push_back(std::move(contour));
  }
}

// Follows the boundary from `first`, and puts aside each loop as it closes.
void follow(const Edge& first, std::vector<Edge>& path, Polygons& out) {
  path.clear();
  first->source()->set_data(0);
  for (Edge edge = first; !edge->data(); edge = next_boundary(edge)) {
    edge->set_data(true);
    path.push_back(edge);
    const std::size_t start = edge->target()->data();
    if (start == nowhere) {
      edge->target()->set_data(path.size());
      continue;
    }
    const std::span<const Edge> loop = std::span(path).subspan(start);
    for (const Edge& closed : loop.first(loop.size() - 1)) {
      closed->target()->set_data(nowhere);
    }
    append_contour(loop, out);
    path.resize(start);
  }
  first->source()->set_data(nowhere);
}

template <typename Inside>
Polygons region(std::span<const WindingEdge> edges, Inside inside) {
  for (const WindingEdge& edge : edges) {
    if (!is_finite(edge.from) || !is_finite(edge.to)) {
      throw std::invalid_argument("a polygon has a corner that is not finite");
    }
  }
  require_few_crossings(edges);
  Plane plane;
  arrange(edges, plane);
  wind(plane, inside);
  Polygons out;
  std::vector<Edge> path;
  for (Edge edge = plane.halfedges_begin(); edge != plane.halfedges_end(); ++edge) {
    if (!edge->data() && is_boundary(edge)) {
      follow(edge, path, out);
    }
  }
  return out;
}

}  // namespace

void add_edges(const Contour& contour, int turns, std::vector<WindingEdge>& out) {
  for (std::size_t i = 0; i < contour.size(); ++i) {
    out.push_back({contour[i], contour[(i + 1) % contour.size()], turns});
  }
}

void add_edges(const Polygons& polygons, int turns, std::vector<WindingEdge>& out) {
  for (const Contour& contour : polygons.contours) {
    add_edges(contour, turns, out);
  }
}

Polygons wound_region(std::span<const WindingEdge> edges, int least) {
  return region(edges, [&](int winding) { return winding >= least; });
}

Polygons odd_region(std::span<const WindingEdge> edges) {
  return region(edges, [](int winding) { return winding % 2 != 0; });
}

}  // namespace raycat
