# striate_find(<target> DEBIAN <package> <arguments of find_package...>) and
# striate_find_pkg_config(<NAME> DEBIAN <package> <module>) find what others wrote and note how, so that
# the installed striateConfig.cmake finds the same for the layers that need it.
# Macros: find_package() sets variables that the callers read.

macro(striate_find target debian_word debian)
  find_package(${ARGN} REQUIRED)
  string(REPLACE ";" " " striate_how "${ARGN}")
  set_property(GLOBAL PROPERTY STRIATE_FIND_${target} "package ${striate_how}")
  set_property(GLOBAL PROPERTY STRIATE_DEBIAN_${target} ${debian})
endmacro()

macro(striate_find_pkg_config name debian_word debian module)
  pkg_check_modules(${name} ${ARGN} IMPORTED_TARGET ${module})
  set_property(GLOBAL PROPERTY STRIATE_FIND_PkgConfig::${name} "pkg_config ${name} ${module}")
  set_property(GLOBAL PROPERTY STRIATE_DEBIAN_PkgConfig::${name} ${debian})
endmacro()

# How the library is found in another project: "package <arguments>", "opencv <component>" or
# "pkg_config <NAME> <module>"; nothing for a file, which is linked by its path.
function(striate_how_to_find library out_how out_debian)
  set(${out_how} "" PARENT_SCOPE)
  set(${out_debian} "" PARENT_SCOPE)
  if(IS_ABSOLUTE "${library}")
    return()
  endif()
  if(library MATCHES "^opencv_(.+)$")
    set(${out_how} "opencv ${CMAKE_MATCH_1}" PARENT_SCOPE)
    set(${out_debian} libopencv-dev PARENT_SCOPE)
    return()
  endif()
  get_property(how GLOBAL PROPERTY STRIATE_FIND_${library})
  get_property(debian GLOBAL PROPERTY STRIATE_DEBIAN_${library})
  if(NOT how)
    message(FATAL_ERROR "a layer uses ${library}, which no striate_find() of CMakeLists.txt provides")
  endif()
  set(${out_how} "${how}" PARENT_SCOPE)
  set(${out_debian} "${debian}" PARENT_SCOPE)
endfunction()
