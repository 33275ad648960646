// Stage `impact`: nothing passes through anything, and who is fast has its impacts when they happen (docs/impact.md).
//
// After a (sub-)step is solved, each body has come from its departure to where it is. A body is fast if a point of it
// may have come farther than half its thickness: only then can it have got through something, or deep into it, unseen.
// The way of each fast body is held against the ways of all that it can meet (collision/narrow/moment.h). Where two
// meet, and would get deeper into each other than half the thinner one's thickness, both are put where they were at
// that moment, the impact is solved there (dynamics/lone_impact.h), and they go on for the rest of the time. What
// happens first is solved first.
#include <algorithm>

#include "base/room.h"
#include "collision/narrow/moment.h"
#include "dynamics/integrate.h"
#include "geometry/triangle_mesh.h"
#include "world/stages.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

constexpr int most_meetings =
    8;  // of a body at a time: then it waits where it is (bounces in a closing wedge have no end)

Vec3d between(const Pos& from, const Pos& to) { return {to.x - from.x, to.y - from.y, to.z - from.z}; }

// Whether it came farther than `limit` (m) from its departure within `time`.
bool came_farther(const Bodies& b, std::uint32_t i, const Pose& from, Real time, Real limit) {
  const Vec3 way = b.position[i] - from.p;
  const Real turn = length_squared(b.spin[i]) * square(time * b.swing[i]);
  if (max(length_squared(way), turn) * 4 <= square(limit)) return false;
  return length(way) + sqrt(turn) > limit;
}

// A body that is in somebody's way, or on its own.
struct Mover {
  std::uint32_t body;
  Course course;  // until the end
  Pose end;       // where it leads
  bool fast = false;
  bool held = false;          // by joints: an impact changes its velocity, but it stays with what it hangs on
  bool linked = false;        // rests or hangs on something: its acceleration is not that of a free fall
  bool changed = false;       // it is not where the solver left it
  bool waits = false;         // for the rest of the time
  bool turns_freely = false;  // on the whole of its course, with the angular momentum that it shows
  int meetings = 0;
  // Free bodies are between two kicks of a leapfrog: what counts as their velocity is that of the middle of a sub-step.
  Vec3 acceleration;
  double velocity_at = 0;  // when it has the velocity that it shows
};

struct Meeting {
  std::uint32_t a, b;  // movers
  std::uint32_t shape_a, shape_b, part;
  double time = infinite;
  bool first_touch = true;  // else they touched before, and are deep in each other now
  bool comes = false;       // stage `collide` left their impact to us
  auto key() const { return std::tuple(shape_a, shape_b, part); }
  auto order() const { return std::tuple(time, shape_a, shape_b, part); }
};

void keep_one_of_each(std::vector<Meeting>& meetings) {
  std::ranges::sort(meetings, {}, [](const Meeting& m) { return std::tuple(m.key(), !m.comes); });
  const auto same = [](const Meeting& x, const Meeting& y) { return x.key() == y.key(); };
  meetings.erase(std::unique(meetings.begin(), meetings.end(), same), meetings.end());
}

class Impacts {
 public:
  Impacts(World::Impl& w, std::span<const std::uint32_t> fast)
      : w_(w), b_(w.bodies), end_(w.h * w.substeps_at_once()), places_(w.impact_places) {
    make_room(places_, w.bodies.size());
    for (const std::vector<std::uint32_t>* moving : {&w.awake, &w.kinematic}) {
      for (const std::uint32_t i : *moving) places_[i].came = true;
    }
    for (const std::uint32_t i : fast) movers_[mover(i)].fast = true;
    fast_ = std::uint32_t(movers_.size());
    for (const std::vector<std::uint32_t>* moving : {&w.awake, &w.kinematic}) {
      for (const std::uint32_t i : *moving) {
        if (!places_[i].is_mover) widen(i);
      }
    }
  }

  ~Impacts() {
    for (const Mover& m : movers_) places_[m.body] = {};
    for (const std::vector<std::uint32_t>* moving : {&w_.awake, &w_.kinematic}) {
      for (const std::uint32_t i : *moving) places_[i] = {};
    }
  }
  Impacts(const Impacts&) = delete;
  Impacts& operator=(const Impacts&) = delete;

