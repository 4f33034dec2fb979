set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
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

# No fused multiply-add behind our back: the same seed must give the same run.
add_compile_options(-ffp-contract=off)

add_library(striate_warnings INTERFACE)
target_compile_options(striate_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Werror)

if(STRIATE_SANITIZE)
  add_compile_options(-fsanitize=${STRIATE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${STRIATE_SANITIZE})
  if(STRIATE_SANITIZE MATCHES thread)
    # Boost.Asio's fences, which the sanitizer does not follow; none of ours share data through them.
    target_compile_options(striate_warnings INTERFACE -Wno-tsan)
  endif()
endif()
