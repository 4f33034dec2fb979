#include "striate/platform/ros/node.hpp"

#include <ros/console.h>
#include <ros/init.h>
#include <ros/master.h>
#include <ros/network.h>

#include <cstdlib>
#include <stdexcept>

#include "striate/base/user_error.hpp"

namespace striate::ros {
namespace {

/// Where ROS 1 looks when ROS_MASTER_URI is not set
constexpr const char* kUsualMaster = "http://localhost:11311";

/// roscpp aborts the program for a bad address: so it is looked at first.
std::string master_address() {
  setenv("ROS_MASTER_URI", kUsualMaster, 0);
  const std::string address = std::getenv("ROS_MASTER_URI");
  std::string host;
  std::uint32_t port = 0;
  if (address.rfind("http://", 0) != 0 || !::ros::network::splitURI(address, host, port)) {
    throw UserError("ROS_MASTER_URI=" + address +
                    ": is no address of a master\n  hint: " + kUsualMaster);
  }
  return address;
}

}  // namespace

void join_ros(const std::string& name) {
  if (::ros::isInitialized() && ::ros::isStarted()) return;
  const std::string address = master_address();
  using namespace ::ros::init_options;
  if (!::ros::isInitialized()) {
    ::ros::init(::ros::M_string{}, name, AnonymousName | NoSigintHandler | NoRosout);
    ::ros::console::set_logger_level(ROSCONSOLE_DEFAULT_NAME, ::ros::console::levels::Fatal);
  }
  if (!::ros::master::check()) {
    throw std::runtime_error("no ROS master answers at " + address +
                             "\n  hint: start 'roscore', or say where it is by ROS_MASTER_URI");
  }
  ::ros::start();
}

}  // namespace striate::ros
