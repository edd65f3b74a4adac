#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>

#include "geometry/mesh.hpp"
#include "modelling/exact.hpp"

namespace raycat {

/// CGAL's exact solids. For the sources of `modelling` alone.
using Nef = CGAL::Nef_polyhedron_3<Exact>;

/// What a closed mesh encloses, cavities left out. Throws `std::runtime_error` if the mesh is not
/// closed or touches itself along an edge.
Nef nef_of(const TriangleMesh& mesh);

/// The boundary as a closed mesh of one face, in doubles.
TriangleMesh mesh_of(const Nef& nef);

}  // namespace raycat
