# Draws the rooms of cmake/rooms.cmake as an SVG: each above what it uses, with an arrow to each of
# these that it does not use by way of another. cmake -DROOT=... -DOUT=docs/rooms.svg -P this; with
# -DCHECK=ON it fails if OUT is not that picture.
cmake_minimum_required(VERSION 3.25)
set(RAYCAT_WITH_CGAL ON)
include(${ROOT}/cmake/rooms.cmake)

set(box_width 92)
set(box_height 26)
set(column 104)
set(row 74)

# The row of each room, from the bottom, and all that it uses, also by way of others.
set(rows 0)
foreach(room ${raycat_rooms})
  set(level_${room} 0)
  set(all_${room})
  foreach(used ${raycat_uses_${room}})
    math(EXPR above "${level_${used}} + 1")
    if(above GREATER level_${room})
      set(level_${room} ${above})
    endif()
    list(APPEND all_${room} ${used} ${all_${used}})
  endforeach()
  list(APPEND rooms_of_${level_${room}} ${room})
  if(level_${room} GREATER rows)
    set(rows ${level_${room}})
  endif()
endforeach()

# Where each stands: the rooms of a row share its width.
set(most 0)
foreach(level RANGE ${rows})
  list(LENGTH rooms_of_${level} count)
  if(count GREATER most)
    set(most ${count})
  endif()
endforeach()
math(EXPR width "${most} * ${column} + 12")
math(EXPR height "${rows} * ${row} + ${box_height} + 20")
set(boxes)
foreach(level RANGE ${rows})
  list(LENGTH rooms_of_${level} count)
  math(EXPR space "${width} / ${count}")
  math(EXPR x "${space} / 2 - ${box_width} / 2")
  math(EXPR y "10 + (${rows} - ${level}) * ${row}")
  foreach(room ${rooms_of_${level}})
    math(EXPR middle_${room} "${x} + ${box_width} / 2")
    set(top_${room} ${y})
    math(EXPR bottom_${room} "${y} + ${box_height}")
    math(EXPR text_y "${y} + 17")
    string(APPEND boxes
      "  <rect x=\"${x}\" y=\"${y}\" width=\"${box_width}\" height=\"${box_height}\" rx=\"4\"/>\n"
      "  <text x=\"${middle_${room}}\" y=\"${text_y}\">${room}</text>\n")
    math(EXPR x "${x} + ${space}")
  endforeach()
endforeach()

set(arrows)
foreach(room ${raycat_rooms})
  foreach(used ${raycat_uses_${room}})
    set(by_way FALSE)
    foreach(other ${raycat_uses_${room}})
      if(used IN_LIST all_${other})
        set(by_way TRUE)
      endif()
    endforeach()
    if(NOT by_way)
      math(EXPR bend_from "${bottom_${room}} + 24")
      math(EXPR bend_to "${top_${used}} - 24")
      string(APPEND arrows
        "  <path d=\"M${middle_${room}} ${bottom_${room}}C${middle_${room}} ${bend_from} "
        "${middle_${used}} ${bend_to} ${middle_${used}} ${top_${used}}\"/>\n")
    endif()
  endforeach()
endforeach()

set(picture "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"${width}\" height=\"${height}\" \
viewBox=\"0 0 ${width} ${height}\">
  <title>The rooms of raycat, each above what it uses</title>
  <style>
    svg { background: #fff }
    rect { fill: #f4f1ea; stroke: #444 }
    text { font: 12px sans-serif; text-anchor: middle; fill: #111 }
    path { fill: none; stroke: #8a8578; marker-end: url(#tip) }
  </style>
  <marker id=\"tip\" viewBox=\"0 0 8 8\" refX=\"8\" refY=\"4\" markerWidth=\"7\" markerHeight=\"7\" \
orient=\"auto\"><polygon points=\"0,1 8,4 0,7\" fill=\"#8a8578\"/></marker>
${arrows}${boxes}</svg>
")
if(NOT CHECK)
  file(WRITE ${OUT} "${picture}")
  return()
endif()
file(READ ${OUT} there)
if(NOT there STREQUAL picture)
  message(FATAL_ERROR "${OUT} shows other rooms than cmake/rooms.cmake: draw it anew with "
    "cmake -DROOT=. -DOUT=docs/rooms.svg -P cmake/rooms_picture.cmake")
endif()
