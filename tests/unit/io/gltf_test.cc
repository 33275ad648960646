// glTF with rigid bodies: what is made of it, and what is said of what is not.
#include "unit/io/files.h"

namespace sudar_test {
namespace {

// A document of one scene with these nodes, and more members of the root.
std::string gltf(const std::string& nodes, const std::string& physics = "{}", const std::string& more = "") {
  std::string roots;  // the nodes that nobody has as a child are told by "root"
  std::size_t i = 0;
  for (std::size_t at = nodes.find("\n{"); at != std::string::npos; at = nodes.find("\n{", at + 1), ++i) {
    if (nodes.compare(at, 8, "\n{\"name\"") == 0) roots += (roots.empty() ? "" : ",") + std::to_string(i);
  }
  return R"({"asset": {"version": "2.0"},
"scenes": [{"nodes": [)" +
         roots + R"(]}],
"nodes": [)" +
         nodes + R"(],
"extensions": {"KHR_physics_rigid_bodies": )" +
         physics + R"(,
"KHR_implicit_shapes": {"shapes": [
 {"type": "box", "box": {}}, {"type": "sphere", "sphere": {"radius": 0.5}},
 {"type": "cylinder", "cylinder": {"height": 2, "radiusBottom": 1, "radiusTop": 0}},
 {"type": "capsule", "capsule": {"height": 1, "radiusBottom": 0.5, "radiusTop": 0.25}},
 {"type": "plane"}]}})" +
         more + "}";
}
std::string body(const std::string& name, const std::string& physics, const std::string& more = "") {
  return "\n{\"name\": \"" + name + "\"" + more + ", \"extensions\": {\"KHR_physics_rigid_bodies\": " + physics + "}}";
}
const std::string box_0 = R"("collider": {"geometry": {"shape": 0}})";

class Gltf : public Files {
 protected:
  io::Model model(const std::string& text) const {
    const io::Reading r = read("a.gltf", text);
    if (!r.made) ADD_FAILURE() << text_of(r);
    return r.made.value_or(io::Model{});
  }
};

TEST_F(Gltf, VelocitiesAreTheNodes) {
  const std::string motion =
      R"({"motion": {"mass": 2, "linearVelocity": [0,0,1], "angularVelocity": [0,0,2], "gravityFactor": 0},)";
  const io::Model m = model(gltf(R"(
{"name": "up", "rotation": [0, 0.70710678, 0, 0.70710678], "translation": [1, 2, 3], "children": [1]},
{"scale": [2, 1, 1], "extensions": {"KHR_physics_rigid_bodies": )" +
                                 motion + box_0 + "}}}"));
  World w(m.config);
  const Body b = io::build(m, w).bodies.at(0);
  step(w, 60);
  expect_near(w[b].center(), Vec3d{2, 2, 3}, 1e-5);
  expect_near(w[b].spin(), Vec3d{2, 0, 0}, 1e-5);
  EXPECT_NEAR(w[b].mass(), 2, 1e-6);
  EXPECT_EQ(w[b].shape().vertices().size(), 8u);
  EXPECT_NEAR(w[b].shape().mass_properties().volume, 2, 1e-6);  // the scale widens the box
}

// Colliders belong to the nearest motion above them; without one they stand still.
TEST_F(Gltf, CompoundsAndObstacles) {
  const io::Model m = model(gltf(R"(
{"name": "car", "children": [1, 2], "extensions": {"KHR_physics_rigid_bodies": {"motion": {}}}},
{"translation": [-1, 0, 0], "extensions": {"KHR_physics_rigid_bodies": {)" +
                                 box_0 + R"(}}},
{"translation": [1, 0, 0], "extensions": {"KHR_physics_rigid_bodies": {)" +
                                 box_0 + R"(, "motion": {"isKinematic": true}}}},)" + body("wall", "{" + box_0 + "}")));
  ASSERT_EQ(m.bodies.size(), 3u);
  EXPECT_EQ(m.bodies[0].def.shapes.size(), 1u);
  EXPECT_EQ(m.bodies[0].def.motion, Motion::dynamic);
  EXPECT_EQ(m.bodies[1].def.motion, Motion::kinematic);
  EXPECT_EQ(m.bodies[2].def.motion, Motion::fixed);
  EXPECT_EQ(m.bodies[2].def.name, "wall");
}

TEST_F(Gltf, ShapesHaveTheirExactMass) {
  const auto mass = [&](int shape, const std::string& scale) {
    const io::Model m =
        model(gltf(body("b", R"({"motion": {}, "collider": {"geometry": {"shape": )" + std::to_string(shape) + "}}}",
                        ", \"scale\": " + scale)));
    World w(m.config);
    return w[io::build(m, w).bodies.at(0)].mass() / 1000;
  };
  EXPECT_NEAR(mass(1, "[1, 2, 3]"), pi / 6 * 6, 1e-5);  // an ellipsoid
  EXPECT_NEAR(mass(2, "[1, 1, 1]"), 2 * pi / 3, 1e-5);  // a cone
  EXPECT_NEAR(mass(2, "[1, 1, 0.5]"), pi / 3, 1e-5);    // on an ellipse
  // Two spheres' hull: a frustum between the circles where the sides touch, and two caps (G. Salmon's formula by
  // pieces).
  const double s = 0.25, cosine2 = 1 - s * s, r1 = 0.5, r2 = 0.25, h = 1;
  const double y1 = r1 * s, y2 = h + r2 * s, f1 = r1 * std::sqrt(cosine2), f2 = r2 * std::sqrt(cosine2);
  const double frustum = pi / 3 * (y2 - y1) * (f1 * f1 + f1 * f2 + f2 * f2);
  const double below = pi * square(r1 + y1) * (3 * r1 - (r1 + y1)) / 3,
               above = pi * square(r2 - r2 * s) * (3 * r2 - (r2 - r2 * s)) / 3;
  EXPECT_NEAR(mass(3, "[1, 1, 1]"), frustum + below + above, 1e-5);
}

TEST_F(Gltf, MassAsGiven) {
  const io::Model m =
      model(gltf(body("b", R"({"motion": {"mass": 3, "centerOfMass": [0.1, 0, 0], "inertiaDiagonal": [1, 2, 2.5],
    "inertiaOrientation": [0, 0, 0.70710678, 0.70710678]}, )" +
                               box_0 + "}")));
  World w(m.config);
  const Body b = io::build(m, w).bodies.at(0);
  EXPECT_NEAR(w[b].mass(), 3, 1e-6);
  EXPECT_NEAR(w[b].center().x, 0.1, 1e-6);
  EXPECT_NEAR(w[b].inertia().c0.x, 2, 1e-5);
  EXPECT_NEAR(w[b].inertia().c1.y, 1, 1e-5);
}

// The mass 0 is infinite: with one moment it turns about that axis alone, wherever it is pushed.
TEST_F(Gltf, InfiniteMassTurnsInPlace) {
  const io::Model m =
      model(gltf(body("wheel", R"({"motion": {"mass": 0, "inertiaDiagonal": [0, 1, 0]}, )" + box_0 + "}")));
  World w(m.config);
  w.add(Gravity{});
  const Body b = io::build(m, w).bodies.at(0);
  for (int i = 0; i < 60; ++i) w.push(b, {0, 0, 5}, w[b].center() + Vec3{1, 0, 0}), w.step();
  expect_near(w[b].center(), Vec3d{}, 1e-4);
  EXPECT_LT(w[b].spin().y, -1);
  EXPECT_NEAR(w[b].spin().x, 0, 1e-4);
}

// Who says nothing has no vote; two votes are decided by the order average, minimum, maximum, multiply.
TEST_F(Gltf, MaterialsCombine) {
  const auto ball = [](const std::string& name, int material, int x) {
    return body(name,
                R"({"motion": {}, "collider": {"geometry": {"shape": 1}, "physicsMaterial": )" +
                    std::to_string(material) + "}}",
                ", \"translation\": [" + std::to_string(x) + ", 9, 0]");
  };
  const io::Model m =
      model(gltf(ball("none", 0, 0) + "," + ball("max", 1, 2) + "," + ball("min", 2, 4) + "," + ball("product", 3, 6),
                 R"({"physicsMaterials": [{"restitution": 0.5}, {"restitution": 0.25, "restitutionCombine": "maximum"},
    {"restitution": 1, "restitutionCombine": "minimum"}, {"restitution": 0.1, "restitutionCombine": "multiply"}]})"));
  World w(m.config);
  const std::vector<Body> b = io::build(m, w).bodies;
  EXPECT_NEAR(w.pair_material(b[0], b[1]).restitution, 0.5, 1e-6);
  EXPECT_NEAR(w.pair_material(b[1], b[2]).restitution, 0.25, 1e-6);
  EXPECT_NEAR(w.pair_material(b[0], b[3]).restitution, 0.05, 1e-6);
  EXPECT_NEAR(w.pair_material(b[1], b[3]).restitution, 0.25, 1e-6);
}

// A hinge whose frames meet elsewhere: its lock is not at 0, its angle is that of the file.
TEST_F(Gltf, JointsAreInTheFilesCoordinates) {
  const std::string joint = R"({"physicsJoints": [{"limits": [{"linearAxes": [0], "min": 1, "max": 1},
    {"linearAxes": [1, 2], "min": 0, "max": 0}, {"angularAxes": [1, 2], "min": 0, "max": 0},
    {"angularAxes": [0], "min": -0.5, "max": 1.25}],
    "drives": [{"type": "angular", "mode": "acceleration", "axis": 0, "velocityTarget": 2, "damping": 1}]}]})";
  const io::Model m = model(gltf(R"(
{"name": "base", "extensions": {"KHR_physics_rigid_bodies": {"joint": {"connectedNode": 1, "joint": 0}}}},
{"name": "arm", "translation": [1, 0, 0], "rotation": [0.3826834, 0, 0, 0.9238795], "extensions": {"KHR_physics_rigid_bodies":
 {"motion": {"mass": 7, "gravityFactor": 0}, )" +
                                     box_0 + "}}}",
                                 joint));
  World w(m.config);
  const io::Built built = io::build(m, w);
  ASSERT_EQ(built.joints.size(), 1u);
  w.step();
  EXPECT_NEAR(w[built.joints[0]].coordinate(), pi / 4, 1e-3);  // it began to turn
  EXPECT_LT(w[built.joints[0]].gap(), 1e-5);
  step(w, 11);
  EXPECT_NEAR(w[built.bodies[0]].spin().x, 2 * (1 - std::exp(-0.2)), 5e-3);
  step(w, 400);
  EXPECT_NEAR(w[built.joints[0]].coordinate(), 1.25, 2e-3);
}

// A point on a line, which turns freely, is two planes.
TEST_F(Gltf, WaysWithoutTurns) {
  const io::Model m = model(gltf(
      R"(
{"name": "base", "extensions": {"KHR_physics_rigid_bodies": {"joint": {"connectedNode": 1, "joint": 0}}}},
{"name": "bead", "extensions": {"KHR_physics_rigid_bodies": {"motion": {"linearVelocity": [1, 0, 0], "angularVelocity": [0, 3, 0]}, )" +
          box_0 + "}}}",
      R"({"physicsJoints": [{"limits": [{"linearAxes": [1], "min": 0, "max": 0}, {"linearAxes": [2], "min": 0, "max": 0}]}]})"));
  World w(m.config);
  w.add(Gravity{});
  const io::Built built = io::build(m, w);
  EXPECT_EQ(built.joints.size(), 2u);
  step(w, 60);
  expect_near(w[built.bodies[0]].center(), Vec3d{1, 0, 0}, 1e-3);
  EXPECT_NEAR(w[built.bodies[0]].spin().y, 3, 1e-3);
}

TEST_F(Gltf, FiltersAreBits) {
  const auto filtered = [](const std::string& name, const std::string& filter) {
    return body(name, R"({"collider": {"geometry": {"shape": 1})" + filter + "}}");
  };
  const io::Model m = model(gltf(filtered("a", R"(, "collisionFilter": 0)") + "," +
                                     filtered("b", R"(, "collisionFilter": 1)") + "," + filtered("c", ""),
                                 R"({"collisionFilters": [{"collisionSystems": ["x"], "collideWithSystems": ["y"]},
    {"collisionSystems": ["y"], "notCollideWithSystems": ["y"]}]})"));
  const auto meet = [&](int i, int k) {
    const Filter a = *m.bodies[std::size_t(i)].def.shapes[0].filter, b = *m.bodies[std::size_t(k)].def.shapes[0].filter;
    return (a.category & b.mask) != 0 && (b.category & a.mask) != 0;
  };
  EXPECT_TRUE(meet(0, 1));
  EXPECT_FALSE(meet(1, 1));
  EXPECT_FALSE(meet(0, 2));
  EXPECT_TRUE(meet(1, 2));
  EXPECT_TRUE(meet(2, 2));
}

// An L of two bricks as one closed mesh, in a data URI: it falls as its hull with the mass of the L.
TEST_F(Gltf, MeshesThatFall) {
  const io::Reading own =
      read("a.gltf", gltf(body("b", R"({"motion": {}, "collider": {"geometry": {"node": 0}}})", ", \"mesh\": 0"), "{}",
                          R"(,
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], "accessors": [{"type": "VEC3", "componentType": 5126, "count": 4, "bufferView": 0}],
"bufferViews": [{"buffer": 0, "byteLength": 48}], "buffers": [{"byteLength": 48,
"uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/"}])"));
  // Four corners of a tetrahedron as one triangle and a rest: an open mesh.
  ASSERT_TRUE(own.made) << text_of(own);
  EXPECT_TRUE(says(own, "a.gltf:")) << text_of(own);
  EXPECT_TRUE(says(own, "open mesh")) << text_of(own);
}

struct Refused {
  const char *what, *text, *said;
};
TEST_F(Gltf, RefusesWithThePlace) {
  const std::string meshless = "\"meshes\": [{\"primitives\": [{\"attributes\": {\"POSITION\": 0}";
  const Refused cases[] = {
      {"no JSON", "{\n\"asset\": \n}", "a.gltf:3: error: is not JSON"},
      {"no object", "[]", "begins neither as GLB nor as a JSON object"},
      {"nothing", "", "is empty"},
      {"no version", "{}", "/asset/version: is left out"},
      {"old", R"({"asset": {"version": "1.0"}})", "only glTF 2 is read"},
      {"Draco", R"({"asset": {"version": "2.0"}, "extensionsRequired": ["KHR_draco_mesh_compression"]})",
       "export it without compression"},
      {"unknown need", R"({"asset": {"version": "2.0"},
"extensionsRequired": ["ACME_magic"]})",
       "a.gltf:2: error: /extensionsRequired/0: the file needs ACME_magic"},
      {"circle",
       R"({"asset": {"version": "2.0"}, "nodes": [{"children": [1]}, {"children": [0]}], "scenes": [{"nodes": [0]}]})",
       "is another's child"},
      {"type", R"({"asset": {"version": "2.0"}, "nodes": [{"translation": "up"}]})",
       "/nodes/0/translation: is string: an array of 3 numbers expected"},
      {"index", R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [7]}]})", "is 7, but there are 0 of them"},
  };
  for (const Refused& c : cases) {
    const io::Reading r = read("a.gltf", c.text);
    EXPECT_FALSE(r.made) << c.what;
    EXPECT_TRUE(says(r, c.said)) << c.what << ": " << text_of(r);
  }
}

