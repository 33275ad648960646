#include "bench/scenes.h"

#include <charconv>

namespace sudar::bench {

namespace {

class Random {  // splitmix64 (Steele, Lea, Flood 2014)
 public:
  double between(double low, double high) {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return low + (high - low) * double((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }
  Vec3d direction() {
    for (;;) {
      const Vec3d v{between(-1, 1), between(-1, 1), between(-1, 1)};
      if (length(v) > 0.01 && length(v) < 1) return normalize(v);
    }
  }
  Quatd turn() {
    for (;;) {
      const Quatd q{between(-1, 1), between(-1, 1), between(-1, 1), between(-1, 1)};
      if (length_squared(q) > 0.01 && length_squared(q) < 1) return normalize(q);
    }
  }

 private:
  std::uint64_t state_ = 1;
};

Solid block(const Vec3d& half) { return {.half = half}; }
Solid ball(double radius) { return {.kind = Solid::Kind::ball, .radius = radius}; }
Solid hull_of(std::vector<Vec3d> points) { return {.kind = Solid::Kind::hull, .points = std::move(points)}; }

std::uint32_t add(Scene& s, Solid solid) {
  s.solids.push_back(std::move(solid));
  return std::uint32_t(s.solids.size() - 1);
}
void add_fixed_block(Scene& s, const Vec3d& half, const Pos& at) {
  s.bodies.push_back({.solid = add(s, block(half)), .at = at, .motion = Motion::fixed});
}
void add_floor(Scene& s, double half) { add_fixed_block(s, {half, 1, half}, {0, -1, 0}); }

constexpr double light = 100;  // kg/m³: a unit cube has 100 kg

// Rows of unit cubes in the plane z, the lowest of `base` cubes, the first of which is half a metre right of `left`.
void add_pyramid(Scene& s, std::uint32_t cube, int base, double left, double z) {
  for (int row = 0; row < base; ++row) {
    for (int i = 0; row + i < base; ++i)
      s.bodies.push_back({.solid = cube, .at = {left + 0.5 * (row + 1) + i, row + 0.5, z}, .density = light});
  }
}

void build_pyramid(Scene& s, int base) {
  s.steps = 200, s.stands = true;
  add_floor(s, 400);
  add_pyramid(s, add(s, block({0.5, 0.5, 0.5})), base, -0.5 * base, 0);
}

void build_many_pyramids(Scene& s) {
  s.steps = 100, s.stands = true;
  constexpr int rows = 14, columns = 14, base = 10;
  constexpr double half = 0.5 * columns * (base + 1);
  add_floor(s, half);
  const std::uint32_t cube = add(s, block({0.5, 0.5, 0.5}));
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j)
      add_pyramid(s, cube, base, -half + j * (base + 1) + 0.5, 1 - half + i * 2 * (half - 1) / (rows - 1));
  }
}

void build_joint_grid(Scene& s) {
  s.steps = 100, s.stands = true;
  constexpr int n = 100;
  const std::uint32_t bead = add(s, ball(0.4));
  for (int k = 0; k < n; ++k) {
    for (int i = 0; i < n; ++i) {
      const auto b = std::uint32_t(s.bodies.size());
      const Pos at{double(k), -double(i), 0};
      s.bodies.push_back(
          {.solid = bead, .at = at, .motion = i == 0 ? Motion::fixed : Motion::dynamic, .collides = false});
      if (i == 0) continue;  // Box3D also joins the fixed ones to each other, which holds nothing
      s.joints.push_back({b - 1, b, at + Vec3d{0, 0.5, 0}});
      if (k > 0) s.joints.push_back({b - n, b, at - Vec3d{0.5, 0, 0}});
    }
  }
}

// The generator is that of PEEL (P. Terdiman), from which Box3D has the scene: its points are part of the scene.
std::vector<Vec3d> peel_points(int count, double radius) {
  std::uint32_t state = 42;
  const auto next = [&] {
    state = state * 2147001325u + 715136305u;
    return double(state & 0xffff) / 65535 - 0.5;
  };
  std::vector<Vec3d> points;
  while (int(points.size()) < count) {
    Vec3d p;
    p.x = next(), p.y = next(), p.z = next();
    if (length_squared(p) <= 0.25) points.push_back(radius * normalize(p));
  }
  return points;
}

void build_convex_column(Scene& s) {
  s.steps = 500;
  add_floor(s, 250);
  const std::uint32_t rock = add(s, hull_of(peel_points(32, 2)));
  for (int y = 0; y < 80; ++y) {
    for (int z = 0; z < 8; ++z) {
      for (int x = 0; x < 8; ++x)
        s.bodies.push_back({.solid = rock, .at = {4.0 * (x - 4), 2 + 4.0 * y, 4.0 * (z - 4)}});
    }
  }
}

// Four walls about the inner square of half width `inside`, from y = 0 up.
void add_walls(Scene& s, double inside, double half_height) {
  const double out = inside + 1, long_half = inside + 2;
  for (const double side : {-1.0, 1.0}) {
    add_fixed_block(s, {1, half_height, long_half}, {side * out, half_height, 0});
    add_fixed_block(s, {long_half, half_height, 1}, {0, half_height, side * out});
  }
}

void build_convex_pit(Scene& s) {
  s.steps = 300;
  constexpr int shapes = 64, side = 20, layers = 20;
  constexpr double width = 21.8, pitch = width / side;
  add_floor(s, 50);
  add_walls(s, 0.5 * width, 15);
  Random random;
  const auto first = std::uint32_t(s.solids.size());
  for (int i = 0; i < shapes; ++i) {
    std::vector<Vec3d> points;
    for (int k = 0; k < 12 + i % 9; ++k) points.push_back(0.5 * random.direction());
    add(s, hull_of(std::move(points)));
  }
  for (int y = 0; y < layers; ++y) {
    for (int z = 0; z < side; ++z) {
      for (int x = 0; x < side; ++x) {
        s.bodies.push_back({.solid = first + std::uint32_t(s.bodies.size()) % shapes,
                            .at = {(x + 0.5 - 0.5 * side) * pitch, 1 + 1.1 * y, (z + 0.5 - 0.5 * side) * pitch},
                            .turn = random.turn()});
      }
    }
  }
}

std::vector<Vec3d> fibonacci_lattice(int count, double radius) {
  const double step = 2 * pi / (0.5 * (1 + sqrt(5.0)));  // 2π / golden ratio
  std::vector<Vec3d> points;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2.0 * i + 1) / count, r = sqrt(1 - z * z);
    points.push_back(radius * Vec3d{r * cos(i * step), r * sin(i * step), z});
  }
  return points;
}

