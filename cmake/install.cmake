# cmake --install: the program, and for find_package(raycat) the libraries. Each is exported by
# itself, so that whoever wants one needs the packages of that one and of those it uses alone.
include(CMakePackageConfigHelpers)
set(destination ${CMAKE_INSTALL_LIBDIR}/cmake/raycat)
install(TARGETS raycat RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY assets/scenes DESTINATION ${CMAKE_INSTALL_DATADIR}/raycat)
install(TARGETS raycat_options EXPORT raycat_options)
install(EXPORT raycat_options NAMESPACE raycat:: DESTINATION ${destination})
foreach(library ${raycat_libraries})
  install(TARGETS raycat_${library} EXPORT raycat_${library}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(EXPORT raycat_${library} NAMESPACE raycat:: DESTINATION ${destination})
endforeach()
install(CODE "
  include(\"${PROJECT_SOURCE_DIR}/cmake/public_headers.cmake\")
  raycat_public_headers(\"${PROJECT_SOURCE_DIR}\"
    \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_INCLUDEDIR}\")")
write_basic_package_version_file(${PROJECT_BINARY_DIR}/raycatConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
configure_file(cmake/raycatConfig.cmake.in raycatConfig.cmake @ONLY)
install(FILES cmake/rooms.cmake ${PROJECT_BINARY_DIR}/raycatConfig.cmake
  ${PROJECT_BINARY_DIR}/raycatConfigVersion.cmake
  DESTINATION ${destination})
