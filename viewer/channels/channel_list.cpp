#include "striate/viewer/channels/channel_list.hpp"

#include "striate/viewer/cdr/ros_schema.hpp"
#include "striate/viewer/channels/json_schemas.hpp"
#include "striate/viewer/messages/navigation_messages.hpp"
#include "striate/viewer/messages/report_messages.hpp"
#include "striate/viewer/messages/sensor_messages.hpp"

namespace striate::viewer {
namespace {

template <RosMessage Message>
ChannelInfo ros_channel(Topic topic, const char* name) {
  return {
      topic, name, "cdr", schema_name(Message::kType), "ros2msg", RosSchemaWriter::of<Message>()};
}

ChannelInfo json_channel(Topic topic, const char* name, const char* schema, const char* text) {
  return {topic, name, "json", schema, "jsonschema", text};
}

std::vector<ChannelInfo> make_channel_list() {
  using namespace msgs;
  return {
      ros_channel<TFMessage>(Topic::tf, "/tf"),
      ros_channel<msgs::Odometry>(Topic::odom, "/odom"),
      ros_channel<PoseWithCovarianceStamped>(Topic::pose, "/pose"),
      ros_channel<Path>(Topic::trajectory, "/trajectory"),
      ros_channel<CompressedImage>(Topic::left_image, "/camera/left/image/compressed"),
      ros_channel<CameraInfo>(Topic::left_info, "/camera/left/camera_info"),
      ros_channel<CompressedImage>(Topic::right_image, "/camera/right/image/compressed"),
      ros_channel<CameraInfo>(Topic::right_info, "/camera/right/camera_info"),
      ros_channel<DisparityImage>(Topic::disparity, "/stereo/disparity"),
      ros_channel<Image>(Topic::saliency, "/saliency"),
      ros_channel<LaserScan>(Topic::scan, "/scan"),
      ros_channel<PointCloud2>(Topic::sonar, "/sonar"),
      ros_channel<OccupancyGrid>(Topic::map_local, "/map/local"),
      ros_channel<OccupancyGrid>(Topic::map_global, "/map/global"),
      ros_channel<MarkerArray>(Topic::obstacles, "/obstacles"),
      ros_channel<MarkerArray>(Topic::landmarks, "/landmarks"),
      ros_channel<MarkerArray>(Topic::route, "/route"),
      ros_channel<TwistStamped>(Topic::cmd_vel, "/cmd_vel"),
      ros_channel<BatteryState>(Topic::battery, "/battery"),
      ros_channel<DiagnosticArray>(Topic::diagnostics, "/diagnostics"),
      ros_channel<Log>(Topic::log, "/log"),
      json_channel(Topic::task, "/striate/task", "striate.Task", kTaskSchema),
      json_channel(Topic::wish, "/striate/wish", "striate.Wish", kWishSchema),
      json_channel(Topic::short_term, "/striate/memory/short_term", "striate.ShortTermMemory",
                   kShortTermSchema),
      json_channel(Topic::memory_events, "/striate/memory/events", "striate.MemoryEvents",
                   kMemoryEventsSchema),
      json_channel(Topic::cycle, "/striate/cycle", "striate.Cycle", kCycleSchema),
      json_channel(Topic::seen, "/striate/seen", "striate.Seen", kSeenSchema),
      json_channel(Topic::task_nodes, "/striate/task/nodes", "striate.TaskNodes", kTaskNodesSchema),
  };
}

}  // namespace

const std::vector<ChannelInfo>& channel_list() {
  static const std::vector<ChannelInfo> kList = make_channel_list();
  return kList;
}

}  // namespace striate::viewer