  void run() {
    std::vector<Meeting> fresh;
    for (std::uint32_t m = 0; m < fast_; ++m) seek(m, 0, fresh);
    for (const std::uint32_t p : w_.coming) {
      const PairRow& row = w_.pairs[p];
      const auto [i, k] = w_.bodies_of(row.key);
      const std::uint32_t a = mover(i), b = mover(k);
      coming_.push_back({a, b, row.key.a, row.key.b, row.part});
      coming_.back().comes = true;
    }
    fresh.insert(fresh.end(), coming_.begin(), coming_.end());
    keep_one_of_each(fresh);
    look(fresh, 0);
    while (!meetings_.empty()) {
      const auto next = std::ranges::min_element(meetings_, {}, &Meeting::order);
      const Meeting meeting = *next;
      meet(meeting);
    }
    for (const Mover& m : movers_) {
      if (m.changed) settle(m);
    }
  }

 private:
  // How far what is not fast came at most: its box is where it departed.
  void widen(std::uint32_t i) {
    const Real turn = length(b_.spin[i]) * Real(end_) * b_.swing[i];
    slow_way_ = max(slow_way_, length(b_.position[i] - w_.departures[i].p) + turn);
  }

  std::uint32_t mover(std::uint32_t i) {
    ImpactPlace& place = places_[i];
    if (place.is_mover) return place.mover;
    place.is_mover = true, place.mover = std::uint32_t(movers_.size());
    Mover& m = movers_.emplace_back();
    m.body = i;
    m.end = b_.center_pose(i);
    const bool came = place.came;
    m.held = w_.joint_graph.count(i) > 0;
    const Pose start = came ? w_.departures[i] : m.end;
    const Vec3 spin = came ? b_.spin[i] : Vec3{};
    const bool turns = m.held && length(spin) * Real(end_) > 1;  // else an arc is about as long as its chord
    m.course = Course::between(0, start, m.end, spin, end_, turns ? pivot(i, start, m.end) : Vec3{});
    m.linked = !came || !b_.dynamic(i) || m.held || is_pressed(i);
    const bool alone = came && b_.dynamic(i) && !w_.islands[w_.island_of[i]].linked;
    m.turns_freely = alone || (w_.detects_each_substep() && !m.held);
    m.velocity_at = end_ - w_.h / 2;
    return place.mover;
  }

  // What moves least of a body that hangs on joints: its centre or what is tied. About that it turns.
  Vec3 pivot(std::uint32_t i, const Pose& start, const Pose& end) const {
    Vec3 best;
    auto least = std::pair(length(end.p - start.p), no_body);
    w_.joint_graph.each_joint(i, [&](std::uint32_t j) {
      const Vec3& anchor = w_.joints.a[j] == i ? w_.joints.anchor_a[j] : w_.joints.anchor_b[j];
      const auto moved = std::pair(length(end.point(anchor) - start.point(anchor)), j);
      if (moved < least) least = moved, best = anchor;
    });
    return best;
  }

  // Whether a contact acted on it when the step was solved.
  bool is_pressed(std::uint32_t i) const {
    bool pressed = false;
    b_.each_shape(i, [&](std::uint32_t s) {
      w_.pairs.each(s, [&](std::uint32_t p) {
        const std::uint32_t contact = w_.pairs[p].row;
        pressed |= contact != no_row && w_.contacts.impulse[contact].normal != std::array<Real, 4>{};
      });
    });
    return pressed;
  }

  // --- who may meet ---

  Box swept(const Mover& m, double begin) const {
    const Pos from = m.course.at(begin), to = m.course.at(end_);
    Box box;
    const double around = double(b_.radius[m.body] + length(m.course.pivot));
    for (int k = 0; k < 3; ++k) {
      box.low[k] = std::min(from[k], to[k]) - around;
      box.high[k] = std::max(from[k], to[k]) + around;
    }
    return box;
  }

