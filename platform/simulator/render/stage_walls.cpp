#include "striate/platform/simulator/render/stage.hpp"

namespace striate::simulator::render {
namespace {

constexpr float kSkirting_m = 0.09F;  ///< height of a skirting board
constexpr float kSill_m = 0.95F;      ///< height of a window's sill; below it a wall is seen
constexpr float kLintel_m = 2.2F;     ///< height of a window's upper edge; a door's is 2.05 m
constexpr float kWindow_m = 1.3F;     ///< width of a window in a row
constexpr float kPier_m = 0.75F;      ///< of wall between two windows of a row
constexpr float kReveal_m = 0.18F;    ///< depth of a window in its wall (ours)
/// Walls are laid in pieces of at most this, for baked light and culling
constexpr float kWallPiece_m = 5.0F;

struct Span {
  float from = 0.0F;
  float to = 0.0F;
};

/// One wall segment in its own frame: x along it from `from`, y into the corridor, z up.
class Wall {
 public:
  Wall(const WallSegment& segment, const FloorPlan& plan) : segment_(segment), plan_(plan) {
    const double dx = segment.to.x_m - segment.from.x_m;
    const double dy = segment.to.y_m - segment.from.y_m;
    length_m_ = static_cast<float>(std::hypot(dx, dy));
    stand_ = {{segment.from.x_m, segment.from.y_m, std::atan2(dy, dx)}, 0.0F};
    const Pose2 middle = plan.along(
        {segment.from.x_m + dx / 2.0, segment.from.y_m + dy / 2.0, stand_.pose.heading_rad});
    along_the_corridor_ = std::abs(std::cos(middle.heading_rad)) > 0.7;
  }

  [[nodiscard]] const Stand& stand() const { return stand_; }
  [[nodiscard]] float length_m() const { return length_m_; }
  [[nodiscard]] const WallSegment& segment() const { return segment_; }

  /// Where the corridor coordinate is on this wall, if it is on it.
  [[nodiscard]] std::optional<float> place_of(Side side, double along_m) const {
    if (!along_the_corridor_ || side != segment_.side) return std::nullopt;
    const Pose2 on_line = plan_.at(along_m, 0.0);
    const auto x =
        static_cast<float>(inverse_transform(stand_.pose, Point2{on_line.x_m, on_line.y_m}).x_m);
    if (x < 0.0F || x > length_m_) return std::nullopt;
    const Vec3 p = stand_.point(x, 0.0F, 0.0F);
    if (std::abs(plan_.along({p.x, p.y, 0.0}).x_m - along_m) > 0.3) return std::nullopt;
    return x;
  }
  [[nodiscard]] Vec3 point(float x, float y, float z) const { return stand_.point(x, y, z); }

  /// The wall's face, in pieces short enough for quick ray casting.
  void long_face(PatchList& patches, Span x, Span z, int material, float y = 0.0F) const {
    const int pieces = std::max(1, static_cast<int>(std::ceil((x.to - x.from) / kWallPiece_m)));
    const float step = (x.to - x.from) / static_cast<float>(pieces);
    for (int i = 0; i < pieces; ++i) {
      const float from = x.from + step * static_cast<float>(i);
      face(patches, {from, i + 1 == pieces ? x.to : from + step}, z, material, y);
    }
  }
  /// A piece of the wall's face at depth y.
  Patch& face(PatchList& patches, Span x, Span z, int material, float y = 0.0F) const {
    const Vec3 corner = point(x.to, y, z.from);
    const float s = static_cast<float>(segment_.side == Side::right ? segment_.along_m + x.from
                                                                    : segment_.along_m - x.to);
    return patches.rectangle(corner, point(x.from, y, z.from) - corner, {0.0F, 0.0F, z.to - z.from},
                             material, s);
  }

