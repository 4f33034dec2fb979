# Builds for arm64 on another machine: Debian's cross compiler, its arm64 packages unpacked below
# STRIATE_ARM64_ROOT, and qemu's user emulation to run what was built. cmake/test_arm64.sh uses it.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)

# Small projects that try out the compiler read this file too and need to know the folder.
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES STRIATE_ARM64_ROOT)
if(NOT IS_DIRECTORY "${STRIATE_ARM64_ROOT}")
  message(FATAL_ERROR "STRIATE_ARM64_ROOT, the folder of Debian's arm64 packages, is \"${STRIATE_ARM64_ROOT}\" and no folder")
endif()
set(CMAKE_SYSROOT ${STRIATE_ARM64_ROOT})
set(CMAKE_FIND_ROOT_PATH ${STRIATE_ARM64_ROOT})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(ENV{PKG_CONFIG_DIR} "")
set(ENV{PKG_CONFIG_LIBDIR} ${STRIATE_ARM64_ROOT}/usr/lib/aarch64-linux-gnu/pkgconfig:${STRIATE_ARM64_ROOT}/usr/share/pkgconfig)
set(ENV{PKG_CONFIG_SYSROOT_DIR} ${STRIATE_ARM64_ROOT})
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64-static -L ${STRIATE_ARM64_ROOT})
