#include "verify/picture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace sudar::verify {

namespace {

// Seen from the front, a little from the right and from above.
struct View {
  Vec3d right, up, away;
  View() {
    const double yaw = 0.35, pitch = 0.25;
    right = {std::cos(yaw), 0, -std::sin(yaw)};
    away = {-std::sin(yaw) * std::cos(pitch), -std::sin(pitch), -std::cos(yaw) * std::cos(pitch)};
    up = cross(right, away);
  }
  double x(const Vec3d& p) const { return dot(right, p); }
  double y(const Vec3d& p) const { return -dot(up, p); }
};
const View view;

// Points all over a round shape, in its frame; their outline is the shape's.
std::vector<Vec3d> surface(const Shape& s) {
  std::vector<Vec3d> points;
  const double r = double(s.radius()), h = double(s.half_length());
  constexpr int round = 32;
  for (int i = 0; i < round; ++i) {
    const double a = 2 * pi * i / round, c = std::cos(a), z = std::sin(a);
    switch (s.kind()) {
      case ShapeKind::cylinder:
        points.push_back({r * c, h, r * z}), points.push_back({r * c, -h, r * z});
        break;
      case ShapeKind::cone:
        points.push_back({r * c, -h / 2, r * z}), points.push_back({0, 1.5 * h, 0});
        break;
      default:
        for (int k = 0; k <= round / 2; ++k) {
          const double b = 2 * pi * k / round, y = std::cos(b), out = std::sin(b);
          Vec3d p{out * c, y, out * z};
          if (s.kind() == ShapeKind::ellipsoid)
            p = {p.x * double(s.radii().x), p.y * double(s.radii().y), p.z * double(s.radii().z)};
          else
            p = p * r + Vec3d{0, y > 0 ? h : -h, 0};
          points.push_back(p);
        }
    }
  }
  return points;
}

}

