# Headers are included as "striate/<folder>/<file>", here and where Striate is installed, so nothing
# of a user's include path is claimed but `striate/`. In the build tree that is a folder of links.
set(STRIATE_INCLUDE_DIR ${PROJECT_BINARY_DIR}/include)
file(MAKE_DIRECTORY ${STRIATE_INCLUDE_DIR}/striate)
foreach(folder agent app base behaviours config evaluation memory perception platform python tasks viewer)
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${folder} ${STRIATE_INCLUDE_DIR}/striate/${folder} SYMBOLIC)
endforeach()

# The program looks for its configuration beside itself; an installation has it in share/striate.
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/config ${PROJECT_BINARY_DIR}/config SYMBOLIC)

# striate_layer(<name> <folder> "<layers it may include>") makes the library striate::<name> of all
# sources below the folder and notes the rule for the include test.

function(striate_layer name folder allowed)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.cpp)
  list(REMOVE_ITEM sources ${PROJECT_SOURCE_DIR}/app/main.cpp ${PROJECT_SOURCE_DIR}/app/late_opencv.cpp)
  if(NOT STRIATE_ROS_FOUND)
    list(FILTER sources EXCLUDE REGEX "/(platform|agent|app)/ros/")
  endif()
  if(sources)
    add_library(striate_${name} STATIC ${sources})
    set(scope PUBLIC)
    striate_compile(striate_${name})
    striate_compile_together(striate_${name} ${sources})
    # Plugins link the layers into shared objects. Without interposition the compiler inlines as before.
    set_target_properties(striate_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_compile_options(striate_${name} PRIVATE -fno-semantic-interposition)
  else()
    add_library(striate_${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  add_library(striate::${name} ALIAS striate_${name})
  set_target_properties(striate_${name} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(striate_${name} ${scope} ${STRIATE_STANDARD})
  target_include_directories(striate_${name} ${scope} $<BUILD_INTERFACE:${STRIATE_INCLUDE_DIR}> $<INSTALL_INTERFACE:include>)
  separate_arguments(deps UNIX_COMMAND "${allowed}")
  foreach(dep IN LISTS deps)
    target_link_libraries(striate_${name} ${scope} striate::${dep})
  endforeach()
  string(REPLACE " " "," allowed_csv "${allowed}")
  set_property(GLOBAL APPEND PROPERTY STRIATE_LAYER_TABLE "${name} ${folder} ${allowed_csv}")
  striate_rule(${name} ${folder} "${allowed}")
endfunction()

# The rule alone, for the include test: striate_layer() calls it, and what is no library of its own.
function(striate_rule name folder allowed)
  string(REPLACE " " "," allowed_csv "${allowed}")
  set_property(GLOBAL APPEND PROPERTY STRIATE_RULES "${name} ${folder} ${allowed_csv}")
endfunction()

# Who links a layer is compiled as C++20, but for a target that reads ROS 1's generated headers.
set(STRIATE_STANDARD $<IF:$<BOOL:$<TARGET_PROPERTY:STRIATE_READS_ROS_HEADERS>>,cxx_std_17,cxx_std_20>)

# striate_uses(<layer> [PUBLIC libs...] [PRIVATE libs...]): libraries from Debian.
function(striate_uses name)
  cmake_parse_arguments(uses "" "" "PUBLIC;PRIVATE" ${ARGN})
  set_property(GLOBAL APPEND PROPERTY STRIATE_USES_${name} ${uses_PUBLIC} ${uses_PRIVATE})
  get_target_property(type striate_${name} TYPE)
  if(type STREQUAL "INTERFACE_LIBRARY")
    target_link_libraries(striate_${name} INTERFACE ${uses_PUBLIC} ${uses_PRIVATE})
  else()
    target_link_libraries(striate_${name} PUBLIC ${uses_PUBLIC} PRIVATE ${uses_PRIVATE})
  endif()
endfunction()

# striate_compile_together(<target> sources...): up to so many files at once. Reading headers takes two thirds of a
# build by single files. So names in the anonymous namespaces of a layer, or of a folder of tests, must differ;
# the `dev` preset goes without, and there every file says what it includes.
set(STRIATE_FILES_AT_ONCE 25)
function(striate_compile_together target)
  if(CMAKE_DISABLE_PRECOMPILE_HEADERS)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  set(together "")
  foreach(source IN LISTS ARGN)
    # Highway compiles such a file once for each instruction set: it stays alone.
    file(STRINGS ${source} targets REGEX "hwy/foreach_target.h" LIMIT_COUNT 1)
    if(NOT targets)
      list(APPEND together ${source})
    endif()
  endforeach()
  list(LENGTH together count)
  math(EXPR parts "(${count} + ${STRIATE_FILES_AT_ONCE} - 1) / ${STRIATE_FILES_AT_ONCE}")
  set(index 0)
  foreach(source IN LISTS together)
    math(EXPR part "${index} * ${parts} / ${count}")  # of about one size
    math(EXPR index "${index} + 1")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP part_${part})
  endforeach()
endfunction()

# striate_precompile(<target> headers...): the large headers of others, read once a target instead
# of once a file. The `dev` preset goes without, so that every file says what it includes.
function(striate_precompile target)
  get_target_property(type ${target} TYPE)
  if(NOT type STREQUAL "INTERFACE_LIBRARY")
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()