std::vector<Vec3d> column(int sides, double radius, double height) {  // stands on y = 0
  std::vector<Vec3d> points;
  for (int i = 0; i < sides; ++i) {
    const double x = radius * cos(2 * pi * i / sides), z = radius * sin(2 * pi * i / sides);
    points.push_back({x, 0, z});
    points.push_back({x, height, z});
  }
  return points;
}

// As in Box3D, the column that pushes begins 0.4 m deep in the rocks above it.
void build_junkyard(Scene& s) {
  s.steps = 500;
  add_floor(s, 120);
  for (const double side :
       {-1.0, 1.0}) {  // their feet are sunk by a metre, and they leave the corners open, as in Box3D
    add_fixed_block(s, {1, 8, 50}, {side * 50, 7, 0});
    add_fixed_block(s, {50, 8, 1}, {0, 7, side * 50});
  }
  const std::uint32_t rock = add(s, hull_of(fibonacci_lattice(10, 1.5)));
  for (int y = 0; y < 24; ++y) {
    for (int x = 0; x <= 20; ++x) {
      for (int z = 0; z <= 20; ++z)
        s.bodies.push_back({.solid = rock, .at = {4.0 * x - 40, 4.0 * y + 25, 4.0 * z - 40}});
    }
  }
  s.circle = {std::uint32_t(s.bodies.size()), 35, -6 * pi / 180};
  s.bodies.push_back(
      {.solid = add(s, hull_of(column(16, 4, 24))), .at = {s.circle->radius, 0, 0}, .motion = Motion::kinematic});
}

void build_large_world(Scene& s) {
  s.steps = 500;
  constexpr int tiles = 1000, balls = 100, interval = 5, balls_a_side = 10;
  constexpr double tile = 10, half_span = 0.5 * tile * tiles, usable = 0.8 * 2 * half_span;
  const std::uint32_t floor = add(s, block({0.5 * tile, 0.25, 0.5 * tile})), sphere = add(s, ball(0.5));
  for (int i = 0; i < tiles; ++i) {
    for (int j = 0; j < tiles; ++j) {
      s.bodies.push_back({.solid = floor,
                          .at = {(i + 0.5) * tile - half_span, 0, (j + 0.5) * tile - half_span},
                          .motion = Motion::fixed});
    }
  }
  const auto place = [&](int i) { return (i + 0.5) * usable / balls_a_side - 0.5 * usable; };
  for (int i = 0; i < balls; ++i) {
    s.bodies.push_back({.solid = sphere,
                        .at = {place(i % balls_a_side), 1.5, place(i / balls_a_side)},
                        .arrives = interval * (i + 1)});
  }
}

