# Installs BUILD into PREFIX, and nothing that an earlier build has left there.
file(REMOVE_RECURSE ${PREFIX})
foreach(command
    "${CMAKE_COMMAND};--install;${BUILD};--prefix;${PREFIX}"
    "${PREFIX}/bin/raycat;--version")
  execute_process(COMMAND ${command} COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
endforeach()
