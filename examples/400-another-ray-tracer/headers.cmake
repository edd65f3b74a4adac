# Fails if OBJECT, built by NINJA in the current folder, was made from a header of raycat that is
# neither of categories and edges nor of the node's, or from one of a package but GLM. Run by ctest:
# cmake -DNINJA=... -DOBJECT=... -P headers.cmake
cmake_minimum_required(VERSION 3.25)

set(of_node raytree/listing.hpp raytree/ray_tree.hpp raytree/surface_id.hpp raytree/surface_table.hpp)
execute_process(COMMAND ${NINJA} -t deps ${OBJECT} OUTPUT_VARIABLE used
  COMMAND_ERROR_IS_FATAL ANY)
if(NOT used MATCHES "raytree/ray_tree.hpp")
  message(FATAL_ERROR "ninja knows no headers of ${OBJECT}:\n${used}")
endif()
string(REGEX MATCHALL "include/raycat/[a-z_/.]+" headers "${used}")
foreach(header ${headers})
  string(REPLACE "include/raycat/" "" header ${header})
  if(NOT header MATCHES "^(categories|edges)/" AND NOT header IN_LIST of_node)
    message(SEND_ERROR "an adopter includes ${header}")
  endif()
endforeach()
string(REGEX MATCHALL "[^\n]*/(boost|embree3|fmt)/[^\n]*" headers "${used}")
foreach(header ${headers})
  message(SEND_ERROR "an adopter includes ${header}")
endforeach()
