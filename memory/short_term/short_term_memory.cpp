#include "striate/memory/short_term/short_term_memory.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace striate::memory {
namespace {

// By hand: much sooner than anything fades (moving_fades, 3.5 s), and not in every cycle, for it
// visits all cells; walls are sought in the cycles between.
constexpr Duration kFadeEvery = std::chrono::milliseconds(500);
constexpr Duration kFitEvery = std::chrono::milliseconds(400);
constexpr double kSeenShareGain = 0.1;    // by hand: averaged over ten images, one second
constexpr std::size_t kMostRegions = 64;  // by hand: of an image; memory holds seven
constexpr std::size_t kUsualFigures =
    32;  // by hand: of plugins; with more, the first image allocates

}  // namespace

ShortTermMemory::ShortTermMemory(const ShortTermMemorySettings& settings,
                                 const RobotDescription& robot)
    : settings_(settings),
      robot_(robot),
      occupancy_(settings.occupancy, robot.camera_height_m),
      salient_(settings.salient),
      landmarks_(settings.landmarks),
      place_(settings.localisation) {
  regions_now_.reserve(kMostRegions);
  figures_.reserve(kUsualFigures);
}

const ShortTermMemory& ShortTermMemory::update(const Senses& senses,
                                               const perception::Percept& percept,
                                               std::span<const LandmarkSighting> sightings) {
  const TimePoint before = now_;
  feel(senses);
  if (percept.valid && (!image_seen_ || percept.stamp > image_stamp_)) see(percept);
  felt_.forget_where([this](Point2 place) { return is_under_robot(place); });
  felt_.keep_in(grid_, now_);
  clear_own_place();
  fade();
  salient_.attend(head_.pan_rad, now_, now_ - before);
  if (now_ - fitted_ >= kFitEvery) {
    fitted_ = now_;
    fit_walls();
  }
  for (const LandmarkSighting& sighting : sightings) recognise(sighting);
  return *this;
}

void ShortTermMemory::fit_walls() {
  const WallFit things = wall_fitter_.fit(grid_, pose_, corridor_.axis_rad());
  corridor_.see(things, CorridorMemory::Source::things);
  if (things.left && things.right) return;
  corridor_.see(wall_fitter_.fit_edges(grid_, pose_, corridor_.axis_rad(), corridor_.width_m()),
                CorridorMemory::Source::edges);
}

void ShortTermMemory::feel(const Senses& senses) {
  now_ = senses.now;
  const Pose2 before = pose_;
  pose_ = senses.odometry.pose;
  history_.add(senses.odometry.stamp, pose_);
  place_.keep_leaving(grid_, {pose_.x_m, pose_.y_m});
  place_.move(pose_);
  grid_.centre_on({pose_.x_m, pose_.y_m});
  if (corridor_.started()) {
    corridor_.move(before, pose_);
    salient_.move(before, pose_);
    landmarks_.move(before, pose_);
    travelled_m_ += std::hypot(pose_.x_m - before.x_m, pose_.y_m - before.y_m);
  } else {
    corridor_.start(pose_);
  }
  trajectory_.walk(pose_);
  place_.recall_into(landmarks_);
  forward_m_s_ = senses.odometry.forward_m_s;
  turn_rad_s_ = senses.odometry.turn_rad_s;
  head_ = senses.head;
  battery_v_ = senses.battery_v;
  bumper_ = senses.bumper;
  stalled_ = senses.motors_stalled;
}

