#include "unit/io/robot_files.h"

namespace sudar_test {
namespace {

const std::string link(const std::string& name, const std::string& mass = "1") {
  return "<link name='" + name + "'><inertial><origin xyz='0 0 0.5'/><mass value='" + mass +
         "'/><inertia ixx='0.1' ixy='0' ixz='0' iyy='0.1' iyz='0' izz='0.1'/></inertial>"
         "<collision><origin xyz='0 0 0.5'/><geometry><box size='0.1 0.1 1'/></geometry></collision></link>\n";
}
const std::string joint_of(const std::string& name, const std::string& type, const std::string& parent,
                           const std::string& child,
                           const std::string& more = "<limit lower='-1' upper='2' effort='5' velocity='1'/>") {
  return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent + "'/><child link='" + child +
         "'/><origin xyz='0 0 1' rpy='0 0 1.5707963267948966'/><axis xyz='0 1 0'/>" + more + "</joint>\n";
}

TEST(Urdf, JointsHaveTheirPlaceAxisRangeAndDamping) {
  const Reading r =
      read_urdf("<link name='world'/>" + link("a") +
                joint_of("j", "revolute", "world", "a",
                         "<limit lower='-1' upper='2' effort='5' velocity='1'/><dynamics damping='0.5'/>"));
  ASSERT_TRUE(r.made) << text_of(r, Severity::warning);
  EXPECT_EQ(text_of(r, Severity::warning), "");
  const Hinge& h = joint<Hinge>(r.model(), "j");
  EXPECT_TRUE(h.a.null());
  EXPECT_NEAR(h.at.y, 1, 1e-9);
  EXPECT_NEAR(double(h.axis.x), -1, 1e-6);  // y, turned by 90° about z
  EXPECT_NEAR(double(h.limit.low), -1, 1e-6);
  EXPECT_NEAR(double(h.limit.high), 2, 1e-6);
  EXPECT_NEAR(double(h.drive.damping), 0.5, 1e-6);
}

TEST(Urdf, LinksThatAreFixedAreOneBody) {
  const Reading r = read_urdf(link("a") + link("b", "3") + joint_of("j", "fixed", "a", "b"));
  ASSERT_TRUE(r.made) << text_of(r, Severity::warning);
  ASSERT_EQ(r.model().bodies.size(), 1u);
  const BodyDef& b = r.model().bodies[0].def;
  EXPECT_NEAR(double(b.mass), 4, 1e-6);
  EXPECT_NEAR(double(b.center->z), (1 * 0.5 + 3 * 1.5) / 4, 1e-6);
  EXPECT_NEAR(double(b.inertia->c0.x), 0.2 + 0.75, 1e-5);  // reduced mass 3/4 kg, 1 m apart
  EXPECT_EQ(b.shapes.size(), 2u);
}

// As ROS makes a base that drives in a plane: links without mass that slide, slide and turn.
TEST(Urdf, ALinkWithoutMassGivesItsJointToWhatItCarries) {
  const Reading r =
      read_urdf("<link name='world'/><link name='x'/><link name='y'/>" + link("base") +
                "<joint name='jx' type='prismatic'><parent link='world'/><child link='x'/><axis xyz='1 0 0'/><limit "
                "lower='-9' upper='9' effort='1' velocity='1'/></joint>"
                "<joint name='jy' type='prismatic'><parent link='x'/><child link='y'/><axis xyz='0 1 0'/><limit "
                "lower='-9' upper='9' effort='1' velocity='1'/></joint>"
                "<joint name='jt' type='continuous'><parent link='y'/><child link='base'/><axis xyz='0 0 1'/></joint>");
  ASSERT_TRUE(r.made) << text_of(r, Severity::warning);
  EXPECT_EQ(r.model().bodies.size(), 1u);
  EXPECT_EQ(count<sudar::Plane>(r.model()), 3);
  World w(r.model().config);
  const io::Built built = io::build(r.model(), w);
  w.set_velocity(built.bodies[0], {1, 0, 2}, {0, 3, 0});
  for (int i = 0; i < 60; ++i) w.step();
  EXPECT_NEAR(w[built.bodies[0]].pose().p.y, 0, 1e-4);  // it does not fall
  EXPECT_NEAR(double(w[built.bodies[0]].spin().y), 3, 1e-3);
}

TEST(Urdf, WhatIsMissingOrUnknownIsToldAndTheRestIsRead) {
  const Reading r = read_urdf(
      "<link name='a'><inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1'/></inertial>\n"
      "<collision><geometry>\n<mesh filename='package://none/a.stl'/></geometry></collision>\n</link>\n<sensor/>");
  ASSERT_TRUE(r.made);
  EXPECT_TRUE(says(r,
                   "file.urdf:4: warning: mesh filename: the mesh \"package://none/a.stl\" is left out: there is "
                   "no package \"none\""))
      << text_of(r, Severity::warning);
  EXPECT_TRUE(says(r, "file.urdf:6: warning: sensor"));
  EXPECT_TRUE(says(read_urdf(link("a") + link("b") + link("c") + joint_of("j", "continuous", "a", "b") +
                             joint_of("k", "continuous", "a", "c", "<mimic joint='j'/>")),
                   "follows another joint"));
}

TEST(Urdf, MeshesLieInPackages) {
  const Folder folder;
  folder.write("robot/package.xml", "<package/>");
  folder.write("robot/meshes/part.obj", tetrahedron_obj);
  const std::string text =
      "<robot name='r'><link name='a'><inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1'/></inertial>"
      "<collision><geometry><mesh filename='package://NAME/meshes/part.obj' scale='0.5 0.5 "
      "-0.5'/></geometry></collision></link></robot>";
  for (const std::string name : {"robot", "called_otherwise"}) {
    std::string own = text;
    const Reading r = io::read(folder.write("robot/a.urdf", own.replace(own.find("NAME"), 4, name)));
    ASSERT_TRUE(r.made) << name;
    EXPECT_EQ(text_of(r, Severity::warning), "") << name;
    EXPECT_NEAR(body(r.model(), "a").shapes[0].shape.mass_properties().volume, 1. / 48, 1e-6);
    EXPECT_LT(double(body(r.model(), "a").shapes[0].shape.mass_properties().center.z), 0);
  }
}

TEST(Urdf, AnInertiaOfNoBodyIsReplacedAndTold) {
  const Reading r =
      read_urdf("<link name='a'><inertial><mass value='1'/><inertia ixx='3' iyy='1' izz='1'/></inertial></link>");
  ASSERT_TRUE(r.made);
  EXPECT_TRUE(says(r, "an inertia of no body"));
  EXPECT_NEAR(double(r.model().bodies[0].def.inertia->c0.x), 5. / 3, 1e-6);
}

TEST(Urdf, WhatIsNoTreeIsRefusedWithItsLine) {
  const auto refused = [](const Reading& r, const std::string& words) {
    EXPECT_FALSE(r.made);
    EXPECT_NE(text_of(r, Severity::error).find(words), std::string::npos)
        << text_of(r, Severity::warning) << "instead of " << words;
  };
  refused(read_urdf(link("a") + link("b")), "file.urdf:3: error: link \"b\": is a second root");
  refused(read_urdf(link("a") + link("a")), "file.urdf:3: error: link \"a\": there are two links");
  refused(read_urdf(link("a") + joint_of("j", "fixed", "a", "b")),
          "file.urdf:3: error: child link: there is no link \"b\"");
  refused(read_urdf(link("a") + link("b") + joint_of("j", "fixed", "a", "b") + joint_of("k", "fixed", "b", "a")),
          "go round in a circle");
  refused(read_urdf(link("c") + link("a") + link("b") + joint_of("j", "fixed", "a", "b") +
                    joint_of("k", "fixed", "b", "a")),
          "hangs on a circle");
  refused(read_urdf(link("a") + link("b") + joint_of("j", "hinge", "a", "b")), "must be revolute");
  refused(read_urdf(link("a") + link("b") + joint_of("j", "revolute", "a", "b", "")), "needs an element \"limit\"");
  refused(read_urdf(link("a", "-1")), "mass value: is -1, must be at least 0");
  refused(read_urdf(link("a", "nan")), "\"nan\" is no number");
  refused(read_urdf(""), "has no link");
  refused(read_urdf("<xacro:macro name='m'/>"), "is xacro");
  refused(read_text(".xacro", "<robot/>"), "is xacro");
}

}
}
