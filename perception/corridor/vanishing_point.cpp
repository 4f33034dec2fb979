#include "striate/perception/corridor/vanishing_point.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "striate/base/index_within.hpp"
#include "striate/perception/corridor/ray_of.hpp"

namespace striate::perception {
namespace {

/// The least spread of a vote: finer bins would say nothing more
constexpr double kVoteBin_px = 2.0;
/// An image of 640 px that shows 4 degrees takes 11 500; what converges farther out is not sought
constexpr int kMostBins = 16384;
/// 3.4 deg, of one edge point's orientation over 3x3 pixels (ours)
constexpr double kAngleError_rad = 0.06;
/// cos 13 deg: |normal_u| above it is a door frame or corner, which meets nothing
constexpr float kUpright = 0.975F;
/// 1.4 deg: edges so near the horizon run along it and cross it anywhere (ours)
constexpr float kHorizonBand_px = 5.0F;
/// Sine, 6 deg: kAngleError_rad and as much again for where the point is not yet exact
constexpr float kAligned = 0.10F;
/// Over a quarter of 160 px: no single line may outvote two others (ours)
constexpr float kLongest_px = 45.0F;
constexpr float kShortest_px = 8.0F;  ///< shorter is texture; as far as kSamePlace_px (ours)
/// Places judged; the corridor's own, a crossing's, four of chance. Each costs time (ours)
constexpr int kCandidates = 6;
/// 2.3 deg at width 160, below kAngleError_rad: nearer ones are the same place
constexpr double kSamePlace_px = 8.0;
/// px of line: the horizon is known from the tilt, but a long line (45) knows better
constexpr double kHorizonPrior = 4.0;

/// Sine, 4.6 deg: a line so level crosses the horizon where its error puts it (ours)
constexpr double kLevel = 0.08;
/// Votes, 14 px in all: what a candidate takes from its neighbourhood (ours)
constexpr int kTakenBins = 3;
/// px uphill to either side of a candidate: two bins, half of kSamePlace_px
constexpr double kClimb_px = 4.0;
constexpr int kClimbSteps = 5;  ///< the bins from one end of the climb to the other
/// Times; each uses the lines through the point of the one before (ours)
constexpr int kRefinements = 2;

bool may_vote(const EdgePoint& e, const VanishingSearch& search) {
  return std::abs(e.normal_u) < kUpright &&
         std::abs(e.v_px - static_cast<float>(search.horizon_v_px)) > kHorizonBand_px;
}

/// One-dimensional votes along the horizon.
std::vector<double> vote(const std::vector<EdgePoint>& edges, const VanishingSearch& search) {
  const int bins = cut_within((search.to_u_px - search.from_u_px) / kVoteBin_px, 0, kMostBins) + 1;
  std::vector<double> votes(bins, 0.0);
  for (const EdgePoint& e : edges) {
    const double along = std::abs(e.normal_u);  // sine of the line's angle to the horizon
    if (along < kLevel) continue;
    const double dv = search.horizon_v_px - e.v_px;
    const double u = e.u_px - dv * e.normal_v / e.normal_u;
    const double spread_px =
        std::max(kVoteBin_px, std::abs(dv) * kAngleError_rad / (along * along));
    const int from = cut_within((u - spread_px - search.from_u_px) / kVoteBin_px, 0, bins);
    const int to = floor_within((u + spread_px - search.from_u_px) / kVoteBin_px, -1, bins - 1);
    for (int b = from; b <= to; ++b) votes[b] += e.weight / spread_px;
  }
  return votes;
}

std::vector<double> best_candidates(std::vector<double> votes, const VanishingSearch& search) {
  std::vector<double> candidates;
  const int bins = static_cast<int>(votes.size());
  for (int i = 0; i < kCandidates; ++i) {
    const auto top = std::max_element(votes.begin(), votes.end());
    if (*top <= 0.0) break;
    const int bin = static_cast<int>(top - votes.begin());
    candidates.push_back(search.from_u_px + (bin + 0.5) * kVoteBin_px);
    for (int b = std::max(0, bin - kTakenBins); b <= std::min(bins - 1, bin + kTakenBins); ++b)
      votes[b] = 0.0;
  }
  return candidates;
}

using Rays = std::array<float, kRays>;

/// An edge point that lies along a ray.
struct Aligned {
  const EdgePoint* edge = nullptr;
  int ray = 0;
};

/// The edges that point to (u, horizon), in their order, each with its ray from there.
void find_aligned(const std::vector<EdgePoint>& edges, double u_px, double v_px,
                  std::vector<Aligned>& aligned) {
  aligned.resize(edges.size());
  std::size_t count = 0;
  const auto u = static_cast<float>(u_px);
  const auto v = static_cast<float>(v_px);
  // Written in any case, and overwritten by the next where it does not count: a branch here would
  // be guessed wrong half of the time.
  for (const EdgePoint& e : edges) {
    const float du = e.u_px - u;
    const float dv = e.v_px - v;
    const float miss = du * e.normal_u + dv * e.normal_v;
    const float reach2 = du * du + dv * dv;
    aligned[count].edge = &e;
    count += miss * miss <= kAligned * kAligned * reach2 ? 1 : 0;
  }
  aligned.resize(count);
  for (Aligned& a : aligned) a.ray = ray_of(a.edge->u_px - u, a.edge->v_px - v);
}

/// Length of aligned edge in every direction.
Rays sum_rays(const std::vector<Aligned>& aligned) {
  Rays rays{};
  for (const Aligned& a : aligned) rays[a.ray] += a.edge->weight;
  return rays;
}

/// Long lines count, scattered edges do not: the square of what lies on one ray and its neighbours.
double score_of(const Rays& rays) {
  double score = 0.0;
  for (int r = 0; r < kRays; ++r) {
    const float side = rays[(r + 1) % kRays] + rays[(r + kRays - 1) % kRays];
    const float length = std::min(kLongest_px, rays[r] + 0.5F * side);
    if (length > kShortest_px) score += length * length;
  }
  return score;
}

struct Line {
  double normal_u = 0.0;
  double normal_v = 0.0;
  double offset = 0.0;  ///< normal . point
  double weight = 0.0;  ///< sum of edge weights, about its length
  double middle_u = 0.0;
};

/// Straight line through the edge points, by moments; weight 0 where they are too few.
Line fit_line(const std::vector<const EdgePoint*>& points) {
  double w = 0.0;
  double su = 0.0;
  double sv = 0.0;
  double suu = 0.0;
  double suv = 0.0;
  double svv = 0.0;
  for (const EdgePoint* e : points) {
    w += e->weight;
    su += e->weight * e->u_px;
    sv += e->weight * e->v_px;
    suu += static_cast<double>(e->weight) * e->u_px * e->u_px;
    suv += static_cast<double>(e->weight) * e->u_px * e->v_px;
    svv += static_cast<double>(e->weight) * e->v_px * e->v_px;
  }
  Line line;
  if (w < kShortest_px) return line;
  const double cuu = suu / w - su * su / (w * w);
  const double cuv = suv / w - su * sv / (w * w);
  const double cvv = svv / w - sv * sv / (w * w);
  const double angle = 0.5 * std::atan2(2.0 * cuv, cuu - cvv);  // of the line itself
  line.normal_u = -std::sin(angle);
  line.normal_v = std::cos(angle);
  line.offset = line.normal_u * su / w + line.normal_v * sv / w;
  line.weight = w;
  line.middle_u = su / w;
  return line;
}

/// The edge points of every ray, in their order.
class RayMembers {
 public:
  explicit RayMembers(const std::vector<Aligned>& aligned) : points_(aligned.size()) {
    for (const Aligned& a : aligned) ++starts_[a.ray + 1];
    for (int r = 0; r < kRays; ++r) starts_[r + 1] += starts_[r];
    std::array<int, kRays + 1> next = starts_;
    for (const Aligned& a : aligned) points_[next[a.ray]++] = a.edge;
  }
  [[nodiscard]] std::span<const EdgePoint* const> of(int ray) const {
    return {points_.data() + starts_[ray], points_.data() + starts_[ray + 1]};
  }