  // Appends the meetings that mover m may have from `begin` on.
  void seek(std::uint32_t m, double begin, std::vector<Meeting>& out) {
    const std::uint32_t body = movers_[m].body;
    const Box box = swept(movers_[m], begin);
    if (movers_[m].fast) {
      Box wide = box;
      for (int k = 0; k < 3; ++k) wide.low[k] -= double(slow_way_), wide.high[k] += double(slow_way_);
      near_.clear();
      w_.broad->search(w_.proxies, wide, near_);
      for (const PlaneProxy& plane : w_.planes) near_.push_back(plane.proxy);
      std::ranges::sort(near_);
      near_.erase(std::unique(near_.begin(), near_.end()), near_.end());
      for (const std::uint32_t s : near_) {
        if (!b_.shapes.slots.used(s)) continue;
        const std::uint32_t other = w_.body_of(s);
        if (other == body || (places_[other].is_mover && movers_[places_[other].mover].fast)) continue;
        if (!can_meet(body, other)) continue;
        const std::uint32_t o = mover(other);
        b_.each_shape(body, [&](std::uint32_t own) { pair_up(m, own, o, s, begin, out); });
      }
    }
    for (std::uint32_t o = 0; o < movers_.size(); ++o) {
      const Mover& other = movers_[o];
      if (!other.fast || o == m || !overlap(box, swept(other, begin)) || !can_meet(body, other.body)) continue;
      if (movers_[m].fast && begin == 0 && o > m) continue;  // at first all seek: each two once
      b_.each_shape(body, [&](std::uint32_t own) {
        b_.each_shape(other.body, [&](std::uint32_t s) { pair_up(m, own, o, s, begin, out); });
      });
    }
  }

  bool can_meet(std::uint32_t i, std::uint32_t k) const {
    if (b_.quarantined[i] != 0 || b_.quarantined[k] != 0) return false;
    return (b_.dynamic(i) || b_.dynamic(k)) && !w_.forbidden({i, k});
  }

  void pair_up(std::uint32_t m, std::uint32_t s, std::uint32_t o, std::uint32_t t, double begin,
               std::vector<Meeting>& out) {
    if (!may_touch(b_.shapes.filter[s], b_.shapes.filter[t])) return;
    Meeting meeting{m, o, s, t, no_part};
    if (s > t) std::swap(meeting.a, meeting.b), std::swap(meeting.shape_a, meeting.shape_b);
    if (relative_speed(meeting) * (end_ - begin) <= double(w_.unseen_depth(s, t))) return;
    const bool of_s = w_.geometries[s]->kind == ShapeKind::mesh, of_t = w_.geometries[t]->kind == ShapeKind::mesh;
    if (of_s && of_t) return;
    if (!of_s && !of_t) {
      out.push_back(meeting);
    } else {
      each_triangle(of_s ? m : o, of_s ? s : t, of_s ? o : m, begin, [&](std::uint32_t triangle) {
        meeting.part = triangle;
        out.push_back(meeting);
      });
    }
  }

  // How fast the two come towards each other at most, m/s.
  double relative_speed(const Meeting& m) const {
    const Course &a = movers_[m.a].course, &b = movers_[m.b].course;
    const auto turning = [&](const Course& c, std::uint32_t mover) {
      return c.spin == Vec3d{} ? 0 : length(c.spin) * double(b_.swing[movers_[mover].body] + length(c.pivot));
    };
    return length(a.velocity - b.velocity) + turning(a, m.a) + turning(b, m.b);
  }

