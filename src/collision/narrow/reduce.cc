#include "collision/narrow/reduce.h"

#include "collision/narrow/flat.h"
#include "collision/narrow/small_array.h"

#include <limits>

namespace sudar::inline SUDAR_PRECISION {
namespace {

constexpr Real better = Real(1.001);  // see the header
constexpr Real merge_share = Real(1e-4), tie_share = Real(2e-4);
// What is steeper than 45° takes no part in a contact for many steps.
constexpr Real steepest = 1;

bool is_new(const ManifoldPoint& p, const Manifold& kept, Real merge) {
  for (int i = 0; i < kept.count; ++i) {
    if (length_squared(p.at - kept.points[std::size_t(i)].at) <= square(merge)) return false;
  }
  return true;
}

// A candidate as seen from the first one kept: across the plane of contact, and how much larger its gap is.
struct Seen {
  const ManifoldPoint* point;
  Vec3 off;
  Real rise;
};
using Sight = SmallArray<Seen, 64>;

const ManifoldPoint& deepest(std::span<const ManifoldPoint> candidates, Real tie) {
  Real lowest = candidates[0].separation;
  for (const ManifoldPoint& p : candidates) lowest = min(lowest, p.separation);
  // A direction that no edge or diagonal of an ordinary shape is perpendicular to.
  constexpr Vec3 direction{Real(0.4823), Real(0.3719), Real(0.7931)};
  const ManifoldPoint* best = nullptr;
  for (const ManifoldPoint& p : candidates) {
    if (p.separation <= lowest + tie && (!best || dot(direction, p.at - best->at) > 0)) best = &p;
  }
  return *best;
}

// The point that the bodies touch first, or deepest, when they turn about a point or an edge.
struct Next {
  const Seen* point = nullptr;
  Real slope = 0;  // its rise by its distance
};

// Of the points farther than `least`: how far each overlaps after a turn by `most_turn`, or by as much as the first
// touch needs; of those that overlap most, the farthest.
template <class Distance, class Rise>
Next next(const Sight& sight, Real least, Real tie, Real most_turn, Distance distance, Rise rise) {
  Real lowest = steepest;
  for (const Seen& s : sight) {
    if (const Real d = distance(s); d > least) lowest = min(lowest, rise(s) / d);
  }
  Next found;
  if (lowest >= steepest) return found;
  const Real turn = max(lowest, most_turn);
  Real most = -std::numeric_limits<Real>::infinity(), farthest = least;
  for (const Seen& s : sight) {
    if (const Real d = distance(s); d > least) most = max(most, turn * d - rise(s));
  }
  for (const Seen& s : sight) {
    const Real d = distance(s);
    if (d > farthest && turn * d - rise(s) >= most - tie) found = {&s, rise(s) / d}, farthest = d * better;
  }
  return found;
}

class Reduction {
 public:
  Reduction(std::span<const ManifoldPoint> candidates, const Vec3& normal, Real turn, Real scale, Manifold& out)
      : normal_(normal),
        turn_(max(Real(flat_sine), turn)),
        merge_(merge_share * scale),
        tie_(tie_share * scale),
        first_(deepest(candidates, tie_)),
        sight_(candidates.size()),
        out_(out) {
    const Real lowest = max(first_.separation, Real(0));
    for (const ManifoldPoint& p : candidates) {
      const Vec3 off = p.at - first_.at;
      sight_.push({&p, off - normal * dot(normal, off), max(p.separation, Real(0)) - lowest});
    }
  }

  void run() {
    keep(first_);
    const auto rise = [](const Seen& s) { return s.rise; };
    const Next second = next(
        sight_, merge_, tie_, turn_, [](const Seen& s) { return length(s.off); }, rise);
    if (!second.point) return;
    const Vec3 along = normalize(second.point->off), across = cross(normal_, along);
    const auto above_edge = [&](const Seen& s) { return s.rise - second.slope * dot(along, s.off); };
    Next facet, other;
    Real side = 1;
    for (const Real way : {Real(1), Real(-1)}) {
      const auto distance = [&](const Seen& s) { return way * dot(across, s.off); };
      Next found = next(sight_, merge_, tie_, turn_, distance, above_edge);
      if (!found.point) continue;
      if (!facet.point || found.slope * better < facet.slope) std::swap(facet, found), side = way;
      other = found;
    }
    if (!facet.point) return keep(*second.point->point);
    Sight corners(sight_.size());
    for (const Seen& s : sight_) {
      if (above_edge(s) <= facet.slope * side * dot(across, s.off) + tie_) corners.push(s);
    }
    span(corners);
    if (out_.count == 4) return;
    out_.count = 1;
    for (const Next& n : {second, facet, other}) {
      if (n.point) keep(*n.point->point);
    }
  }

 private:
  // Keeps the corners that span a facet about the first point.
  void span(const Sight& corners) {
    const auto farthest = [&](auto distance) {
      return next(corners, merge_, tie_, turn_, distance, [](const Seen&) { return Real(0); }).point;
    };
    const Seen* far = farthest([](const Seen& s) { return length(s.off); });
    if (!far) return;
    keep(*far->point);
    const Vec3 across = normalize(cross(normal_, far->off));
    for (const Real way : {Real(1), Real(-1)}) {
      if (const Seen* s = farthest([&](const Seen& c) { return way * dot(across, c.off); })) keep(*s->point);
    }
  }

  void keep(const ManifoldPoint& p) {
    if (is_new(p, out_, merge_)) out_.points[std::size_t(out_.count++)] = p;
  }

  const Vec3& normal_;
  const Real turn_, merge_, tie_;
  const ManifoldPoint& first_;
  Sight sight_;
  Manifold& out_;
};

}

void reduce(std::span<const ManifoldPoint> candidates, const Vec3& normal, Real turn, Real scale, Manifold& out) {
  out.count = 0;
  if (candidates.size() <= 4) {
    for (const ManifoldPoint& p : candidates) {
      if (is_new(p, out, merge_share * scale)) out.points[std::size_t(out.count++)] = p;
    }
    return;
  }
  Reduction(candidates, normal, turn, scale, out).run();
}

}
