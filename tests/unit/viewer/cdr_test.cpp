#include <fastcdr/Cdr.h>
#include <gtest/gtest.h>

#include <sstream>

#include "striate/viewer/cdr/ros_schema.hpp"
#include "striate/viewer/messages/navigation_messages.hpp"
#include "striate/viewer/messages/report_messages.hpp"
#include "striate/viewer/messages/sensor_messages.hpp"

/// Our CDR against eProsima's Fast CDR, which ROS 2 itself writes with: each message's fields are
/// listed here once more, by hand, from its public definition.
namespace striate::viewer::msgs {
namespace {

using eprosima::fastcdr::Cdr;

template <class T>
void put(Cdr& c, const std::vector<T>& list);

void put(Cdr& c, const Time& m) {
  c << m.sec << m.nanosec;
}
void put(Cdr& c, const msgs::Duration& m) {
  c << m.sec << m.nanosec;
}
void put(Cdr& c, const Header& m) {
  put(c, m.stamp);
  c << m.frame_id;
}
void put(Cdr& c, const ColorRGBA& m) {
  c << m.r << m.g << m.b << m.a;
}
void put(Cdr& c, const Vector3& m) {
  c << m.x << m.y << m.z;
}
void put(Cdr& c, const Point& m) {
  c << m.x << m.y << m.z;
}
void put(Cdr& c, const Quaternion& m) {
  c << m.x << m.y << m.z << m.w;
}
void put(Cdr& c, const msgs::Pose& m) {
  put(c, m.position);
  put(c, m.orientation);
}
void put(Cdr& c, const PoseStamped& m) {
  put(c, m.header);
  put(c, m.pose);
}
void put(Cdr& c, const PoseWithCovariance& m) {
  put(c, m.pose);
  c << m.covariance;
}
void put(Cdr& c, const PoseWithCovarianceStamped& m) {
  put(c, m.header);
  put(c, m.pose);
}
void put(Cdr& c, const Twist& m) {
  put(c, m.linear);
  put(c, m.angular);
}
void put(Cdr& c, const TwistWithCovariance& m) {
  put(c, m.twist);
  c << m.covariance;
}
void put(Cdr& c, const TwistStamped& m) {
  put(c, m.header);
  put(c, m.twist);
}
void put(Cdr& c, const Transform& m) {
  put(c, m.translation);
  put(c, m.rotation);
}
void put(Cdr& c, const TransformStamped& m) {
  put(c, m.header);
  c << m.child_frame_id;
  put(c, m.transform);
}
void put(Cdr& c, const TFMessage& m) {
  put(c, m.transforms);
}
void put(Cdr& c, const msgs::Odometry& m) {
  put(c, m.header);
  c << m.child_frame_id;
  put(c, m.pose);
  put(c, m.twist);
}
void put(Cdr& c, const Path& m) {
  put(c, m.header);
  put(c, m.poses);
}
void put(Cdr& c, const MapMetaData& m) {
  put(c, m.map_load_time);
  c << m.resolution << m.width << m.height;
  put(c, m.origin);
}
void put(Cdr& c, const OccupancyGrid& m) {
  put(c, m.header);
  put(c, m.info);
  c << m.data;
}
void put(Cdr& c, const CompressedImage& m) {
  put(c, m.header);
  c << m.format << m.data;
}
void put(Cdr& c, const Image& m) {
  put(c, m.header);
  c << m.height << m.width << m.encoding << m.is_bigendian << m.step << m.data;
}
void put(Cdr& c, const RegionOfInterest& m) {
  c << m.x_offset << m.y_offset << m.height << m.width << m.do_rectify;
}
void put(Cdr& c, const CameraInfo& m) {
  put(c, m.header);
  c << m.height << m.width << m.distortion_model << m.d << m.k << m.r << m.p << m.binning_x
    << m.binning_y;
  put(c, m.roi);
}
void put(Cdr& c, const LaserScan& m) {
  put(c, m.header);
  c << m.angle_min << m.angle_max << m.angle_increment << m.time_increment << m.scan_time
    << m.range_min << m.range_max << m.ranges << m.intensities;
}
void put(Cdr& c, const PointField& m) {
  c << m.name << m.offset << m.datatype << m.count;
}
void put(Cdr& c, const PointCloud2& m) {
  put(c, m.header);
  c << m.height << m.width;
  put(c, m.fields);
  c << m.is_bigendian << m.point_step << m.row_step << m.data << m.is_dense;
}
void put(Cdr& c, const BatteryState& m) {
  put(c, m.header);
  c << m.voltage << m.temperature << m.current << m.charge << m.capacity << m.design_capacity
    << m.percentage << m.power_supply_status << m.power_supply_health << m.power_supply_technology
    << m.present << m.cell_voltage << m.cell_temperature << m.location << m.serial_number;
}
void put(Cdr& c, const DisparityImage& m) {
  put(c, m.header);
  put(c, m.image);
  c << m.f << m.t;
  put(c, m.valid_window);
  c << m.min_disparity << m.max_disparity << m.delta_d;
}
void put(Cdr& c, const UVCoordinate& m) {
  c << m.u << m.v;
}
void put(Cdr& c, const MeshFile& m) {
  c << m.filename << m.data;
}
void put(Cdr& c, const Marker& m) {
  put(c, m.header);
  c << m.ns << m.id << m.type << m.action;
  put(c, m.pose);
  put(c, m.scale);
  put(c, m.color);
  put(c, m.lifetime);
  c << m.frame_locked;
  put(c, m.points);
  put(c, m.colors);
  c << m.texture_resource;
  put(c, m.texture);
  put(c, m.uv_coordinates);
  c << m.text << m.mesh_resource;
  put(c, m.mesh_file);
  c << m.mesh_use_embedded_materials;
}
void put(Cdr& c, const MarkerArray& m) {
  put(c, m.markers);
}
void put(Cdr& c, const KeyValue& m) {
  c << m.key << m.value;
}
void put(Cdr& c, const DiagnosticStatus& m) {
  c << static_cast<std::uint8_t>(m.level) << m.name << m.message << m.hardware_id;
  put(c, m.values);
}
void put(Cdr& c, const DiagnosticArray& m) {
  put(c, m.header);
  put(c, m.status);
}
void put(Cdr& c, const Log& m) {
  put(c, m.stamp);
  c << m.level << m.name << m.msg << m.file << m.function << m.line;
}
template <class T>
void put(Cdr& c, const std::vector<T>& list) {
  c << static_cast<std::uint32_t>(list.size());
  for (const T& one : list) put(c, one);
}

/// Fills a message with numbers that are all different; texts of 0 to 6 letters and lists of 0
/// to 3.
class Filler {
 public:
  explicit Filler(unsigned seed) : state_(seed * 2654435761U + 1) {}
  template <class T>
  void operator()(const char* /*name*/, const T& value) {
    fill(const_cast<T&>(value));
  }
  template <class T>
  void fill(T& value) {
    if constexpr (std::is_same_v<T, bool>) {
      value = next() % 2 == 1;
    } else if constexpr (std::is_same_v<T, std::byte>) {
      value = static_cast<std::byte>(next());
    } else if constexpr (std::is_arithmetic_v<T>) {
      value = static_cast<T>(next()) / static_cast<T>(std::is_floating_point_v<T> ? 7 : 1);
    } else {
      value.each_field(*this);
    }
  }
  void fill(std::string& text) { text = std::string(next() % 7, 'x'); }
  template <class T>
  void fill(std::vector<T>& list) {
    list.resize(next() % 4);
    for (T& one : list) fill(one);
  }
  template <class T, std::size_t kSize>
  void fill(std::array<T, kSize>& list) {
    for (T& one : list) fill(one);
  }

