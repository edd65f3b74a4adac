# Installs BUILD into a folder of its own and builds and runs CONSUMER against it.
set(prefix ${BUILD}/install-test)
file(REMOVE_RECURSE ${prefix})
foreach(command
    "${CMAKE_COMMAND};--install;${BUILD};--prefix;${prefix}/usr"
    "${CMAKE_COMMAND};-S;${CONSUMER};-B;${prefix}/consumer;-G;Ninja;-DCMAKE_PREFIX_PATH=${prefix}/usr;-DCMAKE_CXX_FLAGS=${FLAGS};-DCMAKE_BUILD_TYPE=${TYPE}"
    "${CMAKE_COMMAND};--build;${prefix}/consumer"
    "${prefix}/consumer/consumer"
    "${prefix}/usr/bin/raycat;--version")
  execute_process(COMMAND ${command} COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
endforeach()