TEST_F(Gltf, SaysWhatIsLeftOut) {
  const io::Reading r = read(
      "a.gltf",
      gltf(
          body("b",
               R"({"trigger": {"geometry": {"shape": 0}}, "motion": {}, "collider": {"geometry": {"shape": 4}}})") +
              "," + body("c", R"({"collider": {"geometry": {"shape": 0}}})"),
          "{}",
          R"(, "animations": [{"channels": [{"target": {"node": 1}}]}], "extensionsUsed": ["KHR_lights_punctual", "OMI_physics_body"])"));
  ASSERT_TRUE(r.made) << text_of(r);
  for (const char* what : {"triggers are not supported", "a plane on a body that falls", "animations are not played",
                           "OMI_physics_body is not read"}) {
    EXPECT_TRUE(says(r, what)) << what << "\n" << text_of(r);
  }
}

// Nothing is read outside the file's folder, by whatever way, unless it is allowed.
TEST_F(Gltf, StaysInItsFolder) {
  write("secret/s.bin", std::string(48, '\0'));
  const auto with = [&](const std::string& uri) {
    return gltf(body("b", R"({"collider": {"geometry": {"node": 0}}})", ", \"mesh\": 0"), "{}", R"(,
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], "accessors": [{"type": "VEC3", "componentType": 5126, "count": 4, "bufferView": 0}],
"bufferViews": [{"buffer": 0, "byteLength": 48}], "buffers": [{"byteLength": 48, "uri": ")" + uri + "\"}]");
  };
  std::filesystem::create_directories(folder / "in");
  std::filesystem::create_symlink(folder / "secret", folder / "in" / "link");
  for (const std::string& uri :
       {std::string("../secret/s.bin"), std::string("link/s.bin"), (folder / "secret/s.bin").string(),
        std::string("%2e%2e/secret/s.bin"), std::string("../secret/none.bin")}) {
    const io::Reading r = read("in/a.gltf", with(uri));
    EXPECT_TRUE(says(r, "lies outside the folder")) << uri << text_of(r);
  }
  EXPECT_TRUE(says(read("in/a.gltf", with("https://x.org/a.bin")), "lies on the network"));
  EXPECT_TRUE(says(read("in/a.gltf", with("none.bin")), "there is no file \"none.bin\""));
  const io::Reading allowed = read("in/a.gltf", with("../secret/s.bin"), {.allow = {folder / "secret"}});
  EXPECT_FALSE(says(allowed, "outside")) << text_of(allowed);
}

// What is written is read as the same.
TEST_F(Gltf, ThereAndBack) {
  io::Model m;
  m.config.friction_mix = m.config.restitution_mix = Mix::average;
  const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  m.bodies.push_back(
      {BodyDef{.shape = box({9, 1, 9}), .at = {0, -1, 0}, .motion = Motion::fixed, .name = "floor"}, {}, ""});
  m.bodies.push_back(
      {BodyDef{.shapes = {{.shape = hull(corners), .at = {0, 1, 0}}, {.shape = cone(1, 2), .density = Real(500)}},
               .at = {0, 3, 0},
               .velocity = {0, 0, 1},
               .material = {.restitution = Real(0.5)},
               .gravity_factor = Real(0.5),
               .name = "rock"},
       {},
       ""});
  m.bodies.push_back({BodyDef{.shape = ellipsoid({1, 2, 1}),
                              .at = {3, 3, 0},
                              .turn = rotation(Vec3{0, 0, 1}),
                              .spin = {1, 0, 0},
                              .filter = {.category = 2, .mask = 1}},
                      {},
                      ""});
  m.joints.push_back(
      {Hinge{.a = io::body_number(1),
              .b = io::body_number(2),
              .at = {2, 3, 0},
              .axis = {0, 1, 0},
              .limit = {-1, 2},
              .drive = {.mode = DriveMode::spring, .target = 1, .force = 3, .stiffness = 4, .damping = 5, .rate = 6}},
        {},
        "",
       {}});
  m.joints.push_back({Rope{.b = io::body_number(1), .at_a = {0, 9, 0}, .at_b = {0, 4, 0}, .length = 7}, {}, "", {}});
  m.forces.push_back({Gravity{}, {}, ""});
  std::vector<io::Finding> lost;
  for (const char* name : {"a.gltf", "a.glb"}) {
    const Bytes bytes = io::write(m, name, lost);
    const io::Reading r = read(name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    ASSERT_TRUE(r.made) << text_of(r);
    World a(m.config), b(r.made->config);
    const io::Built of_a = io::build(m, a), of_b = io::build(*r.made, b);
    ASSERT_EQ(of_b.bodies.size(), 3u);
    ASSERT_EQ(of_b.joints.size(), 2u);
    for (int i = 0; i < 30; ++i) a.step(), b.step();
    std::vector<std::string> names{"floor", "rock", ""};
    for (const Body body : of_a.bodies) {
      const Body other = a[body].name().empty() ? of_b.bodies[1] : b.find(a[body].name());
      expect_near(b[other].center(), a[body].center(), 1e-3);
      expect_near(b[other].spin(), a[body].spin(), 1e-2);
      EXPECT_NEAR(b[other].mass(), a[body].mass(), 1e-4 * a[body].mass());
    }
  }
  EXPECT_TRUE(lost.empty()) << io::text(lost.front());
}

}
}
