# The house: its rooms, what each may use, and the packages that each library needs. CMake's links,
# the layering test, the installed package and the picture in docs/design.md are all made from here.

# The rooms, which are folders, each after those that it uses. A folder at the top is a library of
# that name with all its rooms, but for app, which is the program.
set(raycat_rooms raytree threads dynamic geometry csg modelling tracer categories edges antialias render
  io/files io/scene io/images io/meshes io/gltf io/openscad io/povray io/export io
  raycat app app/study)
set(raycat_libraries ${raycat_rooms})
list(FILTER raycat_libraries EXCLUDE REGEX "/|^app$")

# raycat_uses_ROOM: the rooms whose headers ROOM includes, and no others.
set(raycat_uses_raytree)
set(raycat_uses_threads)
set(raycat_uses_dynamic)
set(raycat_uses_geometry threads)
set(raycat_uses_csg raytree geometry)
set(raycat_uses_modelling dynamic geometry csg)
set(raycat_uses_tracer raytree threads geometry csg)
set(raycat_uses_categories raytree)
set(raycat_uses_edges raytree categories)
set(raycat_uses_antialias threads)
set(raycat_uses_render raytree threads geometry tracer categories edges antialias)

set(raycat_uses_io/files)
set(raycat_uses_io/scene io/files raytree geometry csg tracer)
set(raycat_uses_io/images io/files tracer)
set(raycat_uses_io/meshes io/files io/scene geometry)
set(raycat_uses_io/gltf io/files io/scene io/images threads geometry csg tracer)
set(raycat_uses_io/openscad io/files io/scene io/images io/meshes geometry csg modelling tracer)
set(raycat_uses_io/povray io/files geometry csg tracer)
set(raycat_uses_io/export io/files raytree geometry modelling tracer)
set(raycat_uses_io io/files io/scene io/meshes io/gltf io/openscad)

set(raycat_uses_raycat raytree io/files io/images io/scene io tracer categories edges render)
set(raycat_uses_app raycat io/files io/scene io/images io/povray io/export io raytree geometry tracer
  categories edges antialias render)
set(raycat_uses_app/study app dynamic raycat io/files io/images io/povray io tracer categories
  edges render)

# raycat_packages_LIBRARY: the packages that a program with it links. raycat_packages_in_headers:
# those of them that our headers include. WebP and tinygltf, which CMake does not know, are in
# io/CMakeLists.txt.
set(raycat_packages_in_headers glm Threads)
set(raycat_packages_raytree fmt)
set(raycat_packages_threads Threads)
set(raycat_packages_dynamic fmt)
set(raycat_packages_geometry glm embree fmt)
set(raycat_packages_csg)
set(raycat_packages_modelling fmt)
if(RAYCAT_WITH_CGAL)
  list(APPEND raycat_packages_modelling CGAL)
endif()
set(raycat_packages_tracer embree fmt)
set(raycat_packages_categories fmt)
set(raycat_packages_edges glm)
set(raycat_packages_antialias glm)
set(raycat_packages_render fmt)
set(raycat_packages_raycat)
set(raycat_packages_io draco fmt JPEG meshoptimizer nlohmann_json OpenEXR OpenMesh PNG)

set(raycat_version_embree 3.13)

# raycat_target_PACKAGE: the target to link for a package.
set(raycat_target_CGAL CGAL::CGAL)
set(raycat_target_JPEG JPEG::JPEG)
set(raycat_target_OpenEXR OpenEXR::OpenEXR)
set(raycat_target_OpenMesh OpenMeshTools OpenMeshCore)
set(raycat_target_PNG PNG::PNG)
set(raycat_target_Threads Threads::Threads)
set(raycat_target_draco draco::draco)
set(raycat_target_embree embree)
set(raycat_target_fmt fmt::fmt)
set(raycat_target_glm glm::glm)
set(raycat_target_meshoptimizer meshoptimizer::meshoptimizer)
set(raycat_target_nlohmann_json nlohmann_json::nlohmann_json)

# raycat_find_package(PACKAGE OPTIONS...): find_package with the required version. Restores
# CMAKE_MODULE_PATH, to which CGAL adds finders of its own.
macro(raycat_find_package package)
  set(_raycat_module_path ${CMAKE_MODULE_PATH})
  find_package(${package} ${raycat_version_${package}} ${ARGN})
  set(CMAKE_MODULE_PATH ${_raycat_module_path})
endmacro()

# raycat_libraries_used(LIBRARY OUT): the libraries that LIBRARY uses, in all its rooms.
function(raycat_libraries_used library out)
  set(used)
  foreach(room ${raycat_rooms})
    if("${room}/" MATCHES "^${library}/")
      list(APPEND used ${raycat_uses_${room}})
    endif()
  endforeach()
  list(TRANSFORM used REPLACE "/.*" "")
  list(REMOVE_DUPLICATES used)
  list(REMOVE_ITEM used ${library})
  set(${out} ${used} PARENT_SCOPE)
endfunction()