 private:
  std::array<int, kRays + 1> starts_{};
  std::vector<const EdgePoint*> points_;
};

/// The long lines through a point: local maxima over the rays, each fitted to its edge points.
std::vector<Line> lines_through(const std::vector<Aligned>& aligned) {
  const Rays rays = sum_rays(aligned);
  const RayMembers members(aligned);
  std::vector<Line> lines;
  std::vector<const EdgePoint*> points;
  for (int r = 0; r < kRays; ++r) {
    const int before = (r + kRays - 1) % kRays;
    const int after = (r + 1) % kRays;
    if (rays[r] < rays[before] || rays[r] <= rays[after]) continue;
    points.clear();
    for (const int ray : {r, before, after}) {
      points.insert(points.end(), members.of(ray).begin(), members.of(ray).end());
    }
    const Line line = fit_line(points);
    if (line.weight > 0.0) lines.push_back(line);
  }
  return lines;
}

/// Least squares: where the lines meet, with the horizon's row as one more observation.
void meet(const std::vector<Line>& lines, double horizon_v_px, VanishingPoint& point) {
  double a = 1e-9;
  double b = 0.0;
  double c = kHorizonPrior;
  double x = 0.0;
  double y = kHorizonPrior * horizon_v_px;
  for (const Line& line : lines) {
    const double w = std::min<double>(line.weight, kLongest_px);
    a += w * line.normal_u * line.normal_u;
    b += w * line.normal_u * line.normal_v;
    c += w * line.normal_v * line.normal_v;
    x += w * line.normal_u * line.offset;
    y += w * line.normal_v * line.offset;
  }
  const double determinant = a * c - b * b;
  point.u_px = (c * x - b * y) / determinant;
  point.v_px = (a * y - b * x) / determinant;
}

void describe(const std::vector<Line>& lines, VanishingPoint& point) {
  double total = 0.0;
  double miss = 0.0;
  for (const Line& line : lines) {
    const double distance =
        std::abs(line.normal_u * point.u_px + line.normal_v * point.v_px - line.offset);
    total += line.weight;
    miss += line.weight * distance;
    (line.middle_u < point.u_px ? point.lines_left : point.lines_right) += line.weight;
  }
  point.lines = static_cast<int>(lines.size());
  point.spread_px = total > 0.0 ? miss / total : 0.0;
}

/// Uphill from a candidate, then to the meeting point of the lines through it.
VanishingPoint refine(const std::vector<EdgePoint>& voters, const VanishingSearch& search,
                      double candidate_u_px) {
  VanishingPoint point;
  point.v_px = search.horizon_v_px;
  std::vector<Aligned> aligned;
  // Counted, too: so far out that another step leads nowhere it would never end.
  int steps = 0;
  for (double u = candidate_u_px - kClimb_px;
       u <= candidate_u_px + kClimb_px && steps < kClimbSteps; u += kVoteBin_px, ++steps) {
    find_aligned(voters, u, search.horizon_v_px, aligned);
    const double score = score_of(sum_rays(aligned));
    if (score > point.score) {
      point.score = score;
      point.u_px = u;
    }
  }
  if (point.score <= 0.0) point.u_px = candidate_u_px;
  std::vector<Line> lines;
  for (int round = 0; round < kRefinements; ++round) {
    find_aligned(voters, point.u_px, point.v_px, aligned);
    lines = lines_through(aligned);
    if (lines.empty()) break;
    meet(lines, search.horizon_v_px, point);
  }
  describe(lines, point);
  return point;
}

}  // namespace

std::vector<VanishingPoint> find_vanishing_points(const std::vector<EdgePoint>& edges,
                                                  const VanishingSearch& search) {
  std::vector<EdgePoint> voters;
  for (const EdgePoint& e : edges) {
    if (may_vote(e, search)) voters.push_back(e);
  }
  std::vector<VanishingPoint> all;
  for (const double candidate : best_candidates(vote(voters, search), search)) {
    const VanishingPoint point = refine(voters, search, candidate);
    if (point.lines > 0) all.push_back(point);
  }
  for (const double u_px : search.also_u_px) all.push_back(refine(voters, search, u_px));
  std::stable_sort(all.begin(), all.end(), [](const VanishingPoint& a, const VanishingPoint& b) {
    return a.score > b.score;
  });
  std::vector<VanishingPoint> distinct;
  for (const VanishingPoint& p : all) {
    const bool known = std::any_of(distinct.begin(), distinct.end(), [&](const VanishingPoint& d) {
      return std::abs(d.u_px - p.u_px) < kSamePlace_px;
    });
    if (!known) distinct.push_back(p);
  }
  return distinct;
}

}  // namespace striate::perception
