# `cmake --install`. Two components, which are also the two Debian packages: `striate`, the program with
# what it reads, and `striate_dev`, headers, static libraries and what find_package(striate) needs.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(STRIATE_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/striate)
set(STRIATE_DOC_DIR share/doc/striate)

# Headers, below include/striate/ as in the build tree. Not `-inl`, parts of one source.
function(striate_install_headers folder)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/${folder}/*.hpp)
  list(FILTER headers EXCLUDE REGEX "-inl\\.hpp$")
  if(NOT STRIATE_ROS_FOUND)
    list(FILTER headers EXCLUDE REGEX "^(platform|agent|app)/ros/")
    if(folder STREQUAL "platform/ros")  # which every build reads
      list(APPEND headers platform/ros/ros_settings.hpp)
    endif()
  endif()
  foreach(header IN LISTS headers)
    get_filename_component(below ${header} DIRECTORY)
    install(FILES ${header} DESTINATION include/striate/${below} COMPONENT striate_dev)
  endforeach()
endfunction()

# Each layer is a component of find_package(striate) with an export of its own.
get_property(layer_table GLOBAL PROPERTY STRIATE_LAYER_TABLE)
set(STRIATE_COMPONENTS "")
set(STRIATE_ABSENT "")
set(STRIATE_COMPONENT_TABLE "")
set(STRIATE_DEV_PACKAGES libopencv-dev)
foreach(line IN LISTS layer_table)
  string(REPLACE " " ";" line "${line} ")
  list(GET line 0 layer)
  list(GET line 1 folder)
  list(GET line 2 may_include)
  string(REPLACE "," " " may_include "${may_include}")
  striate_install_headers(${folder})
  install(TARGETS striate_${layer} EXPORT striate_${layer} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT striate_dev)
  install(EXPORT striate_${layer} FILE ${layer}.cmake NAMESPACE striate:: DESTINATION ${STRIATE_PACKAGE_DIR} COMPONENT striate_dev)

  if(layer STREQUAL "ros" AND NOT STRIATE_ROS_FOUND)
    list(APPEND STRIATE_ABSENT ${layer})
  endif()
  set(finds "")
  get_property(libraries GLOBAL PROPERTY STRIATE_USES_${layer})
  foreach(library IN LISTS libraries)
    striate_how_to_find("${library}" how debian)
    if(how)
      string(APPEND finds " \"${how}\"")
    endif()
    list(APPEND STRIATE_DEV_PACKAGES ${debian})
  endforeach()
  list(APPEND STRIATE_COMPONENTS ${layer})
  string(APPEND STRIATE_COMPONENT_TABLE "set(striate_${layer}_INCLUDES ${may_include})\nset(striate_${layer}_FINDS${finds})\n")
endforeach()
list(REMOVE_DUPLICATES STRIATE_DEV_PACKAGES)
string(REPLACE ";" " " STRIATE_COMPONENTS "${STRIATE_COMPONENTS}")

configure_file(cmake/striateConfig.cmake.in ${PROJECT_BINARY_DIR}/striateConfig.cmake @ONLY)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/striateConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/striateConfig.cmake ${PROJECT_BINARY_DIR}/striateConfigVersion.cmake
        DESTINATION ${STRIATE_PACKAGE_DIR} COMPONENT striate_dev)

# The program, and its configuration where the program looks for it: ../share/striate/config.
install(TARGETS striate RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT striate)
install(DIRECTORY config/robots config/tasks config/worlds DESTINATION share/striate/config COMPONENT striate)
install(FILES README.md CHANGELOG.md DESTINATION ${STRIATE_DOC_DIR} COMPONENT striate_documents)
install(FILES LICENSE DESTINATION ${STRIATE_DOC_DIR} COMPONENT striate_documents)

# Manual page and completions are what the built program says.
find_program(STRIATE_GZIP gzip REQUIRED)
set(pages_dir ${PROJECT_BINARY_DIR}/share)
add_custom_command(
  OUTPUT ${pages_dir}/striate.1.gz ${pages_dir}/striate ${pages_dir}/_striate
  COMMAND ${CMAKE_COMMAND} -E make_directory ${pages_dir}
  COMMAND striate help --man > ${pages_dir}/striate.1
  COMMAND ${STRIATE_GZIP} -n -9 -f ${pages_dir}/striate.1
  COMMAND striate help --completion bash > ${pages_dir}/striate
  COMMAND striate help --completion zsh > ${pages_dir}/_striate
  COMMENT "Manual page and completions" VERBATIM)
add_custom_target(striate_pages ALL DEPENDS ${pages_dir}/striate.1.gz)
install(FILES ${pages_dir}/striate.1.gz DESTINATION share/man/man1 COMPONENT striate)
install(FILES ${pages_dir}/striate DESTINATION share/bash-completion/completions COMPONENT striate)
install(FILES ${pages_dir}/_striate DESTINATION share/zsh/vendor-completions COMPONENT striate)