void build_tower(Scene& s, int cubes) {
  s.steps = 1000, s.stands = true;
  add_floor(s, 400);
  const std::uint32_t cube = add(s, block({0.5, 0.5, 0.5}));
  for (int i = 0; i < cubes; ++i) s.bodies.push_back({.solid = cube, .at = {0, i + 0.5, 0}, .density = light});
}

void build_pile(Scene& s, int boxes) {
  s.steps = 100;
  add_floor(s, 400);
  const std::uint32_t cube = add(s, block({0.5, 0.5, 0.5}));
  constexpr int layers = 16;
  int side = 1;
  while (side * side * layers < boxes) ++side;
  Random random;
  for (int i = 0; i < boxes; ++i) {
    const int x = i % side, z = i / side % side, y = i / side / side;
    const Quatd tilt{random.between(-0.04, 0.04), random.between(-0.04, 0.04), random.between(-0.04, 0.04), 1};
    s.bodies.push_back({.solid = cube,
                        .at = {1.25 * (x - 0.5 * (side - 1)), 0.6 + 1.2 * y, 1.25 * (z - 0.5 * (side - 1))},
                        .turn = normalize(tilt),
                        .density = light});
  }
}

void build_wall_unit(Scene& s) {
  s.steps = 300;
  add_floor(s, 400);
  const std::uint32_t brick = add(s, block({0.5, 0.25, 0.25})), shot = add(s, ball(0.5));
  for (int row = 0; row < 10; ++row) {
    for (int i = 0; i < 5; ++i)
      s.bodies.push_back({.solid = brick, .at = {i - 2.5 + 0.5 * (row % 2), 0.25 + 0.5 * row, 0}, .density = light});
  }
  s.bodies.push_back({.solid = shot, .at = {0, 2.5, 8}, .velocity = {0, 0, -15}, .density = 10 * light});
}

struct Family {  // of scenes called by its name and a number
  const char* name;
  void (*build)(Scene&, int);
};
constexpr Family families[] = {{"tower", build_tower}, {"pyramid", build_pyramid}, {"pile", build_pile}};

// "16k" is 16384. None: it is no number, or too large a one.
std::optional<int> parse_count(std::string_view text) {
  int unit = 1, count = 0;
  if (text.ends_with('k')) unit = 1024, text.remove_suffix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (error != std::errc{} || end != text.data() + text.size() || count < 1 || count > 1000000 / unit) return {};
  return count * unit;
}

bool build(Scene& s, std::string_view name) {
  if (name == "large_pyramid") return build_pyramid(s, 100), true;
  if (name == "many_pyramids") return build_many_pyramids(s), true;
  if (name == "joint_grid") return build_joint_grid(s), true;
  if (name == "convex_column") return build_convex_column(s), true;
  if (name == "convex_pit") return build_convex_pit(s), true;
  if (name == "junkyard") return build_junkyard(s), true;
  if (name == "large_world") return build_large_world(s), true;
  if (name == "wall_unit") return build_wall_unit(s), true;
  for (const Family& f : families) {
    if (!name.starts_with(f.name)) continue;
    const std::optional<int> count = parse_count(name.substr(std::string_view(f.name).size()));
    if (count) return f.build(s, *count), true;
  }
  return false;
}

}

Shape shape(const Solid& solid) {
  switch (solid.kind) {
    case Solid::Kind::box:
      return box(convert<Real>(2.0 * solid.half));
    case Solid::Kind::ball:
      return sphere(Real(solid.radius));
    case Solid::Kind::hull:
      break;
  }
  std::vector<Vec3> points;
  for (const Vec3d& p : solid.points) points.push_back(convert<Real>(p));
  return hull(points);
}

Vec3d velocity(const SceneCircle& c, int step) {
  const auto place = [&](int steps) {
    const double angle = c.rate * scene_dt * steps;
    return c.radius * Vec3d{cos(angle), 0, sin(angle)};
  };
  return (place(step + 1) - place(step)) / scene_dt;
}

std::span<const char* const> scene_names() {
  static constexpr const char* names[] = {"large_pyramid", "many_pyramids", "joint_grid", "convex_column", "convex_pit",
                                          "junkyard",      "large_world",   "pile1k",     "pile4k",        "pile16k",
                                          "pile64k",       "tower10",       "tower15",    "tower25",       "wall_unit"};
  return names;
}

Scene make_scene(std::string_view name) {
  Scene s{.name = std::string(name)};
  if (build(s, name)) return s;
  std::string known;
  for (const char* n : scene_names()) known += std::string(known.empty() ? "" : ", ") + n;
  throw Error(s.name, "is no scene; there is: " + known + ", and towerN, pyramidN, pileN");
}

}