void ShortTermMemory::see(const perception::Percept& percept) {
  image_seen_ = true;
  image_stamp_ = percept.stamp;
  light_level_ = percept.light_level;
  noise_level_ = percept.noise_level;
  figures_.assign(percept.figures.begin(), percept.figures.end());
  if (!history_.reaches(percept.stamp)) return;  // too old to say where it belongs
  const Pose2 at = history_.at(percept.stamp);
  occupancy_.write(percept, at, grid_);
  blank_view_.see(percept, at, grid_);
  corridor_.see(percept.corridor, at, pose_);

  int knowing = 0;
  for (const perception::Column& column : percept.columns) {
    if (std::isfinite(column.obstacle_m) || column.free_to_m > column.free_from_m) ++knowing;
  }
  const auto all = static_cast<double>(std::max<std::size_t>(1, percept.columns.size()));
  seen_share_ += kSeenShareGain * (knowing / all - seen_share_);

  regions_now_.clear();
  for (const perception::SalientRegion& seen : percept.saliency.regions) {
    if (regions_now_.size() == kMostRegions) break;
    perception::SalientRegion region = seen;
    if (std::isfinite(seen.distance_m)) {
      const Point2 place = inverse_transform(
          pose_, transform(at, Point2{seen.distance_m * std::cos(seen.bearing_rad),
                                      seen.distance_m * std::sin(seen.bearing_rad)}));
      region.bearing_rad = std::atan2(place.y_m, place.x_m);
      region.distance_m = std::hypot(place.x_m, place.y_m);
    } else {
      region.bearing_rad = wrap_angle(seen.bearing_rad + at.heading_rad - pose_.heading_rad);
    }
    regions_now_.push_back(region);
  }
  const double focal_px = percept.disparity.focal_px;
  salient_.see(regions_now_, focal_px > 0.0 ? 1.0 / focal_px : 0.0, percept.stamp);
}

bool ShortTermMemory::is_under_robot(Point2 place) const {
  const Point2 here = inverse_transform(pose_, place);
  return here.x_m < robot_.front_m && here.x_m > -robot_.rear_m &&
         std::abs(here.y_m) < robot_.half_width_m;
}

// Where the robot stands, nothing else does.
void ShortTermMemory::clear_own_place() {
  const double reach_m = std::hypot(robot_.rear_m, robot_.half_width_m) + LocalGrid::kCell_m;
  const int reach = static_cast<int>(reach_m / LocalGrid::kCell_m);
  const GridCell middle = LocalGrid::cell_of({pose_.x_m, pose_.y_m});
  for (int y = middle.y - reach; y <= middle.y + reach; ++y) {
    for (int x = middle.x - reach; x <= middle.x + reach; ++x) {
      if (is_under_robot(LocalGrid::centre_of({x, y}))) grid_.clear({x, y}, now_);
    }
  }
}

void ShortTermMemory::fade() {
  if (now_ - faded_ >= kFadeEvery) {
    const double step_s = to_seconds(now_ - faded_);
    faded_ = now_;
    grid_.fade({static_cast<float>(std::exp(-step_s / settings_.free_fades_s)),
                static_cast<float>(std::exp(-step_s / settings_.occupied_fades_s)),
                static_cast<float>(std::exp(-step_s / settings_.moving_fades_s))});
  }
  if (travelled_m_ - blurred_at_m_ >= settings_.blur_every_m) {
    blurred_at_m_ = travelled_m_;
    grid_.blur_older_than(now_ - from_seconds(settings_.blur_after_s),
                          static_cast<float>(settings_.blur_share));
  }
}

double ShortTermMemory::figure(std::string_view name) const {
  for (const perception::Figure& figure : figures_) {
    if (figure.name.view() == name) return figure.value;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

double ShortTermMemory::image_age_s() const {
  return image_seen_ ? to_seconds(now_ - image_stamp_) : std::numeric_limits<double>::infinity();
}

void ShortTermMemory::recognise(const LandmarkSighting& sighting) {
  if (!history_.reaches(sighting.stamp)) return;  // too old to say where it belongs
  const Pose2 at = history_.at(sighting.stamp);
  landmarks_.see(sighting, at, pose_);
  const LandmarkInMind* seen = landmarks_.find(sighting.name);
  if (seen == nullptr || seen->in_a_row < settings_.landmarks.confirming_looks) return;
  place_.see(sighting, at);
  place_.recall_into(landmarks_);
}

void ShortTermMemory::close_map(bool failed) {
  if (failed) place_.fail();
  place_.keep_all(grid_);
}

void ShortTermMemory::remember(const MotorCommand& sent, std::string_view doing,
                               std::span<const Point2> held_by) {
  for (const Point2& place : held_by) felt_.feel(transform(pose_, place), now_);
  SentCommand& entry = sent_[next_sent_];
  entry.stamp = now_;
  entry.command = sent;
  entry.doing = doing;
  next_sent_ = (next_sent_ + 1) % kCommands;
}

const ShortTermMemory::SentCommand& ShortTermMemory::sent(std::size_t steps_back) const {
  return sent_[(next_sent_ + kCommands - 1 - std::min(steps_back, kCommands - 1)) % kCommands];
}

}  // namespace striate::memory