  // Those of the mesh that the other's way comes near.
  template <class Visit>
  void each_triangle(std::uint32_t of_mesh, std::uint32_t mesh, std::uint32_t of_other, double begin,
                     Visit visit) const {
    const Course& course = movers_[of_mesh].course;
    const Pos center = course.center(begin);
    const Quatd q = course.orientation(begin);
    const Transform frame = b_.shape_frame(mesh);
    const Pos at = center + rotate(q, convert<double>(frame.p));
    const Mat3d turn = matrix(q * normalize(convert<double>(frame.q)));
    const Box box = swept(movers_[of_other], begin);
    const Pos middle{(box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2, (box.low.z + box.high.z) / 2};
    const Vec3d half = between(middle, box.high), d = between(at, middle);
    const double turned = length(course.spin) * (end_ - begin);
    const double more =
        length(course.velocity) * (end_ - begin) + (turned > 0 ? turned * double(b_.radius[movers_[of_mesh].body]) : 0);
    Vec3d low, high;
    for (int k = 0; k < 3; ++k) {
      const double there = dot(turn[k], d), reach = dot(abs(turn[k]), half) + more;
      low[k] = there - reach, high[k] = there + reach;
    }
    std::vector<std::uint32_t> triangles;
    w_.geometries[mesh]->mesh->search(convert<Real>(low), convert<Real>(high),
                                      [&](std::uint32_t t) { triangles.push_back(t); });
    std::ranges::sort(triangles);
    for (const std::uint32_t t : triangles) visit(t);
  }

  // --- when they meet ---

  Encounter encounter(const Meeting& m) const {
    const auto shape = [&](std::uint32_t mover, std::uint32_t s) {
      return ShapeOnCourse{w_.geometries[s], b_.shape_frame(s), movers_[mover].course};
    };
    return {shape(m.a, m.shape_a), shape(m.b, m.shape_b), m.part};
  }

  Real least(const Meeting& m, Real a, Real b) const {
    const bool of_a = b_.dynamic(movers_[m.a].body), of_b = b_.dynamic(movers_[m.b].body);
    return of_a && of_b ? min(a, b) : of_a ? a : b;
  }
  // How near counts as a touch, m.
  double touch(const Meeting& m) const {
    return 1e-6 * double(least(m, b_.radius[movers_[m.a].body], b_.radius[movers_[m.b].body]));
  }
  // Sets when they meet, if they do.
  void find(Meeting& m, double begin) const {
    m.time = infinite;
    const Encounter e = encounter(m);
    const double near = touch(m), deep = double(w_.unseen_depth(m.shape_a, m.shape_b));
    if (!e.may_meet(begin, end_, near)) return;
    std::optional<double> touches = e.first(begin, end_, near, near);
    if (!touches) return;
    // What it meets at the moment of another impact, or comes upon although it touches already.
    const bool at_once = m.first_touch && (begin > 0 || m.comes);
    if (*touches == begin && !at_once) {
      // What the solver holds, or what was struck just now, meets again once it is deeper, or once it has left. Who
      // hangs on something is left to the solver while it touches: that knows the joints.
      const double least = min(-deep, e.distance(begin) - 0.1 * deep), rounding = 0.02 * deep;
      touches = e.first_or_left(begin, end_, least, rounding, 0.5 * deep);
      if (!touches) return;
      if (e.distance(*touches) <= least + rounding) {
        if (movers_[m.a].held || movers_[m.b].held) return;
        m.first_touch = false, m.time = *touches;
        return;
      }
      touches = e.first(*touches, end_, near, near);
      if (!touches) return;
    }
    if (!e.concerns(begin, *touches, end_)) return;
    // Who leaps and rests on nothing meets what it touches. Else it must get deep: what slides over a seam does not.
    const bool flies = !movers_[m.a].linked || !movers_[m.b].linked;
    const bool leaps = m.comes || relative_speed(m) * end_ > double(World::Impl::leap) * deep;
    if (!(flies && leaps) && !e.first(*touches, end_, -deep, 0.02 * deep)) return;
    m.first_touch = true, m.time = *touches;
  }

  // Keeps those that do meet.
  void look(std::vector<Meeting>& fresh, double begin) {
    w_.pool->for_ranges(std::uint32_t(fresh.size()), 8, [&](std::uint32_t, std::uint32_t first, std::uint32_t end) {
      for (std::uint32_t k = first; k < end; ++k) find(fresh[k], begin);
    });
    for (const Meeting& m : fresh) {
      if (m.time < infinite) meetings_.push_back(m);
    }
  }

  // --- what comes of it ---

  // Each meeting counts for both, so that they have an end whatever comes of them.
  void meet(const Meeting& m) {
    const std::array<std::uint32_t, 2> both{m.a, m.b};
    const auto done = [&](std::uint32_t n) {
      return movers_[n].meetings >= most_meetings || !b_.dynamic(movers_[n].body);
    };
    if (std::ranges::all_of(both, done)) {
      std::erase_if(meetings_, [&](const Meeting& x) { return x.key() == m.key(); });
      return;
    }
    for (const std::uint32_t n : both) ++movers_[n].meetings;
    const std::array<Shown, 2> before{bring(m.a, m.time), bring(m.b, m.time)};
    const bool struck = strike(m);
    renewed_.clear();
    // They come nearer although they do not want to: one of them does not go where its velocity leads.
    const bool stuck = std::ranges::any_of(both, [&](std::uint32_t n) { return movers_[n].held || movers_[n].waits; });
    for (std::size_t k = 0; k < 2; ++k) {
      const bool dynamic = b_.dynamic(movers_[both[k]].body);
      if (struck && dynamic) {
        go_on(both[k], m.time);
      } else {
        const Mover& mover = movers_[both[k]];
        const bool waits = dynamic && mover.fast && (stuck || mover.meetings >= most_meetings);
        if (waits && !m.first_touch)
          wait(both[k], m.time);
        else
          take_back(both[k], before[k]);
      }
    }
    const auto stale = [&](const Meeting& x) {
      return x.key() == m.key() || std::ranges::any_of(renewed_, [&](std::uint32_t r) { return x.a == r || x.b == r; });
    };
    std::erase_if(meetings_, stale);
    std::vector<Meeting> fresh;
    if (!struck) fresh.push_back(m);  // they only graze, or leave each other
    for (const std::uint32_t r : renewed_) {
      seek(r, m.time, fresh);
      std::ranges::copy_if(coming_, std::back_inserter(fresh), [&](const Meeting& x) { return x.a == r || x.b == r; });
    }
    keep_one_of_each(fresh);
    for (Meeting& x : fresh) x.first_touch = x.key() != m.key();
    look(fresh, m.time);
  }

  // What of a body and its mover is to be put back where nothing comes of a meeting.
  struct Shown {
    BodyMotion motion;
    double velocity_at;
  };
  void take_back(std::uint32_t number, const Shown& shown) {
    Mover& m = movers_[number];
    m.velocity_at = shown.velocity_at;
    if (b_.dynamic(m.body))
      place(b_, m.body, shown.motion);
    else
      b_.position[m.body] = shown.motion.position, b_.orientation[m.body] = shown.motion.orientation;
  }

  // To where it is at that time, with the velocity that it has then.
  Shown bring(std::uint32_t number, double time) {
    Mover& m = movers_[number];
    const std::uint32_t i = m.body;
    const Shown before{{b_.position[i], b_.orientation[i], b_.velocity[i], b_.angular_momentum[i]}, m.velocity_at};
    if (!b_.dynamic(i)) {
      if (places_[i].came)
        b_.position[i] = m.course.center(time), b_.orientation[i] = convert<Real>(m.course.orientation(time));
      return before;
    }
    if (!m.linked && m.acceleration == Vec3{}) {
      std::vector<Wrench> load;
      evaluate(w_.forces, b_, std::span(&i, 1), load);
      m.acceleration = load[0].force * b_.inverse_mass[i];
    }
    const Vec3 velocity = b_.velocity[i] + m.acceleration * Real(time - m.velocity_at);
    m.velocity_at = time;
    const Quat turned = convert<Real>(m.course.orientation(time));
    if (m.course.pivot != Vec3{}) {
      place(b_, i, {m.course.center(time), turned, velocity, b_.angular_momentum[i]});
      turn_about_pivot(m, time);
    } else if (m.turns_freely) {  // not quite as on its course: that would change its energy
      const Vec3& momentum = b_.angular_momentum[i];
      const Rotation r = rotate_freely(convert<Real>(m.course.turned), momentum, b_.inertia[i], b_.inverse_inertia[i],
                                       Real(time - m.course.begin));
      place(b_, i, {m.course.center(time), r.orientation, velocity, momentum});
    } else {  // its momentum has changed on the way, nobody knows how: it keeps its energy
      const Vec3 momentum = rotate(turned, rotate_back(b_.orientation[i], b_.angular_momentum[i]));
      place(b_, i, {m.course.center(time), turned, velocity, momentum});
    }
    return before;
  }

  // Where it turns about a joint its velocity turns as well.
  void turn_about_pivot(const Mover& m, double time) {
    const std::uint32_t i = m.body;
    const Vec3d arm = between(m.course.at(time), m.course.center(time));
    b_.set_velocity(i, convert<Real>(m.course.velocity + cross(m.course.spin, arm)), convert<Real>(m.course.spin));
  }

  bool strike(const Meeting& m) {
    const std::uint32_t i = movers_[m.a].body, k = movers_[m.b].body;
    const Pose at_a = b_.shape_pose(m.shape_a), at_b = b_.shape_pose(m.shape_b);
    Manifold manifold;
    AxisCache cache;
    const Real together = Real(2 * touch(m)) + Real(0.01) * w_.unseen_depth(m.shape_a, m.shape_b);  // points of a face
    collide_placed(*w_.geometries[m.shape_a], at_a, *w_.geometries[m.shape_b], at_b, m.part, together, cache, manifold);
    if (manifold.count == 0) {
      const Encounter::Place place = encounter(m).place(m.time);
      manifold.normal = place.normal;
      manifold.count = 1;
      manifold.points[0].at = place.at - at_a.p;
    }
    const ProxyPair key{m.shape_a, m.shape_b};
    const ActiveContact contact{i, k, m.shape_a, m.shape_b, m.part, 0, &manifold, w_.pair_material(key)};
    const Real speed = w_.lone_impact.strike(w_.view(), contact);
    if (!(speed > 0)) return false;
    const auto handle = [&](std::uint32_t body) { return b_.slots.handle<BodyTag>(body); };
    w_.events.hits.push_back({handle(i), handle(k), at_a.p + manifold.points[0].at, manifold.normal, speed});
    for (const std::uint32_t body : {i, k}) {
      if (b_.dynamic(body)) w_.wake_island(body);
    }
    return true;
  }

  // From now on, with the velocity that an impact gave it.
  void go_on(std::uint32_t number, double time) {
    Mover& m = movers_[number];
    const std::uint32_t i = m.body;
    m.changed = true;
    if (m.held && !m.fast) {  // it stays with what it hangs on, and brings along its velocity
      place(b_, i, {m.end.p, m.end.q, b_.velocity[i], b_.angular_momentum[i]});
      return;
    }
    if (m.held || m.meetings >= most_meetings) return wait(number, time);
    const double left = end_ - time;
    const Vec3d velocity = convert<double>(b_.velocity[i]) + convert<double>(m.acceleration) * (left / 2);
    const Quat turned =
        rotate_freely(b_.orientation[i], b_.angular_momentum[i], b_.inertia[i], b_.inverse_inertia[i], Real(left))
            .orientation;
    const Pose now = b_.center_pose(i);
    m.end = {now.p + velocity * left, turned};
    m.turns_freely = true;
    m.course = Course::between(time, now, m.end, b_.spin[i], max(left, std::numeric_limits<double>::min()));
    m.fast |= came_farther(b_, i, {m.end.p, now.q}, Real(left), World::Impl::unseen_share * b_.thickness[i]);
    renewed_.push_back(number);
  }

  // It stays where it was brought for the rest, and all that hangs on it.
  void wait(std::uint32_t number, double time) {
    std::vector<std::uint32_t> all{movers_[number].body};
    w_.joint_graph.each_joint(all[0], [&](std::uint32_t j) {
      for (const std::uint32_t i : w_.joint_graph.component(j).dynamic) all.push_back(i);
    });
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    for (const std::uint32_t i : all) {
      const std::uint32_t n = mover(i);
      if (n != number) bring(n, time);
      Mover& m = movers_[n];
      m.end = b_.center_pose(i);
      m.course = Course::between(time, m.end, m.end, {}, 1);
      m.changed = m.waits = true;
      renewed_.push_back(n);
    }
  }

  void settle(const Mover& m) {
    const std::uint32_t i = m.body;
    const Vec3 velocity = b_.velocity[i] + m.acceleration * Real(end_ - w_.h / 2 - m.velocity_at);
    place(b_, i, {m.end.p, m.end.q, velocity, b_.angular_momentum[i]});
    disturb(b_, i);
    b_.each_shape(i, [&](std::uint32_t s) { w_.touch_proxy(s, false); });
  }

  World::Impl& w_;
  Bodies& b_;
  double end_;  // of the time that was solved, s
  Real slow_way_ = 0;
  std::vector<ImpactPlace>& places_;   // by body slot
  std::vector<Mover> movers_;          // those that were fast from the beginning first
  std::uint32_t fast_;
  std::vector<Meeting> meetings_, coming_;  // coming: those that stage `collide` left
  std::vector<std::uint32_t> near_, renewed_;
};

}

void meet_fast(World::Impl& w) {
  const Bodies& b = w.bodies;
  const Real time = Real(w.h * w.substeps_at_once());
  std::vector<std::uint32_t> fast;
  for (const std::vector<std::uint32_t>* moving : {&w.awake, &w.kinematic}) {
    for (const std::uint32_t i : *moving) {
      if (came_farther(b, i, w.departures[i], time, World::Impl::unseen_share * b.thickness[i])) fast.push_back(i);
    }
  }
  std::erase_if(fast, [&](std::uint32_t i) { return b.quarantined[i] != 0; });
  if (fast.empty() && w.coming.empty()) return;
  std::ranges::sort(fast);
  Impacts(w, fast).run();
}

}