// A. Andrew's monotone chain.
std::vector<Picture::Point> Picture::outline_of(std::vector<Point> p) {
  std::sort(p.begin(), p.end(), [](const Point& a, const Point& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  std::vector<Point> chain;
  const auto add = [&](const Point& q, std::size_t least) {
    while (chain.size() > least) {
      const Point &a = chain[chain.size() - 2], &b = chain.back();
      if ((b.x - a.x) * (q.y - a.y) - (b.y - a.y) * (q.x - a.x) > 0) break;
      chain.pop_back();
    }
    chain.push_back(q);
  };
  for (const Point& q : p) add(q, 1);
  const std::size_t lower = chain.size();
  for (std::size_t i = p.size() - 1; i-- > 0;) add(p[i], lower);
  chain.pop_back();
  return chain;
}

Picture::Item Picture::draw_shape(const ShapeView& b, bool fixed, std::size_t number) {
  const Pose pose = b.pose();
  const Quatd q = convert<double>(pose.q);
  const auto place = [&](const Vec3d& p) { return rotate(q, p) + Vec3d{pose.p.x, pose.p.y, pose.p.z}; };
  const auto seen = [](const Vec3d& p) { return Point{view.x(p), view.y(p)}; };
  const double hue = std::fmod(205 + 137.508 * double(number), 360);
  Item item{dot(view.away, place({})), fixed ? "hsl(215 8%" : "hsl(" + std::to_string(int(hue)) + " 52%", {}, fixed};
  if (b.shape().kind() != ShapeKind::hull && b.shape().kind() != ShapeKind::mesh) {
    std::vector<Point> points;
    for (const Vec3d& p : surface(b.shape())) points.push_back(seen(place(p)));
    item.patches.push_back({outline_of(std::move(points)), 0.6});
    return item;
  }
  const auto vertices = b.shape().vertices();
  const Vec3d sun = normalize(Vec3d{0.3, 1, 0.6});
  for (const auto& face : b.shape().faces()) {
    std::vector<Vec3d> corners;
    for (const std::uint32_t v : face) corners.push_back(place(convert<double>(vertices[v])));
    const Vec3d n = cross(corners[1] - corners[0], corners[2] - corners[1]);
    if (dot(n, view.away) >= 0) continue;
    Patch patch{{}, 0.25 + 0.6 * std::max(0.0, dot(normalize(n), sun))};
    for (const Vec3d& c : corners) patch.outline.push_back(seen(c));
    item.patches.push_back(std::move(patch));
  }
  return item;
}

void Picture::add(const World& w) {
  Moment& m = moments_.emplace_back();
  std::size_t number = 0;
  double moving = 0;
  for (const Body b : w.bodies()) {
    const bool fixed = w[b].motion() != Motion::dynamic;
    const std::size_t before = m.items.size();
    for (const ShapeId s : w[b].shapes()) {
      const ShapeKind kind = w[s].shape().kind();
      if (kind == ShapeKind::half_space) {
        const Pose pose = w[s].pose();
        const Quatd q = convert<double>(pose.q);
        m.floors.push_back({{pose.p.x, pose.p.y, pose.p.z}, rotate(q, Vec3d{1, 0, 0}), rotate(q, Vec3d{0, 0, 1})});
      } else if (!is_hollow(kind)) {
        m.items.push_back(draw_shape(w[s], fixed, number));
      }
    }
    if (m.items.size() == before) continue;
    ++number;
    if (fixed) continue;
    const Pos p = w[b].center();
    m.middle += (Vec3d{p.x, p.y, p.z} - m.middle) * (1 / ++moving);
  }
  for (const Joint j : w.joints()) {
    std::vector<Pos> way{w[j].anchor_a(), w[j].anchor_b()};
    if (const Pulley* p = std::get_if<Pulley>(&w[j].definition())) way.insert(way.begin() + 1, {p->over_a, p->over_b});
    std::vector<Point>& seen = m.joints.emplace_back();
    for (const Pos& p : way) seen.push_back({view.x({p.x, p.y, p.z}), view.y({p.x, p.y, p.z})});
  }
  std::stable_sort(m.items.begin(), m.items.end(),
                   [](const Item& a, const Item& b) { return a.fixed != b.fixed ? a.fixed : a.depth > b.depth; });
}

struct Picture::Frame {
  static constexpr double width = 480, height = 260;  // of the paper
  double low_x = 1e300, high_x = -1e300, low_y = 1e300, high_y = -1e300;
  void include(const Point& p) {
    low_x = std::min(low_x, p.x), high_x = std::max(high_x, p.x);
    low_y = std::min(low_y, p.y), high_y = std::max(high_y, p.y);
  }
  bool sensible() const { return high_x - low_x >= 0 && high_x - low_x < 1e5 && high_y - low_y < 1e5; }
  double size() const { return std::max({high_x - low_x, (high_y - low_y) * width / height, 1e-6}) * 1.15; }
  Point place(const Point& p) const {
    const double scale = width / size();
    return {width / 2 + (p.x - (low_x + high_x) / 2) * scale, height / 2 + (p.y - (low_y + high_y) / 2) * scale};
  }
  std::string places(const std::vector<Point>& points) const {
    std::string all;
    for (const Point& p : points) {
      char text[64];
      std::snprintf(text, sizeof text, "%.1f,%.1f ", place(p).x, place(p).y);
      all += text;
    }
    return all;
  }
  std::string circle(const Point& at, const std::string& style) const {
    char text[64];
    std::snprintf(text, sizeof text, " r=\"3\" cx=\"%.1f\" cy=\"%.1f\"/>\n", place(at).x, place(at).y);
    return "<circle " + style + text;
  }
};

// All that moves, and what is fixed as far as that does not make it small.
Picture::Frame Picture::frame() const {
  Frame moving;
  for (const Moment& m : moments_) {
    for (const Item& i : m.items) {
      for (const Patch& p : i.patches) {
        for (const Point& q : p.outline) {
          if (!i.fixed) moving.include(q);
        }
      }
    }
    for (const std::vector<Point>& j : m.joints) {
      for (const Point& q : j) moving.include(q);
    }
  }
  Frame all = moving;
  const double more = moving.size() / 2;
  for (const Item& i : moments_.front().items) {
    for (const Patch& p : i.patches) {
      for (const Point& q : p.outline) {
        if (i.fixed)
          all.include({std::clamp(q.x, moving.low_x - more, moving.high_x + more),
                       std::clamp(q.y, moving.low_y - more, moving.high_y + more)});
      }
    }
  }
  return all;
}

std::string Picture::draw(const Item& item, const Frame& frame) {
  std::string s;
  Frame extent;
  for (const Patch& p : item.patches) {
    const std::string fill = "fill=\"" + item.colour + " " + std::to_string(int(30 + 40 * p.light)) + "%)\"";
    s += "<polygon " + fill + " points=\"" + frame.places(p.outline) + "\"/>\n";
    for (const Point& q : p.outline) extent.include(q);
  }
  // What is too small to be seen is a dot.
  const double most = std::max(extent.high_x - extent.low_x, extent.high_y - extent.low_y);
  if (item.fixed || item.patches.empty() || most > 0.012 * frame.size()) return s;
  return frame.circle({(extent.low_x + extent.high_x) / 2, (extent.low_y + extent.high_y) / 2},
                      "fill=\"" + item.colour + " 50%)\"");
}

std::string Picture::svg() const {
  const Frame seen = frame();
  if (!seen.sensible()) return "";
  char text[128];
  std::snprintf(text, sizeof text, "<svg class=\"scene\" viewBox=\"0 0 %.0f %.0f\" role=\"img\">\n", Frame::width,
                Frame::height);
  std::string s = text;
  // Planes seen nearly from the side or from behind would only hide what is there.
  const Vec3d middle = moments_.front().middle;
  for (const Floor& f : moments_.front().floors) {
    const Vec3d normal = cross(f.across, f.along);
    if (normal.y < 0.3) continue;
    const Vec3d at = middle - normal * dot(middle - f.at, normal), a = f.along * (seen.size() * 0.48),
                b = f.across * (seen.size() * 0.35);
    std::vector<Point> corners;
    for (const Vec3d& c : {at - a - b, at + a - b, at + a + b, at - a + b}) corners.push_back({view.x(c), view.y(c)});
    s += "<polygon class=\"floor\" points=\"" + seen.places(corners) + "\"/>\n";
  }
  for (const Moment& m : moments_) {
    s += &m == &moments_.back() ? "<g>\n" : "<g class=\"before\">\n";
    for (const Item& i : m.items) s += draw(i, seen);
    for (const std::vector<Point>& j : m.joints) {
      s += "<polyline class=\"joint\" points=\"" + seen.places(j) + "\"/>\n";
      s += seen.circle(j.back(), "class=\"joint\"");
    }
    s += "</g>\n";
  }
  return s + "</svg>\n";
}

}
