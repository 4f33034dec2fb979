# ROS 1 from Debian's packages (cmake/packages_ros.txt), an optional part: STRIATE_ROS_FOUND says
# whether it is built. Found by pkg-config and by files: rosbag_storage's own CMake package runs
# whatever `python3` comes first, and its pkg-config file names a package that is not there.
option(STRIATE_ROS "Build the ROS 1 component where its packages are found" ON)
set(STRIATE_ROS_FOUND OFF)
# roscpp is not built for the thread sanitizer, which would blame it for all it does.
if(STRIATE_ROS AND NOT STRIATE_SANITIZE MATCHES thread)
  striate_find_pkg_config(ROSCPP DEBIAN libroscpp-dev roscpp QUIET)
  find_library(ROSBAG_STORAGE_LIBRARY rosbag_storage)
  find_library(CONSOLE_BRIDGE_LIBRARY console_bridge)  # rosbag's headers log with it
  set(STRIATE_ROS_FOUND ${ROSCPP_FOUND})
  foreach(header rosbag/bag.h sensor_msgs/Image.h nav_msgs/Odometry.h geometry_msgs/Twist.h
                 stereo_msgs/DisparityImage.h diagnostic_msgs/DiagnosticArray.h tf2_msgs/TFMessage.h)
    string(MAKE_C_IDENTIFIER "ROS_HEADER_${header}" found)
    find_path(${found} ${header})
    mark_as_advanced(${found})
    if(NOT ${found} OR NOT ROSBAG_STORAGE_LIBRARY OR NOT CONSOLE_BRIDGE_LIBRARY)
      set(STRIATE_ROS_FOUND OFF)
    endif()
  endforeach()
  # Headers that rosbag's headers include, each below a folder of its own.
  set(STRIATE_ROS_INCLUDES "")
  foreach(package pluginlib class_loader rcpputils rcutils ament_index_cpp)
    list(APPEND STRIATE_ROS_INCLUDES /usr/include/${package})
  endforeach()
  if(NOT STRIATE_ROS_FOUND)
    message(STATUS "ROS 1 is not built: its packages (cmake/packages_ros.txt) are not all there")
  endif()
endif()
