#include "striate/viewer/channels/channels.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "striate/viewer/channels/body_messages.hpp"
#include "striate/viewer/channels/mind_messages.hpp"
#include "striate/viewer/channels/ros_stamps.hpp"
#include "striate/viewer/channels/seen_json.hpp"

namespace striate::viewer {
namespace {

using testing::ElementsAre;

TimePoint at_ms(std::int64_t ms) {
  return TimePoint(std::chrono::milliseconds(ms));
}

CycleFacts some_facts() {
  CycleFacts facts;
  facts.number = 3;
  facts.senses.now = at_ms(1300);
  facts.senses.odometry = {at_ms(1290), {1.0, 2.0, kPi / 2.0}, 0.3, 0.1};
  facts.senses.battery_v = 12.5;
  facts.doing = "avoid";
  return facts;
}

TEST(ChannelList, HasAPlaceForEachTopicAndNoNameTwice) {
  std::set<std::string> names;
  for (std::size_t k = 0; k < channel_list().size(); ++k) {
    const ChannelInfo& channel = channel_list()[k];
    EXPECT_EQ(static_cast<std::size_t>(channel.topic), k);
    EXPECT_TRUE(names.insert(channel.name).second) << channel.name;
    if (channel.encoding == "json") {
      EXPECT_TRUE(Json::accept(channel.schema)) << channel.name;
    }
  }
  EXPECT_EQ(channel_list().size(), kTopics);
}

TEST(RosStamps, BeforeTheBodyBeganHaveNanosecondsThatAreNotNegative) {
  EXPECT_EQ(ros_time(at_ms(1250)).sec, 1);
  EXPECT_EQ(ros_time(at_ms(1250)).nanosec, 250'000'000U);
  EXPECT_EQ(ros_time(at_ms(-250)).sec, -1);
  EXPECT_EQ(ros_time(at_ms(-250)).nanosec, 750'000'000U);
}

TEST(BodyMessages, TheHeadTurnsLeftByPanAndUpByTilt) {
  CycleFacts facts = some_facts();
  facts.senses.head = {0.6, 0.4};
  RobotDescription robot;
  const msgs::TFMessage message = tf_of(facts, robot);
  ASSERT_EQ(message.transforms.size(), 3U);
  const msgs::Quaternion& q = message.transforms[1].transform.rotation;
  // Its x axis, in the base's frame: the first column of the rotation matrix.
  EXPECT_NEAR(1.0 - 2.0 * (q.y * q.y + q.z * q.z), std::cos(0.6) * std::cos(0.4), 1e-12);
  EXPECT_NEAR(2.0 * (q.x * q.y + q.z * q.w), std::sin(0.6) * std::cos(0.4), 1e-12);
  EXPECT_NEAR(2.0 * (q.x * q.z - q.y * q.w), std::sin(0.4), 1e-12);
}

TEST(BodyMessages, AScanKeepsTheNearestEchoOfEachDegree) {
  const double inf = std::numeric_limits<double>::infinity();
  const msgs::LaserScan scan = scan_of({at_ms(5), {{0.0, 2.0}, {0.001, 1.5}, {0.5 * kPi, inf}}});
  EXPECT_EQ(scan.ranges.size(), 360U);
  EXPECT_FLOAT_EQ(scan.ranges[180], 1.5F);
  EXPECT_TRUE(std::isinf(scan.ranges[270]));
  EXPECT_TRUE(std::isnan(scan.ranges[0]));
  EXPECT_NEAR(scan.angle_min + 180 * scan.angle_increment, 0.0, 1e-5);
}

TEST(BodyMessages, ASonarHasAPointForEachEchoThatCameBack) {
  const double inf = std::numeric_limits<double>::infinity();
  const msgs::PointCloud2 cloud = sonar_of({at_ms(5), {{0.5 * kPi, 2.0}, {0.0, inf}}});
  EXPECT_EQ(cloud.width, 1U);
  EXPECT_EQ(cloud.data.size(), 12U);
  ByteReader reader(cloud.data);
  EXPECT_NEAR(reader.take<float>(), 0.0F, 1e-6F);
  EXPECT_FLOAT_EQ(reader.take<float>(), 2.0F);
}

TEST(MindMessages, ThePosesCovarianceStandsWhereRosLooksForIt) {
  CycleFacts facts = some_facts();
  facts.on_map = OnMap{{1, 2, 0}, {11, 12, 13, 21, 22, 23, 31, 32, 33}, {}};
  const msgs::PoseWithCovarianceStamped pose = pose_of(facts);
  EXPECT_EQ(pose.header.frame_id, "map");
  const auto& c = pose.pose.covariance;
  EXPECT_EQ(c[0], 11);   // x x
  EXPECT_EQ(c[1], 12);   // x y
  EXPECT_EQ(c[5], 13);   // x yaw
  EXPECT_EQ(c[11], 23);  // y yaw
  EXPECT_EQ(c[30], 31);  // yaw x
  EXPECT_EQ(c[35], 33);  // yaw yaw
  EXPECT_EQ(c[14], 0);
}

TEST(MindMessages, LandmarksAreABallAndANameAndRemoveThoseOfBefore) {
  CycleFacts facts = some_facts();
  facts.slow.landmarks = {{"book \xC3\xBC", {3.0, -1.0}, 0.4, true}};
  const msgs::MarkerArray message = landmarks_of(facts);
  ASSERT_EQ(message.markers.size(), 3U);
  EXPECT_EQ(message.markers[0].action, 3);
  EXPECT_EQ(message.markers[1].pose.position.x, 3.0);
  EXPECT_EQ(message.markers[1].scale.x, 0.8);
  EXPECT_EQ(message.markers[2].text, "book \xC3\xBC");
}

TEST(MindMessages, AnObstacleStandsWhereItsBearingAndDistanceSay) {
  CycleFacts facts = some_facts();
  facts.obstacles = {{.bearing_rad = kPi / 2, .distance_m = 2.0, .width_m = 0.5, .height_m = 1.0}};
  facts.moving = {{.bearing_rad = 0.0, .distance_m = 3.0, .width_m = 0.4}};
  const msgs::MarkerArray message = obstacles_of(facts);
  ASSERT_EQ(message.markers.size(), 3U);
  EXPECT_NEAR(message.markers[1].pose.position.y, 2.0, 1e-12);
  EXPECT_NEAR(message.markers[1].pose.position.z, 0.5, 1e-12);
  EXPECT_EQ(message.markers[2].ns, "moving");
}

TEST(LogTeller, TellsEachThingOnceUntilItChanges) {
  CycleFacts facts = some_facts();
  LogTeller teller;
  const auto told = [&] {
    std::vector<std::string> list;
    for (const msgs::Log& line : teller.news(facts)) list.push_back(line.name + "|" + line.msg);
    return list;
  };
  facts.wish.why = behaviours::ShortText("goes round");
  EXPECT_THAT(told(), ElementsAre("task|avoid: goes round"));
  EXPECT_THAT(told(), ElementsAre());
  facts.refused = "no picture";
  EXPECT_THAT(told(), ElementsAre("camera|no picture"));
  facts.state = tasks::MissionState::failed;
  facts.reason = "stuck";
  facts.doing = "";
  EXPECT_THAT(told(), ElementsAre("task|no action runs", "mission|failed: stuck"));
  EXPECT_THAT(told(), ElementsAre());
}

TEST(Channels, SendNothingOfWhatIsNotThere) {
  tasks::Task task;
  task.mission = "m";
  Channels channels(RobotDescription{}, task);
  std::map<std::string, int> sent;
  const auto sink = [&](Topic topic, std::uint64_t time_ns, ByteView message) {
    EXPECT_EQ(time_ns, 1'300'000'000U);
    EXPECT_FALSE(message.empty());
    ++sent[channel_list()[static_cast<std::size_t>(topic)].name];
  };
  channels.publish(some_facts(), sink);
  channels.publish(some_facts(), sink);
  EXPECT_EQ(sent, (std::map<std::string, int>{{"/tf", 2},
                                              {"/odom", 2},
                                              {"/cmd_vel", 2},
                                              {"/log", 1},
                                              {"/striate/task", 1},
                                              {"/striate/wish", 2},
                                              {"/striate/cycle", 2}}));
}

/// In full by a validator of others, in tests/browser; here those that no short mission sends, too.
TEST(JsonSchemas, NameTheKeysThatAreSent) {
  CycleFacts facts = some_facts();
  facts.recognised = {"book"};
  facts.lessons = {{"book", true}, {"cup", false}};
  const Json tree = task_tree({});
  const std::map<Topic, Json> sent{{Topic::task, task_json(facts, "m", tree)},
                                   {Topic::wish, wish_json(facts)},
                                   {Topic::memory_events, memory_events_json(facts)},
                                   {Topic::cycle, cycle_json(facts)}};
  for (const auto& [topic, json] : sent) {
    const ChannelInfo& channel = channel_list()[static_cast<std::size_t>(topic)];
    const Json schema = Json::parse(channel.schema);
    std::set<std::string> keys;
    for (const auto& [key, value] : json.items()) keys.insert(key);
    const std::set<std::string> required = schema["required"];
    EXPECT_EQ(keys, required) << channel.name;
    std::set<std::string> described;
    for (const auto& [key, value] : schema["properties"].items()) described.insert(key);
    EXPECT_EQ(keys, described) << channel.name;
  }
  EXPECT_EQ(sent.at(Topic::memory_events)["lessons"][1]["kind"], "missed");
}

TEST(Channels, AWordThatIsNoUtf8IsReplacedInJson) {
  tasks::Task task;
  task.mission = "\xFF";
  Channels channels(RobotDescription{}, task);
  channels.publish(some_facts(), [&](Topic topic, std::uint64_t, ByteView message) {
    if (topic != Topic::task) return;
    EXPECT_TRUE(Json::accept(message.begin(), message.end()));
  });
}

TEST(SeenMessages, AreInPixelsOfTheSmallerImageAndSayNullForWhatIsNotKnown) {
  CycleFacts facts = some_facts();
  facts.seen.working_px = {320, 240};
  facts.seen.image_px = {640, 480};
  facts.seen.columns.resize(320);
  facts.seen.columns[4].obstacle_m = 1.234567;
  facts.seen.keypoints.resize(1);
  facts.seen.keypoints[0].u_px = 100.0;
  facts.seen.keypoints[0].v_px = 50.0;
  facts.seen.keypoints[0].wavelength_px = 8.0;
  facts.seen.landmarks.push_back({"<b>book</b>", {}});
  facts.seen.landmarks[0].found.u_px = 320.0;
  const Json seen = seen_json(facts, RobotDescription());
  EXPECT_EQ(seen["columns"].size(), 80U);
  EXPECT_EQ(seen["columns"][0]["obstacle_m"], nullptr);
  EXPECT_EQ(seen["columns"][1]["obstacle_m"], 1.23);
  EXPECT_EQ(seen["keypoints"], Json({50.0, 25.0, 4.0}));
  EXPECT_EQ(seen["landmarks"][0]["name"], "<b>book</b>");
  EXPECT_EQ(seen["landmarks"][0]["u_px"], 160.0);
  EXPECT_EQ(seen["landmarks"][0]["distance_m"], nullptr);
}

TEST(SeenMessages, BeforeTheFirstImageAreEmptyAndNoError) {
  const Json seen = seen_json(CycleFacts(), RobotDescription());
  EXPECT_TRUE(seen["columns"].empty());
  EXPECT_EQ(seen["width_px"], 0);
}

TEST(TaskNodes, AreToldWhereOneChangesAndNotElse) {
  Channels channels(RobotDescription{}, tasks::Task{});
  channels.want(TopicSet().set(static_cast<std::size_t>(Topic::task_nodes)));
  std::vector<std::string> told;
  const Channels::Sink sink = [&](Topic, std::uint64_t, ByteView message) {
    told.emplace_back(message.begin(), message.end());
  };
  CycleFacts facts = some_facts();
  for (const char* nodes : {"-rw", "-rw", "-fr", "-fr"}) {
    facts.nodes = nodes;
    facts.node_reason = facts.nodes == "-fr" ? "too slow" : "";
    channels.publish(facts, sink);
  }
  EXPECT_THAT(told, ElementsAre(R"({"states":"-rw","reason":""})",
                                R"({"states":"-fr","reason":"too slow"})"));
}

}  // namespace
}  // namespace striate::viewer
