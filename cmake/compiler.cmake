# What Striate's own targets are compiled with. It is put on the targets, one by one, so that a project
# that adds Striate with add_subdirectory() keeps its own flags, and Striate's results do not depend on them.
option(STRIATE_WERROR "Treat warnings in Striate as errors" ${PROJECT_IS_TOP_LEVEL})

if(PROJECT_IS_TOP_LEVEL)
  set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
  if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release)
  endif()
  # -O2: measured as fast as -O3 here and quicker to build; SIMD is written by hand where it matters.
  set(CMAKE_CXX_FLAGS_RELEASE "-O2")
  find_program(CCACHE_PROGRAM ccache)
  if(CCACHE_PROGRAM)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
  endif()
endif()

# A fifth of the time that GNU ld takes for a hundred programs and libraries; Debian's compiler brings it.
include(CheckLinkerFlag)
check_linker_flag(CXX -fuse-ld=gold STRIATE_HAS_GOLD)

# No fused multiply-add behind our back: the same seed must give the same run.
set(STRIATE_COMPILE_OPTIONS -ffp-contract=off)
if(NOT PROJECT_IS_TOP_LEVEL)
  # Whatever the other project asks for: these come after its flags and undo what would change results.
  list(APPEND STRIATE_COMPILE_OPTIONS -fno-fast-math $<$<NOT:$<CONFIG:Debug>>:-O2>)
endif()
set(STRIATE_LINK_OPTIONS "")
if(STRIATE_HAS_GOLD AND NOT STRIATE_SANITIZE)
  list(APPEND STRIATE_LINK_OPTIONS -fuse-ld=gold)
endif()

add_library(striate_warnings INTERFACE)
target_compile_options(striate_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor)
if(STRIATE_WERROR)
  target_compile_options(striate_warnings INTERFACE -Werror)
endif()

if(STRIATE_SANITIZE)
  list(APPEND STRIATE_COMPILE_OPTIONS -fsanitize=${STRIATE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  list(APPEND STRIATE_LINK_OPTIONS -fsanitize=${STRIATE_SANITIZE})
  if(STRIATE_SANITIZE MATCHES thread)
    # Boost.Asio's fences, which the sanitizer does not follow; none of ours share data through them.
    target_compile_options(striate_warnings INTERFACE -Wno-tsan)
  endif()
endif()

# striate_compile(<target>): the above for one target; none of it reaches those who link it.
function(striate_compile target)
  set_target_properties(${target} PROPERTIES CXX_STANDARD 20 CXX_STANDARD_REQUIRED ON CXX_EXTENSIONS OFF)
  target_compile_options(${target} PRIVATE ${STRIATE_COMPILE_OPTIONS})
  target_link_options(${target} PRIVATE ${STRIATE_LINK_OPTIONS})
  target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:striate_warnings>)
endfunction()

# striate_compile_directory(): the same for all targets that follow in this folder and below, without the
# warnings, which tests ask for themselves.
macro(striate_compile_directory)
  set(CMAKE_CXX_STANDARD 20)
  set(CMAKE_CXX_STANDARD_REQUIRED ON)
  set(CMAKE_CXX_EXTENSIONS OFF)
  add_compile_options(${STRIATE_COMPILE_OPTIONS})
  add_link_options(${STRIATE_LINK_OPTIONS})
endmacro()
