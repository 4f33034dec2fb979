# The module `import striate`, where the packages of cmake/packages_python.txt are. It is built for Debian's own
# interpreter, whichever python3 comes first in PATH: that is the one whose numpy is Debian's.
option(STRIATE_PYTHON_MODULE "Build the Python module where its packages are there" ${PROJECT_IS_TOP_LEVEL})
set(STRIATE_PYTHON_FOUND FALSE)
if(STRIATE_SANITIZE)
  return()  # the interpreter is not built with the sanitizers' libraries
endif()
if(STRIATE_PYTHON_MODULE)
  if(NOT Python3_EXECUTABLE AND EXISTS /usr/bin/python3)
    set(Python3_EXECUTABLE /usr/bin/python3)
  endif()
  find_package(Python3 3.11 QUIET COMPONENTS Interpreter Development.Module)
  find_path(STRIATE_PYBIND11_DIR pybind11/pybind11.h)
  if(TARGET Python3::Module AND STRIATE_PYBIND11_DIR)
    set(STRIATE_PYTHON_FOUND TRUE)
  endif()
endif()
if(NOT STRIATE_PYTHON_FOUND)
  return()
endif()

file(GLOB python_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/python/*.cpp)
Python3_add_library(striate_python MODULE WITH_SOABI ${python_sources})
striate_compile(striate_python)
striate_compile_together(striate_python ${python_sources})
set(STRIATE_PYTHON_DIR ${PROJECT_BINARY_DIR}/python)
set_target_properties(striate_python PROPERTIES OUTPUT_NAME _striate CXX_VISIBILITY_PRESET hidden
                      LIBRARY_OUTPUT_DIRECTORY ${STRIATE_PYTHON_DIR}/striate)
target_include_directories(striate_python SYSTEM PRIVATE ${STRIATE_PYBIND11_DIR})
target_link_libraries(striate_python PRIVATE striate::app opencv_imgcodecs opencv_imgproc opencv_core fmt::fmt)
target_link_options(striate_python PRIVATE -Wl,--as-needed)
target_compile_options(striate_python PRIVATE $<$<CONFIG:Release>:-O1>)  # glue
striate_precompile(striate_python <pybind11/numpy.h> <pybind11/stl.h> <pybind11/stl/filesystem.h> <opencv2/core.hpp>)

# In the build tree, PYTHONPATH=build/release/python: links, so that what is written there is what runs.
file(GLOB python_files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/python/striate/*.py ${PROJECT_SOURCE_DIR}/python/striate/*.pyi
     ${PROJECT_SOURCE_DIR}/python/striate/py.typed)
file(MAKE_DIRECTORY ${STRIATE_PYTHON_DIR}/striate)
foreach(file IN LISTS python_files)
  get_filename_component(name ${file} NAME)
  file(CREATE_LINK ${file} ${STRIATE_PYTHON_DIR}/striate/${name} SYMBOLIC)
endforeach()

# Where Debian's interpreter looks below /usr and below /usr/local.
if(STRIATE_INSTALL)
  set(python_place lib/python${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}/dist-packages/striate)
  install(TARGETS striate_python LIBRARY DESTINATION ${python_place} COMPONENT striate_python)
  install(FILES ${python_files} DESTINATION ${python_place} COMPONENT striate_python)
endif()
