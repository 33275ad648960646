// MuJoCo's own compiler as the oracle: masses, centres, inertia, frames, axes and ranges of what it makes of a file,
// and how that moves where nothing touches. Debian's libmujoco-dev; files of shared/assets where they are, and small
// ones.
#include <mujoco/mujoco.h>

#include "unit/io/robot_files.h"

namespace sudar_test {
namespace {

struct Oracle {
  explicit Oracle(const std::filesystem::path& file) {
    std::array<char, 1000> error{};
    model = mj_loadXML(file.c_str(), nullptr, error.data(), int(error.size()));
    if (model == nullptr) throw Error("mujoco", error.data());
    data = mj_makeData(model);
    mj_forward(model, data);
  }
  ~Oracle() { mj_deleteData(data), mj_deleteModel(model); }
  Oracle(const Oracle&) = delete;
  std::string name(int kind, int i) const {
    const char* n = mj_id2name(model, kind, i);
    return n != nullptr ? n : "";
  }
  mjModel* model = nullptr;
  mjData* data = nullptr;
};

// z up → y up
Vec3d world(const mjtNum* v) { return {v[0], v[2], -v[1]}; }
Vec3d column(const mjtNum* m, int k) {
  const mjtNum c[3] = {m[k], m[3 + k], m[6 + k]};
  return world(c);
}

struct Whole {  // what is welded together, in the world
  double mass = 0;
  Vec3d center;
  Mat3d inertia{};
};
Whole together(const Whole& a, double mass, const Vec3d& center, const Mat3d& inertia) {
  const double sum = a.mass + mass;
  const Vec3d c = (a.center * a.mass + center * mass) / sum;
  const auto about = [&](const Mat3d& i, double m, const Vec3d& at) {
    const Vec3d d = at - c;
    return i + (Mat3d::identity() * dot(d, d) - Mat3d::outer(d, d)) * m;
  };
  return {sum, c, about(a.inertia, a.mass, a.center) + about(inertia, mass, center)};
}

void expect_near(const Vec3d& a, const Vec3d& b, double tolerance, const std::string& what) {
  EXPECT_LE(length(a - b), tolerance) << what << ": " << a.x << " " << a.y << " " << a.z << " instead of " << b.x << " "
                                      << b.y << " " << b.z;
}

// Of every body that moves.
void expect_same_bodies(const Oracle& o, const Model& model) {
  World w(model.config);
  const io::Built built = io::build(model, w);
  std::map<int, Whole> wholes;
  for (int b = 1; b < o.model->nbody; ++b) {
    const int root = o.model->body_weldid[b];
    if (root == 0 || o.model->body_mass[b] == 0) continue;
    Mat3d axes, inertia = Mat3d::diagonal(
                    {o.model->body_inertia[3 * b], o.model->body_inertia[3 * b + 1], o.model->body_inertia[3 * b + 2]});
    for (int k = 0; k < 3; ++k) axes[k] = column(o.data->ximat + 9 * b, k);
    inertia = axes * inertia * transpose(axes);
    wholes[root] = together(wholes[root], o.model->body_mass[b], world(o.data->xipos + 3 * b), inertia);
  }
  EXPECT_GT(wholes.size(), 0u);
  std::size_t moving = 0;
  for (const Body b : built.bodies) moving += w[b].motion() == Motion::dynamic;
  EXPECT_EQ(moving, wholes.size());
  for (const auto& [root, whole] : wholes) {
    const std::string name = o.name(mjOBJ_BODY, root);
    const Body b = w.find(name);
    ASSERT_FALSE(b.null()) << name;
    EXPECT_NEAR(double(w[b].mass()) / whole.mass, 1, 1e-6) << name;
    expect_near({w[b].pose().p.x, w[b].pose().p.y, w[b].pose().p.z}, world(o.data->xpos + 3 * root), 1e-6,
                name + " frame");
    for (int k = 0; k < 3; ++k) {
      Vec3 e;
      e[k] = 1;
      expect_near(convert<double>(rotate(w[b].pose().q, e)), column(o.data->xmat + 9 * root, k), 1e-6, name + " axes");
    }
    expect_near({w[b].center().x, w[b].center().y, w[b].center().z}, whole.center, 1e-6, name + " centre");
    const Mat3 inertia = w[b].inertia();
    for (int k = 0; k < 3; ++k) {
      expect_near(convert<double>(inertia[k]), whole.inertia[k], 1e-6 * trace(whole.inertia), name + " inertia");
    }
  }
}

// Of every hinge, slide and ball that is the only one between its bodies.
void expect_same_joints(const Oracle& o, const Model& model) {
  for (int j = 0; j < o.model->njnt; ++j) {
    const int b = o.model->jnt_bodyid[j], type = o.model->jnt_type[j];
    if (o.model->body_jntnum[b] != 1 || type == mjJNT_FREE) continue;
    const std::string name = o.name(mjOBJ_JOINT, j);
    const auto compare = [&](const auto& made) {
      expect_near({made.at.x, made.at.y, made.at.z}, world(o.data->xanchor + 3 * j), 1e-6, name + " anchor");
      if constexpr (requires { made.limit; }) {
        expect_near(convert<double>(made.axis), world(o.data->xaxis + 3 * j), 1e-6, name + " axis");
        const double start = o.model->qpos0[o.model->jnt_qposadr[j]];
        const bool limited = o.model->jnt_limited[j] != 0;
        EXPECT_EQ(std::isfinite(made.limit.low), limited) << name;
        if (!limited) return;
        EXPECT_NEAR(double(made.limit.low), o.model->jnt_range[2 * j] - start, 1e-6) << name;
        EXPECT_NEAR(double(made.limit.high), o.model->jnt_range[2 * j + 1] - start, 1e-6) << name;
      }
    };
    if (type == mjJNT_HINGE) compare(joint<Hinge>(model, name));
    if (type == mjJNT_SLIDE) compare(joint<Slider>(model, name));
    if (type == mjJNT_BALL) compare(joint<Ball>(model, name));
  }
}

void expect_same(const std::filesystem::path& file, const Oracle& oracle) {
  SCOPED_TRACE(file.string());
  const Reading reading = io::read(file);
  ASSERT_TRUE(reading.made) << text_of(reading, Severity::warning);
  expect_same_bodies(oracle, reading.model());
  expect_same_joints(oracle, reading.model());
}

TEST(Mujoco, ModelsOfOthersWeighAndHangTheSame) {
  const std::filesystem::path assets = SUDAR_ASSETS "/mjcf";
  if (!std::filesystem::exists(assets)) GTEST_SKIP() << "skipped: no ../shared/assets";
  int compared = 0;
  for (const char* folder : {"suite", "models"}) {
    for (const auto& entry : std::filesystem::directory_iterator(assets / folder)) {
      if (entry.path().extension() != ".xml") continue;
      try {
        const Oracle oracle(entry.path());
        expect_same(entry.path(), oracle);
        ++compared;
      } catch (const Error& e) { EXPECT_EQ(e.field, "mujoco"); }  // the file is newer than Debian's MuJoCo
    }
  }
  EXPECT_GE(compared, 12);
}

// What the files of others leave out. (Unless told to be exact, that MuJoCo takes the volume of this mesh to be 1.39
// times what it is.)
TEST(Mujoco, EveryWayOfSayingIsReadTheSame) {
  const Folder folder;
  const std::filesystem::path file = folder.write("all.xml", R"(<mujoco model="all">
    <compiler angle="radian" eulerseq="zyX" boundmass="0.01" settotalmass="20" autolimits="true" exactmeshinertia="true"/>
    <default>
      <geom density="700"/>
      <default class="big"><geom size="0.2"/><joint damping="1" range="-1 2"/>
        <default class="turned"><geom euler="0.1 0.2 0.3"/></default>
      </default>
    </default>
    <asset><mesh name="wedge" vertex="0 0 0  1 0 0  0 1 0  0 0 1" scale="0.1 0.2 0.3"/></asset>
    <worldbody>
      <geom type="plane" size="0 0 1"/>
      <body name="a" pos="1 2 3" euler="0.3 -0.2 0.5">
        <freejoint/>
        <geom type="box" size="0.1 0.2 0.3" class="turned"/>
        <geom type="ellipsoid" size="0.1 0.2 0.3" pos="0.5 0 0" axisangle="1 2 3 0.7" mass="2"/>
        <body name="b" pos="0 0.4 0" xyaxes="1 1 0 0 1 1" childclass="big">
          <joint name="b" axis="1 2 -1" pos="0.1 0 0" ref="0.2" range="-0.5 0.5"/>
          <geom/>
          <geom type="capsule" size="0.05" fromto="0 0 0 0.3 0.2 0.1"/>
          <geom type="cylinder" size="0.05 0.2" zaxis="1 1 -3"/>
          <geom type="box" size="0.05" fromto="0 0 0 0.3 0.2 -0.5"/>
          <body name="welded" pos="0.3 0 0" quat="1 2 3 4"><geom type="box" size="0.1 0.1 0.2" density="300"/></body>
          <body name="given" pos="0 0 1" zaxis="0 0 -1">
            <joint name="given" type="slide" axis="0 1 1" range="-1 1" ref="0.3"/>
            <inertial pos="0.1 0.2 0" quat="1 0 1 0" mass="3" diaginertia="0.1 0.2 0.25"/>
            <geom size="0.1"/>
            <body name="full"><joint name="full" type="ball" range="0 2" limited="false"/><inertial pos="0 0 0" mass="1" fullinertia="0.2 0.3 0.4 0.01 0.02 -0.03"/></body>
          </body>
        </body>
      </body>
      <body name="mesh" pos="3 0 0"><freejoint/><geom type="mesh" mesh="wedge" pos="0.1 0 0" euler="0.4 0 0"/></body>
    </worldbody>
  </mujoco>)");
  expect_same(file, Oracle(file));
}

// Where the bodies are after some time, in both.
void expect_same_motion(const Oracle& o, Model model, double seconds, double tolerance) {
  model.config.dt = 1e-3, model.config.substeps = 10, model.config.sleep = false;
  World w(model.config);
  io::build(model, w);
  o.model->opt.timestep = 1e-4, o.model->opt.integrator = mjINT_RK4;
  while (o.data->time < seconds - 1e-9) mj_step(o.model, o.data);
  mj_forward(o.model, o.data);
  while (w.time() < seconds - 1e-9) w.step();
  for (int b = 1; b < o.model->nbody; ++b) {
    const std::string name = o.name(mjOBJ_BODY, b);
    if (w.find(name).null()) continue;  // welded to another
    const Pos p = w[w.find(name)].pose().p;
    expect_near({p.x, p.y, p.z}, world(o.data->xpos + 3 * b), tolerance, name);
  }
  EXPECT_GT(mju_norm(o.data->qvel, o.model->nv), 0.02) << "nothing moves";
}

void expect_same_motion(const std::string& file, double seconds, double tolerance) {
  const Folder folder;
  const std::filesystem::path path = folder.write("moving.xml", file);
  const Reading reading = io::read(path);
  ASSERT_TRUE(reading.made) << text_of(reading, Severity::warning);
  EXPECT_EQ(text_of(reading, Severity::warning), "");
  expect_same_motion(Oracle(path), reading.model(), seconds, tolerance);
}

// Nothing touches, and nothing is limited, where the one engine is soft and the other not.
TEST(Mujoco, ModelsOfOthersMoveTheSame) {
  const std::filesystem::path assets = SUDAR_ASSETS "/mjcf/suite";
  if (!std::filesystem::exists(assets)) GTEST_SKIP() << "skipped: no ../shared/assets";
  for (const char* name : {"acrobot", "ball_in_cup", "cartpole", "cheetah", "hopper", "humanoid", "walker"}) {
    SCOPED_TRACE(name);
    const std::filesystem::path file = (assets / name).replace_extension(".xml");
    const Oracle oracle(file);
    oracle.model->opt.disableflags |= mjDSBL_CONTACT | mjDSBL_LIMIT;
    oracle.model->opt.gravity[0] = 2;  // some of them stand upright, and would go on standing
    Model model = io::read(file).model();
    std::get<Gravity>(model.forces.at(0).def).acceleration.x = 2;
    for (auto& b : model.bodies) {
      for (ShapeDef& s : b.def.shapes) s.filter = Filter{0, 0, 0};
    }
    for (auto& j : model.joints) {
      std::visit(
          [](auto& d) {
            if constexpr (requires { d.limit; }) d.limit = {};
          },
          j.def);
    }
    std::erase_if(model.joints, [](const auto& j) { return std::holds_alternative<Rope>(j.def); });
    expect_same_motion(oracle, model, 0.2, 1e-3);
  }
}

const char* const pendulum = "<geom type='capsule' size='0.05' fromto='0 0 0 0.3 0 1' mass='1'/>";

TEST(Mujoco, PendulumsSwingTheSame) {
  expect_same_motion(std::string("<mujoco><option><flag contact='disable'/></option><worldbody><body name='a' pos='0 0 "
                                 "2'><joint axis='0 1 0'/>") +
                         pendulum + "<body name='b' pos='0.3 0 1'><joint axis='0 1 0'/>" + pendulum +
                         "</body></body></worldbody></mujoco>",
                     1, 2e-4);
}

TEST(Mujoco, ACartWithAPoleMovesTheSame) {
  expect_same_motion(std::string("<mujoco><option><flag contact='disable'/></option><worldbody><body "
                                 "name='cart'><joint type='slide' axis='1 0 0'/>"
                                 "<geom type='box' size='.2 .1 .1' mass='1'/><body name='pole'><joint axis='0 1 0'/>") +
                         pendulum + "</body></body></worldbody></mujoco>",
                     1, 2e-4);
}

TEST(Mujoco, ABallJointMovesTheSame) {
  expect_same_motion(std::string("<mujoco><worldbody><body name='a'><joint type='ball'/>") + pendulum +
                         "<geom type='box' size='.1 .2 .05' pos='.3 .4 1' mass='.5'/></body></worldbody></mujoco>",
                     1, 2e-4);
}

// Springs, dampers and rotors of a single joint.
TEST(Mujoco, WhatActsAlongAJointMovesItTheSame) {
  for (const char* acts :
       {"damping='0.3' stiffness='4' springref='1'", "armature='0.4'", "frictionloss='0.3'",
        "damping='0.1' stiffness='4' springref='1' armature='0.2' ref='0.2'", "damping='0.3' frictionloss='0.5'"}) {
    SCOPED_TRACE(acts);
    for (const char* type : {"hinge", "slide"}) {
      expect_same_motion(std::string("<mujoco><compiler angle='radian'/><option gravity='1 0 -9.81'/><worldbody><body "
                                     "name='a'><joint axis='1 1 0' type='") +
                             type + "' " + acts + "/>" + pendulum + "</body></worldbody></mujoco>",
                         0.5, 1e-3);
    }
  }
}

// Between the same two bodies, without a body between them.
TEST(Mujoco, SeveralJointsOfABodyMoveTheSame) {
  const std::string load =
      std::string(pendulum) + "<geom type='box' size='.1 .2 .05' pos='.3 .4 1' mass='.5'/></body></worldbody></mujoco>";
  for (const char* joints :
       {"<joint axis='0 1 0'/><joint axis='1 0 0'/>",                               // they meet
        "<joint axis='0 1 0' pos='0 0 .08'/><joint axis='1 0 .5' pos='0 0 .04'/>",  // they are skew
        "<joint axis='1 0 0'/><joint axis='0 1 0'/><joint axis='0 0 1'/>",          // a ball
        "<joint axis='1 0 0'/><joint axis='0 0 1'/><joint axis='0 1 0'/>",          // the other way round
        "<joint type='slide' axis='1 0 0'/><joint type='slide' axis='0 0 1'/><joint axis='0 1 0'/>",  // in a plane
        "<joint axis='0 1 0'/><joint type='slide' axis='1 0 0'/><joint type='slide' axis='0 0 1'/>",  // the other way
                                                                                                      // round
        "<joint type='slide' axis='1 0 0'/><joint axis='0 1 0'/>",                                    // in a slot
        "<joint axis='0 1 0'/><joint type='slide' axis='0 0 1'/>",                                    // as a crane
        "<joint type='slide' axis='1 0 0'/><joint axis='1 0 0'/>",                                    // on a rod
        "<joint type='slide' axis='1 0 0'/><joint type='slide' axis='0 0 1'/>",                       // a gantry
        "<joint type='slide' axis='1 0 0'/><joint type='slide' axis='0 0 1'/><joint type='slide' axis='0 1 0'/>"
        "<joint axis='1 0 0'/><joint axis='0 1 0'/><joint axis='0 0 1'/>"}) {  // free
    SCOPED_TRACE(joints);
    for (const char* acts :
         {"", "<default><joint damping='.3' stiffness='4' springref='0.3' armature='.2'/></default>"}) {
      SCOPED_TRACE(acts);
      expect_same_motion(
          std::string(
              "<mujoco><compiler angle='radian'/><option gravity='2 1 -9.81'><flag contact='disable'/></option>") +
              acts + "<worldbody><body name='a'>" + joints + load,
          0.4, 1e-3);
    }
  }
  expect_same_motion(
      "<mujoco><worldbody><body name='a'><joint axis='0 1 0' pos='0 0 0'/><joint axis='0 1 0' pos='.3 0 .1'/>" + load,
      0.4, 1e-3);
}

}
}
