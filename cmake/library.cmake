# raycat_library(NAME SOURCES...): the library of a folder, linked as cmake/rooms.cmake has it;
# headers alone if there are no sources.
function(raycat_library name)
  set(target raycat_${name})
  if(ARGN)
    add_library(${target} STATIC ${ARGN})
    set(public PUBLIC)
    set(private PRIVATE)
  else()
    add_library(${target} INTERFACE)
    set(public INTERFACE)
    set(private INTERFACE)
  endif()
  add_library(raycat::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  raycat_libraries_used(${name} used)
  list(TRANSFORM used PREPEND raycat::)
  target_link_libraries(${target} ${public} raycat::options ${used})
  if(ARGN)
    target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:raycat_flags>)
  endif()
  foreach(package ${raycat_packages_${name}})
    if(package IN_LIST raycat_packages_in_headers)
      target_link_libraries(${target} ${public} ${raycat_target_${package}})
    else()
      target_link_libraries(${target} ${private} ${raycat_target_${package}})
    endif()
  endforeach()
endfunction()

# raycat_precompile(TARGET HEADERS...): for what is slow to compile and most of its sources include.
# The cache of compilations wants GCC to say which precompiled header it takes, and clang to keep no
# time in it.
function(raycat_precompile target)
  target_precompile_headers(${target} PRIVATE ${ARGN})
  target_compile_options(${target} PRIVATE
    $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>
    "$<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>")
endfunction()
