#pragma once

/// raycat as a library: load a scene, render it, find its edges, write pictures.
///
///     const raycat::SceneView scene("bracket.csg");
///     const raycat::Rendering picture = scene.render({.width = 900, .height = 700});
///     const raycat::EdgeMap edges = raycat::detect_edges(picture.categories);
///     raycat::write_image("lines.png", raycat::line_image(edges));
///
/// Start with `SceneView`; examples/ goes on from there. A different ray tracer needs only
/// categories and edges (docs/adopting.md). Antialiasing is the program's alone so far.

#include "categories/category_trees.hpp"
#include "categories/recode.hpp"
#include "edges/edge_classes.hpp"
#include "edges/edge_map.hpp"
#include "edges/refine.hpp"
#include "edges/regions.hpp"
#include "io/files/load_error.hpp"
#include "io/images/image_file.hpp"
#include "io/images/indexed_png.hpp"
#include "io/load_scene.hpp"
#include "raycat/scene_view.hpp"
#include "raytree/listing.hpp"
#include "render/edge_class_palette.hpp"
#include "render/paint.hpp"
#include "render/render.hpp"
#include "render/view_as.hpp"