 private:
  std::uint32_t next() { return (state_ = state_ * 1664525U + 1013904223U) >> 12; }
  std::uint32_t state_;
};

template <class Message>
Bytes by_fast_cdr(const Message& message) {
  std::vector<char> room(1U << 16U);  // of zeros: Fast CDR leaves padding as it was
  eprosima::fastcdr::FastBuffer buffer(room.data(), room.size());
  Cdr cdr(buffer, Cdr::LITTLE_ENDIANNESS, Cdr::DDS_CDR);
  cdr.serialize_encapsulation();
  put(cdr, message);
  return {room.begin(), room.begin() + static_cast<std::ptrdiff_t>(cdr.getSerializedDataLength())};
}

template <class Message>
void compare_with_fast_cdr() {
  Bytes ours;
  encode_cdr(Message(), ours);
  EXPECT_EQ(ours, by_fast_cdr(Message())) << Message::kType << ", empty";
  for (unsigned seed = 0; seed < 200; ++seed) {
    Message message;
    Filler(seed).fill(message);
    encode_cdr(message, ours);
    ASSERT_EQ(ours, by_fast_cdr(message)) << Message::kType << " " << seed;
  }
}

TEST(Cdr, OfEveryMessageIsWhatFastCdrWrites) {
  compare_with_fast_cdr<TFMessage>();
  compare_with_fast_cdr<msgs::Odometry>();
  compare_with_fast_cdr<PoseWithCovarianceStamped>();
  compare_with_fast_cdr<Path>();
  compare_with_fast_cdr<CompressedImage>();
  compare_with_fast_cdr<CameraInfo>();
  compare_with_fast_cdr<DisparityImage>();
  compare_with_fast_cdr<Image>();
  compare_with_fast_cdr<LaserScan>();
  compare_with_fast_cdr<PointCloud2>();
  compare_with_fast_cdr<OccupancyGrid>();
  compare_with_fast_cdr<MarkerArray>();
  compare_with_fast_cdr<TwistStamped>();
  compare_with_fast_cdr<BatteryState>();
  compare_with_fast_cdr<DiagnosticArray>();
  compare_with_fast_cdr<Log>();
}

/// As `ros2 interface show` and rosbag2 put them together.
TEST(RosSchema, NamesEachTypeOnceBehindALineOfEqualSigns) {
  const std::string line(80, '=');
  EXPECT_EQ(RosSchemaWriter::of<TFMessage>(),
            "geometry_msgs/TransformStamped[] transforms\n" + line +
                "\nMSG: geometry_msgs/TransformStamped\nstd_msgs/Header header\nstring "
                "child_frame_id\ngeometry_msgs/Transform transform\n" +
                line + "\nMSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n" +
                line + "\nMSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n" + line +
                "\nMSG: geometry_msgs/Transform\ngeometry_msgs/Vector3 translation\n"
                "geometry_msgs/Quaternion rotation\n" +
                line + "\nMSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z\n" + line +
                "\nMSG: geometry_msgs/Quaternion\nfloat64 x\nfloat64 y\nfloat64 z\nfloat64 w\n");
  EXPECT_EQ(schema_name("tf2_msgs/TFMessage"), "tf2_msgs/msg/TFMessage");
}

}  // namespace
}  // namespace striate::viewer::msgs