 private:
  const WallSegment& segment_;
  const FloorPlan& plan_;
  Stand stand_;
  float length_m_ = 0.0F;
  bool along_the_corridor_ = false;
};

bool meets_a_door(Side side, double at_m, double half_m, const World& world) {
  return std::any_of(world.doors.begin(), world.doors.end(), [&](const Door& door) {
    return door.side == side && std::abs(door.at_m - at_m) < half_m + door.width_m / 2.0 + 0.2;
  });
}

std::vector<Span> windows_on(const Wall& wall, const World& world) {
  std::vector<Span> windows;
  for (const WindowRow& row : world.windows) {
    const double span = row.to_m - row.from_m;
    const int count = std::max(1, static_cast<int>((span + kPier_m) / (kWindow_m + kPier_m)));
    for (int i = 0; i < count; ++i) {
      const double at_m = row.from_m + span * (i + 0.5) / count;
      const auto x = wall.place_of(row.side, at_m);
      const float half = std::min(kWindow_m, static_cast<float>(span)) / 2.0F;
      if (x && !meets_a_door(row.side, at_m, half, world) && *x > half + 0.1F &&
          *x < wall.length_m() - half - 0.1F) {
        windows.push_back({*x - half, *x + half});
      }
    }
  }
  std::sort(windows.begin(), windows.end(), [](Span a, Span b) { return a.from < b.from; });
  for (std::size_t i = 1; i < windows.size();) {  // rows that overlap: the first window stands
    if (windows[i].from < windows[i - 1].to + 0.1F) {
      windows.erase(windows.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      ++i;
    }
  }
  return windows;
}

/// The opening's four sides and the frame with its cross.
void add_window(PatchList& patches, const Wall& wall, Span x) {
  const int white = patches.materials().find("paint_white", "window");
  const int reveal = patches.materials().find("plaster", "window");
  const auto side = [&](Vec3 corner, Vec3 along, Vec3 up, int material) {
    patches.next_group();
    patches.rectangle(corner, along, up, material);
  };
  patches.set_spacing(0.15F);
  const auto p = [&](float a, float y, float z) { return wall.point(a, y, z); };
  const Vec3 up{0.0F, 0.0F, kLintel_m - kSill_m};
  const Vec3 wide = p(x.to, 0.0F, 0.0F) - p(x.from, 0.0F, 0.0F);
  const Vec3 out = p(0.0F, -kReveal_m, 0.0F) - p(0.0F, 0.0F, 0.0F);
  side(p(x.from, 0.0F, kSill_m), out, up, reveal);
  side(p(x.to, -kReveal_m, kSill_m), out * -1.0F, up, reveal);
  side(p(x.from, -kReveal_m, kSill_m), wide, out * -1.0F, white);
  side(p(x.from, 0.0F, kLintel_m), wide, out, reveal);
  const auto bar = [&](Span a, Span z) {
    patches.block(wall.stand(),
                  {{a.from, -kReveal_m + 0.01F, z.from}, {a.to, -kReveal_m + 0.06F, z.to}}, white,
                  white, true);
  };
  const float middle = (x.from + x.to) / 2.0F;
  const float across = kSill_m + 0.68F * (kLintel_m - kSill_m);
  bar({x.from, x.from + 0.06F}, {kSill_m, kLintel_m});
  bar({x.to - 0.06F, x.to}, {kSill_m, kLintel_m});
  bar({middle - 0.04F, middle + 0.04F}, {kSill_m, kLintel_m});
  bar({x.from, x.to}, {kSill_m, kSill_m + 0.06F});
  bar({x.from, x.to}, {kLintel_m - 0.06F, kLintel_m});
  bar({x.from, x.to}, {across - 0.035F, across + 0.035F});
}

/// The window as a source of light, just outside its frame.
Lamp opening(const Wall& wall, Span x) {
  const float middle = (x.from + x.to) / 2.0F;
  const float high = (kSill_m + kLintel_m) / 2.0F;
  const Vec3 centre = wall.point(middle, -kReveal_m, high);
  const Vec3 inward = wall.point(middle, 1.0F - kReveal_m, high) - centre;
  return {centre,
          wall.point(x.to, -kReveal_m, high) - centre,
          {0.0F, 0.0F, kLintel_m - high},
          1.0F,
          inward};
}

void add_face(PatchList& patches, const Wall& wall, const std::vector<Span>& windows) {
  const WallSegment& segment = wall.segment();
  const int material = patches.materials().find(segment.material, "wall");
  const float low = static_cast<float>(segment.bottom_m) + kSkirting_m;
  const auto top = static_cast<float>(segment.top_m);
  patches.next_group();
  patches.set_spacing(0.15F);
  float done = 0.0F;
  for (const Span& window : windows) {
    wall.long_face(patches, {done, window.from}, {low, top}, material);
    wall.face(patches, window, {low, kSill_m}, material);
    wall.face(patches, window, {kLintel_m, top}, material);
    done = window.to;
  }
  wall.long_face(patches, {done, wall.length_m()}, {low, top}, material);
  // Behind the skirting a piece of its own: the dark there must not reach up the wall.
  patches.set_spacing(0.5F);
  wall.long_face(patches, {0.0F, wall.length_m()}, {static_cast<float>(segment.bottom_m), low},
                 material);
}

void add_skirting(PatchList& patches, const Wall& wall, const std::vector<Span>& doors) {
  const int material = patches.materials().find("skirting", "skirting");
  patches.set_spacing(0.3F);
  const auto piece = [&](Span x) {
    if (x.to - x.from < 0.02F) return;
    constexpr float kThick_m = 0.012F;  // of a skirting board
    patches.next_group();
    wall.long_face(patches, x, {0.0F, kSkirting_m}, material, kThick_m);
    patches.next_group();
    const Vec3 corner = wall.point(x.from, 0.0F, kSkirting_m);
    patches.rectangle(corner, wall.point(x.to, 0.0F, kSkirting_m) - corner,
                      wall.point(x.from, kThick_m, kSkirting_m) - corner, material);
  };
  float done = 0.0F;
  for (const Span& door : doors) {
    piece({done, std::max(done, door.from)});
    done = std::max(done, door.to);
  }
  piece({done, wall.length_m()});
}

void add_posters(PatchList& patches, const Wall& wall, const World& world) {
  patches.set_spacing(0.25F);
  for (const Poster& poster : world.posters) {
    const auto x = wall.place_of(poster.side, poster.at_m);
    if (!x) continue;
    const int material = patches.materials().find(poster.image, "poster");
    const float half = static_cast<float>(poster.width_m) / 2.0F;
    const auto middle = static_cast<float>(poster.height_m);
    const float tall = static_cast<float>(poster.tall_m) / 2.0F;
    patches.next_group();
    wall.face(patches, {*x - half, *x + half}, {middle - tall, middle + tall}, material, 0.006F);
  }
}

}  // namespace

void add_walls(PatchList& patches, std::vector<Lamp>& openings, const World& world,
               const FloorPlan& plan) {
  for (const WallSegment& segment : plan.walls) {
    const Wall wall(segment, plan);
    if (wall.length_m() < 1e-3F) continue;
    const std::vector<Span> windows = windows_on(wall, world);
    add_face(patches, wall, windows);
    for (const Span& window : windows) {
      add_window(patches, wall, window);
      openings.push_back(opening(wall, window));
    }
    std::vector<Span> doors;
    for (std::size_t i = 0; i < world.doors.size(); ++i) {
      const Door& door = world.doors[i];
      const auto x = wall.place_of(door.side, door.at_m);
      if (!x) continue;
      add_door(patches, wall.stand(), *x, door, static_cast<int>(i));
      const float half = static_cast<float>(door.width_m) / 2.0F + 0.07F;
      doors.push_back({*x - half, *x + half});
    }
    std::sort(doors.begin(), doors.end(), [](Span a, Span b) { return a.from < b.from; });
    add_skirting(patches, wall, doors);
    add_posters(patches, wall, world);
  }
}

}  // namespace striate::simulator::render
