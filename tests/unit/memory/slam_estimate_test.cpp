#include "striate/memory/localisation/slam_estimate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace striate::memory {
namespace {

constexpr std::int64_t kBook = 7;
constexpr std::int64_t kCup = 9;
constexpr std::int64_t kBox = 11;

/// What is seen of a point of the odometry frame.
LandmarkSighting look(std::int64_t landmark, const Pose2& from, Point2 place) {
  const Point2 here = inverse_transform(from, place);
  LandmarkSighting sighting;
  sighting.landmark = landmark;
  sighting.bearing_rad = std::atan2(here.y_m, here.x_m);
  sighting.distance_m = std::hypot(here.x_m, here.y_m);
  sighting.disparity_metre_px = 24.4;
  return sighting;
}

/// Drives straight along x, a step of 10 cm a cycle, and looks at what it is given each time.
struct Drive {
  explicit Drive(SlamEstimate& place) : estimate(place) {}
  void to(double x_m) {
    while (pose.x_m < x_m - 1e-9) {
      pose.x_m += 0.1;
      estimate.move(pose);
    }
  }
  SightingVerdict see(std::int64_t landmark, Point2 place) {
    return estimate.see(look(landmark, pose, place), pose);
  }
  SlamEstimate& estimate;
  Pose2 pose;
};

MapPosition sure_to(double sigma_m, Point2 at) {
  return {at.x_m, at.y_m, sigma_m * sigma_m, 0.0, sigma_m * sigma_m};
}

TEST(SlamEstimate, GivesASeenLandmarkAPlaceAndMakesItSurer) {
  SlamEstimate place({});
  place.know(kBook, std::nullopt);
  place.start({});
  Drive drive(place);
  EXPECT_EQ(drive.see(kBook, {3.0, 1.0}), SightingVerdict::placed);
  const MapPosition first = place.place(kBook).value();
  EXPECT_NEAR(first.x_m, 3.0, 1e-9);
  EXPECT_NEAR(first.y_m, 1.0, 1e-9);
  // The range is the less sure the farther away: along x more than across.
  EXPECT_GT(first.var_x_m2, 4.0 * first.var_y_m2);
  drive.to(1.5);
  EXPECT_EQ(drive.see(kBook, {3.0, 1.0}), SightingVerdict::taken);
  EXPECT_LT(place.place(kBook)->var_x_m2, 0.5 * first.var_x_m2);
}

TEST(SlamEstimate, ACameraWithTwiceTheBaselineIsTwiceAsSureOfTheRange) {
  const auto range_sigma_m = [](double disparity_metre_px) {
    LocalisationSettings settings;
    settings.middle_error_m = 0.0;
    SlamEstimate estimate(settings);
    estimate.know(kBook, std::nullopt);
    estimate.start({});
    LandmarkSighting sighting = look(kBook, {}, {4.0, 0.0});
    sighting.disparity_metre_px = disparity_metre_px;
    EXPECT_EQ(estimate.see(sighting, {}), SightingVerdict::placed);
    return std::sqrt(estimate.place(kBook)->var_x_m2);
  };
  EXPECT_NEAR(range_sigma_m(12.2) / range_sigma_m(24.4), 2.0, 1e-6);
}

TEST(SlamEstimate, ARobotThatStandsAddsNothing) {
  SlamEstimate place({});
  place.know(kBook, std::nullopt);
  place.start({});
  Drive drive(place);
  drive.see(kBook, {2.0, 0.5});
  const MapPosition before = place.place(kBook).value();
  for (int k = 0; k < 36000; ++k) {
    place.move(drive.pose);
    EXPECT_EQ(drive.see(kBook, {2.0, 0.5}), SightingVerdict::too_alike);
  }
  EXPECT_EQ(place.place(kBook)->var_x_m2, before.var_x_m2);
  EXPECT_EQ(place.pose_covariance()[0], 0.0);
}

TEST(SlamEstimate, AWrongAssociationIsRejectedAndChangesNothing) {
  SlamEstimate place({});
  place.know(kBook, std::nullopt);
  place.start({});
  Drive drive(place);
  drive.see(kBook, {3.0, 1.0});
  drive.to(0.5);
  drive.see(kBook, {3.0, 1.0});
  drive.to(1.0);
  const Pose2 pose = place.pose();
  const MapPosition before = place.place(kBook).value();
  EXPECT_EQ(drive.see(kBook, {3.0, -1.0}), SightingVerdict::rejected);
  EXPECT_EQ(place.pose().x_m, pose.x_m);
  EXPECT_EQ(place.pose().heading_rad, pose.heading_rad);
  EXPECT_EQ(place.place(kBook)->y_m, before.y_m);
  drive.to(1.5);
  EXPECT_EQ(drive.see(kBook, {3.0, 1.0}), SightingVerdict::taken);
}

TEST(SlamEstimate, ALandmarkThatWasMovedGetsItsNewPlace) {
  SlamEstimate place({});
  place.know(kBook, std::nullopt);
  place.start({});
  Drive drive(place);
  for (int k = 0; k < 4; ++k) {
    drive.to(0.3 * k);
    drive.see(kBook, {3.0, 1.0});
  }
  int rejected = 0;
  for (int k = 4; k < 14; ++k) {
    drive.to(0.3 * k);
    if (drive.see(kBook, {6.0, -1.0}) == SightingVerdict::rejected) ++rejected;
  }
  EXPECT_EQ(rejected, 3);
  EXPECT_NEAR(place.place(kBook)->x_m, 6.0, 0.05);
  EXPECT_NEAR(place.place(kBook)->y_m, -1.0, 0.05);
}

TEST(SlamEstimate, AKnownLandmarkCorrectsTheDriftOfTheOdometry) {
  SlamEstimate place({});
  place.know(kBook, sure_to(0.05, {3.0, 1.0}));
  place.know(kCup, sure_to(0.05, {33.0, 1.0}));
  place.start({});
  Drive drive(place);
  EXPECT_FALSE(place.located());
  drive.to(0.5);
  drive.see(kBook, {3.0, 1.0});
  EXPECT_TRUE(place.located());
  drive.to(30.0);
  // The odometry has it 30 cm behind where the cup is known to be.
  const double before_m2 = place.pose_covariance()[0];
  EXPECT_EQ(drive.see(kCup, {32.7, 1.0}), SightingVerdict::taken);
  EXPECT_LT(place.pose_covariance()[0], before_m2);
  EXPECT_NEAR(place.pose().x_m, 30.3, 0.12);
  EXPECT_NEAR(place.from_odometry().x_m, 0.3, 0.12);
}

TEST(SlamEstimate, FindsOutWhereItStartedByTwoKnownLandmarks) {
  LocalisationSettings settings;
  settings.starts_at_home = false;
  SlamEstimate place(settings);
  const Pose2 start{20.0, -5.0, 2.0};  // of this run, on the map
  const Point2 book{2.5, 0.8};
  const Point2 cup{4.5, -0.8};
  const Point2 box{7.0, 0.8};
  place.know(kBook, sure_to(0.05, transform(start, book)));
  place.know(kCup, sure_to(0.05, transform(start, cup)));
  place.know(kBox, sure_to(0.05, transform(start, box)));
  place.start({});
  Drive drive(place);
  for (int k = 0; k < 4; ++k) {
    drive.to(0.4 * k);
    EXPECT_FALSE(place.located());
    drive.see(kBook, book);
  }
  EXPECT_NEAR(place.place(kBook)->x_m, book.x_m, 0.05) << "not on the map yet";
  for (int k = 0; k < 3; ++k) {
    drive.to(1.6 + 0.4 * k);
    drive.see(kCup, cup);
  }
  ASSERT_TRUE(place.located());
  drive.to(4.0);
  EXPECT_EQ(drive.see(kBox, box), SightingVerdict::taken);
  const Pose2 truth = transform(start, drive.pose);
  EXPECT_NEAR(place.pose().x_m, truth.x_m, 0.1);
  EXPECT_NEAR(place.pose().y_m, truth.y_m, 0.1);
  EXPECT_NEAR(wrap_angle(place.pose().heading_rad - truth.heading_rad), 0.0, 0.05);
  EXPECT_NEAR(place.start().x_m, start.x_m, 0.2);
  EXPECT_NEAR(place.start().y_m, start.y_m, 0.2);
}

TEST(SlamEstimate, IsNotFooledWhenItDidNotStartAtHome) {
  SlamEstimate place({});
  place.know(kBook, sure_to(0.05, {3.0, 1.0}));
  place.start({});
  Drive drive(place);
  drive.see(kBook, {3.0, 4.0});
  EXPECT_FALSE(place.located());
  int told = 0;
  place.tell_news([&](std::int64_t, const MapPosition&) { ++told; });
  EXPECT_EQ(told, 0) << "a place of the run's own frame is none of the map";
}

TEST(SlamEstimate, ASightingWithoutARangeStillTellsTheHeading) {
  SlamEstimate place({});
  place.know(kBook, sure_to(0.02, {3.0, 0.0}));
  place.know(kCup, sure_to(0.02, {24.0, 0.0}));
  place.start({});
  Drive drive(place);
  drive.to(1.0);
  drive.see(kBook, {3.0, 0.0});
  drive.to(20.0);
  const double before = place.pose_covariance()[4];
  LandmarkSighting sighting = look(kCup, drive.pose, {24.0, 0.0});
  sighting.distance_m = std::numeric_limits<double>::infinity();
  EXPECT_EQ(place.see(sighting, drive.pose), SightingVerdict::taken);
  EXPECT_LT(place.pose_covariance()[4], before);
  sighting.landmark = kBox;
  EXPECT_EQ(place.see(sighting, drive.pose), SightingVerdict::no_room) << "not known at all";
}

TEST(SlamEstimate, AnImageThatIsOldBelongsToWhereItWasTaken) {
  SlamEstimate place({});
  place.know(kBook, std::nullopt);
  place.start({});
  Drive drive(place);
  const Pose2 then = drive.pose;
  drive.to(0.5);
  place.see(look(kBook, then, {3.0, 1.0}), then);
  EXPECT_NEAR(place.place(kBook)->x_m, 3.0, 1e-9);
}

TEST(SlamEstimate, OfMoreLandmarksThanItHoldsTheOldestGoBackToBeingKnown) {
  SlamEstimate place({});
  const int many = EkfSlam::kLandmarks + 20;
  for (int k = 1; k <= many; ++k) place.know(k, std::nullopt);
  place.start({});
  Drive drive(place);
  for (int k = 1; k <= many; ++k) {
    for (int looks = 0; looks < 2; ++looks) {
      drive.to(drive.pose.x_m + 0.3);
      drive.see(k, {1.0 + k, 1.0});
    }
  }
  EXPECT_NEAR(place.place(1)->x_m, 2.0, 0.05) << "known, if no longer estimated";
  EXPECT_NEAR(place.place(many)->x_m, 1.0 + many, 0.05);
}

}  // namespace
}  // namespace striate::memory
