# Fails unless spheres_raycat.cpp is spheres.cpp with at most 40 lines added, two of them in the
# place of others, and docs/adopting.md shows them all, says how many they are, and shows no C++
# that is not compiled here. Run by ctest: cmake -P added_lines.cmake
cmake_minimum_required(VERSION 3.25)

set(here ${CMAKE_CURRENT_LIST_DIR})
set(page ${here}/../../docs/adopting.md)
set(difference COMMAND diff ${here}/spheres.cpp ${here}/spheres_raycat.cpp)
execute_process(${difference} COMMAND grep -c "^>" OUTPUT_VARIABLE added
  OUTPUT_STRIP_TRAILING_WHITESPACE)
execute_process(${difference} COMMAND grep -c "^<" OUTPUT_VARIABLE replaced
  OUTPUT_STRIP_TRAILING_WHITESPACE)
execute_process(${difference} COMMAND sed -n "s/^> //p" COMMAND grep -vxFf ${page}
  OUTPUT_VARIABLE unshown)
execute_process(COMMAND sed -n "/^```cpp/,/^```$/p" ${page} COMMAND grep -v "^```"
  COMMAND grep -vxF -f ${here}/spheres_raycat.cpp -f ${here}/more.cpp OUTPUT_VARIABLE stale)
file(READ ${page} text)

message("${added} lines added, ${replaced} of them in the place of others")
if(added LESS 1 OR added GREATER 40)
  message(SEND_ERROR "expected 1 to 40 added lines")
endif()
if(NOT replaced EQUAL 2)
  message(SEND_ERROR "expected 2 replaced lines")
endif()
if(NOT text MATCHES "The difference is ${added} lines, two of them")
  message(SEND_ERROR "docs/adopting.md does not say that these are ${added} lines")
endif()
if(unshown)
  message(SEND_ERROR "added lines that docs/adopting.md does not show:\n${unshown}")
endif()
if(stale)
  message(SEND_ERROR "lines of docs/adopting.md that are in no program:\n${stale}")
endif()
