# Headers are included as "striate/<folder>/<file>", here and where Striate is installed, so nothing
# of a user's include path is claimed but `striate/`. In the build tree that is a folder of links.
set(STRIATE_INCLUDE_DIR ${PROJECT_BINARY_DIR}/include)
file(MAKE_DIRECTORY ${STRIATE_INCLUDE_DIR}/striate)
foreach(folder agent app base behaviours config evaluation memory perception platform tasks)
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${folder} ${STRIATE_INCLUDE_DIR}/striate/${folder} SYMBOLIC)
endforeach()

# striate_layer(<name> <folder> "<layers it may include>") makes the library striate::<name> of all
# sources below the folder and notes the rule for the include test.

function(striate_layer name folder allowed)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${folder}/*.cpp)
  list(REMOVE_ITEM sources ${CMAKE_SOURCE_DIR}/app/main.cpp)
  if(NOT STRIATE_ROS_FOUND)
    list(FILTER sources EXCLUDE REGEX "/(platform|agent|app)/ros/")
  endif()
  if(sources)
    add_library(striate_${name} STATIC ${sources})
    set(scope PUBLIC)
    target_link_libraries(striate_${name} PRIVATE striate_warnings)
  else()
    add_library(striate_${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  add_library(striate::${name} ALIAS striate_${name})
  target_include_directories(striate_${name} ${scope} $<BUILD_INTERFACE:${STRIATE_INCLUDE_DIR}>)
  separate_arguments(deps UNIX_COMMAND "${allowed}")
  foreach(dep IN LISTS deps)
    target_link_libraries(striate_${name} ${scope} striate::${dep})
  endforeach()
  string(REPLACE " " "," allowed_csv "${allowed}")
  set_property(GLOBAL APPEND PROPERTY STRIATE_LAYER_TABLE "${name} ${folder} ${allowed_csv}")
endfunction()

# striate_uses(<layer> [PUBLIC libs...] [PRIVATE libs...]): libraries from Debian.
function(striate_uses name)
  cmake_parse_arguments(uses "" "" "PUBLIC;PRIVATE" ${ARGN})
  get_target_property(type striate_${name} TYPE)
  if(type STREQUAL "INTERFACE_LIBRARY")
    target_link_libraries(striate_${name} INTERFACE ${uses_PUBLIC} ${uses_PRIVATE})
  else()
    target_link_libraries(striate_${name} PUBLIC ${uses_PUBLIC} PRIVATE ${uses_PRIVATE})
  endif()
endfunction()

# striate_precompile(<target> headers...): the large headers of others, read once a target instead
# of once a file. The `dev` preset goes without, so that every file says what it includes.
function(striate_precompile target)
  get_target_property(type ${target} TYPE)
  if(NOT type STREQUAL "INTERFACE_LIBRARY")
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()
