# `cpack` makes these Debian packages: `striate`, a few MB that a robot needs; `striate-dev`, the library
# with the development packages it is built on (OpenCV's alone pull in some hundred MB), which a robot
# does not need; and, where it is built, `python3-striate`, the Python module.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME striate)
set(CPACK_PACKAGE_VENDOR "Striate")
set(CPACK_PACKAGE_CONTACT "Striate maintainers <maintainers@striate.example>")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package below has its own
set(CPACK_COMPONENTS_ALL striate striate_dev)
if(STRIATE_PYTHON_FOUND)
  list(APPEND CPACK_COMPONENTS_ALL striate_python)
endif()
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_STRIATE_PACKAGE_NAME striate)
set(CPACK_DEBIAN_STRIATE_PACKAGE_SECTION science)
set(CPACK_DEBIAN_STRIATE_PACKAGE_SHLIBDEPS ON)
# The program loads these when it needs them (app/late_opencv.cpp), so dpkg-shlibdeps does not see them.
math(EXPR opencv_abi "${OpenCV_VERSION_MAJOR} * 100 + ${OpenCV_VERSION_MINOR}")
set(CPACK_DEBIAN_STRIATE_PACKAGE_DEPENDS "libopencv-imgcodecs${opencv_abi}, libopencv-videoio${opencv_abi}, libopencv-contrib${opencv_abi}")
set(CPACK_DEBIAN_STRIATE_DESCRIPTION "drives robots by a biological model of visual cortex
Striate lets you test an idea about seeing, remembering or acting in a
whole robot that drives by vision: change one part, run the same mission
again bit for bit, and measure what came of it.
.
It has a model of visual area V1 for stereo, obstacles, saliency and
recognition, short-term and long-term memory, task scripts in YAML, drivers
for the Pioneer 3-DX, and a simulator that needs no graphics card.")

list(APPEND STRIATE_DEV_PACKAGES pkg-config)
if(STRIATE_ROS_FOUND)  # its headers include those of all messages
  file(STRINGS cmake/packages_ros.txt ros_packages REGEX "^lib.*-dev$")
  list(APPEND STRIATE_DEV_PACKAGES ${ros_packages})
endif()
list(REMOVE_DUPLICATES STRIATE_DEV_PACKAGES)
string(REPLACE ";" ", " dev_depends "${STRIATE_DEV_PACKAGES}")
set(CPACK_DEBIAN_STRIATE_DEV_PACKAGE_NAME striate-dev)
set(CPACK_DEBIAN_STRIATE_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_STRIATE_DEV_PACKAGE_DEPENDS "${dev_depends}")
set(CPACK_DEBIAN_STRIATE_DEV_PACKAGE_RECOMMENDS striate)
set(CPACK_DEBIAN_STRIATE_DEV_DESCRIPTION "cognitive robot framework (headers and static libraries)
Headers and static libraries of Striate, a cognitive robot framework in
C++20 with a biological model of visual cortex.
.
In CMake, find_package(striate COMPONENTS perception memory agent) gives the
targets striate::perception and so on, one for each layer.")

if(STRIATE_PYTHON_FOUND)
  math(EXPR next_python "${Python3_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_STRIATE_PYTHON_PACKAGE_NAME python3-striate)
  set(CPACK_DEBIAN_STRIATE_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_STRIATE_PYTHON_PACKAGE_SHLIBDEPS ON)
  string(CONCAT CPACK_DEBIAN_STRIATE_PYTHON_PACKAGE_DEPENDS
         "striate (= ${PROJECT_VERSION}-1), python3-numpy, "
         "python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${next_python})")
  set(CPACK_DEBIAN_STRIATE_PYTHON_DESCRIPTION "cognitive robot framework (Python module)
The module striate: images to disparity, saliency, keypoints and obstacles as
numpy arrays, memories and recordings, the simulator, and missions with
behaviours, conditions and pilots that are written in Python.")
endif()

# What Debian wants beside them. Only in the packages, and so not part of a plain `cmake --install`.
string(TIMESTAMP STRIATE_DATE "%a, %d %b %Y %H:%M:%S +0000" UTC)
set(debian_dir ${PROJECT_BINARY_DIR}/debian)
file(CONFIGURE OUTPUT ${debian_dir}/changelog.Debian @ONLY CONTENT
"striate (@PROJECT_VERSION@-1) unstable; urgency=medium

  * Release of version @PROJECT_VERSION@; what changed stands in changelog.gz.

 -- @CPACK_PACKAGE_CONTACT@  @STRIATE_DATE@
")
file(CONFIGURE OUTPUT ${debian_dir}/copyright @ONLY CONTENT
"Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: Striate
Upstream-Contact: @CPACK_PACKAGE_CONTACT@

Files: *
Copyright: 2026 Striate's authors
License: Apache-2.0
 On Debian systems, the full text of the Apache License, Version 2.0, is in
 /usr/share/common-licenses/Apache-2.0.
")
configure_file(CHANGELOG.md ${debian_dir}/changelog COPYONLY)
foreach(file changelog changelog.Debian)
  execute_process(COMMAND ${STRIATE_GZIP} -n -9 -k -f ${debian_dir}/${file} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
foreach(package ${CPACK_COMPONENTS_ALL})
  string(REPLACE _ - folder share/doc/${package})
  string(REPLACE striate-python python3-striate folder ${folder})
  install(FILES ${debian_dir}/copyright ${debian_dir}/changelog.gz ${debian_dir}/changelog.Debian.gz
          DESTINATION ${folder} COMPONENT ${package} EXCLUDE_FROM_ALL)
endforeach()

include(CPack)
