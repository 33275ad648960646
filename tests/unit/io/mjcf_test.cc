#include "unit/io/robot_files.h"

namespace sudar_test {
namespace {

const char* const ball = "<freejoint/><geom size='0.1'/>";

TEST(Mjcf, DefaultClassesAreInheritedAndOverridden) {
  const Reading r = read_mjcf(R"(<default><geom density='500'/><default class='small'><geom size='0.1'/>
      <default class='light'><geom density='100'/></default></default></default>
    <worldbody><body name='a' childclass='small'><freejoint/><geom/></body>
      <body name='b' childclass='small'><freejoint/><geom class='light'/></body></worldbody>)");
  ASSERT_TRUE(r.made) << text_of(r, Severity::warning);
  EXPECT_EQ(text_of(r, Severity::warning), "");
  const double volume = 4 * pi / 3 * 1e-3;
  EXPECT_NEAR(double(body(r.model(), "a").mass), 500 * volume, 1e-5);
  EXPECT_NEAR(double(body(r.model(), "b").mass), 100 * volume, 1e-6);
}

TEST(Mjcf, WorldIsTurnedSoThatYIsUp) {
  const Reading r = read_mjcf(std::string("<worldbody><body name='a' pos='1 2 3'>") + ball + "</body></worldbody>");
  const Pos p = body(r.model(), "a").at;
  EXPECT_NEAR(p.x, 1, 1e-12);
  EXPECT_NEAR(p.y, 3, 1e-12);
  EXPECT_NEAR(p.z, -2, 1e-12);
  EXPECT_NEAR(double(std::get<Gravity>(r.model().forces[0].def).acceleration.y), -9.81, 1e-6);
}

TEST(Mjcf, APlaneIsAFloor) {
  const Reading r =
      read_mjcf(std::string("<worldbody><geom type='plane' size='1 1 1' pos='0 0 0.5'/><body name='a' pos='0 0 1'>") +
                ball + "</body></worldbody>");
  ASSERT_TRUE(r.made) << text_of(r);
  World w(r.model().config);
  io::build(r.model(), w);
  step(w, 1000);
  EXPECT_NEAR(w[w.find("a")].pose().p.y, 0.6, 0.01);
}

TEST(Mjcf, MeshesAreScaledAndWeighWhatTheyEnclose) {
  const Folder folder;
  folder.write("assets/part.obj", tetrahedron_obj);
  const Reading r = io::read(folder.write("a.xml", R"(<mujoco><compiler meshdir='assets'/>
    <default><mesh scale='2 1 1'/></default><asset><mesh file='part.obj'/><mesh name='gone' file='gone.stl'/></asset>
    <worldbody><body name='a'><freejoint/><geom type='mesh' mesh='part' density='600'/><geom type='mesh' mesh='gone'/></body></worldbody></mujoco>)"));
  ASSERT_TRUE(r.made) << text_of(r);
  EXPECT_NEAR(double(body(r.model(), "a").mass), 600 * 2. / 6, 1e-4);
  EXPECT_NEAR(double(body(r.model(), "a").center->x), 0.5, 1e-6);
  EXPECT_TRUE(says(r, "a.xml:2: warning: mesh \"gone\" file: the mesh is left out: there is no file"));
}

TEST(Mjcf, GravityFactorsAndControlsAtTheStart) {
  const Reading r = read_mjcf(
      R"(<worldbody><body name='a' gravcomp='1'><joint name='j' axis='0 1 0'/><geom size='0.1' pos='0 0 1'/></body></worldbody>
    <actuator><velocity joint='j' kv='2' gear='4' ctrlrange='3 5'/></actuator>)");
  ASSERT_TRUE(r.made) << text_of(r);
  EXPECT_NEAR(double(body(r.model(), "a").gravity_factor), 0, 1e-9);
  const Drive& d = joint<Hinge>(r.model(), "j").drive;
  EXPECT_NEAR(double(d.damping), 2 * 16, 1e-5);
  EXPECT_NEAR(double(d.rate), 3. / 4, 1e-6);
}

TEST(Mjcf, FiltersArePairsThatMayTouch) {
  const Reading r = read_mjcf(R"(<worldbody>
      <body name='a' pos='0 0 1'><freejoint/><geom size='0.1' contype='1' conaffinity='0'/></body>
      <body name='b' pos='0 0 1.1'><freejoint/><geom size='0.1' contype='1' conaffinity='0'/></body>
      <body name='c' pos='5 0 1'><freejoint/><geom size='0.1'/></body>
      <body name='d' pos='5 0 1.1'><freejoint/><geom size='0.1'/></body>
      <body name='e' pos='9 0 1'><freejoint/><geom size='0.1'/></body>
      <body name='f' pos='9 0 1.1'><freejoint/><geom size='0.1'/></body>
    </worldbody><contact><exclude body1='c' body2='d'/></contact>)");
  ASSERT_TRUE(r.made) << text_of(r, Severity::warning);
  World w(r.model().config);
  io::build(r.model(), w);
  w.step();
  EXPECT_FALSE(w.touching(w.find("a"), w.find("b")));  // neither's contype is in the other's conaffinity
  EXPECT_FALSE(w.touching(w.find("c"), w.find("d")));  // excluded
  EXPECT_TRUE(w.touching(w.find("e"), w.find("f")));
}

TEST(Mjcf, PositionActuatorsAreSprings) {
  const Reading r = read_mjcf(
      R"(<worldbody><body><joint name='j' axis='0 1 0' stiffness='2' springref='90'/><geom size='0.1' pos='0 0 1'/></body></worldbody>
    <actuator><position joint='j' kp='6' kv='3' ctrlrange='1 2'/></actuator>)");
  ASSERT_TRUE(r.made) << text_of(r, Severity::warning);
  const Drive& d = joint<Hinge>(r.model(), "j").drive;
  EXPECT_EQ(d.mode, DriveMode::spring);
  EXPECT_NEAR(double(d.stiffness), 8, 1e-6);
  EXPECT_NEAR(double(d.damping), 3, 1e-6);
  EXPECT_NEAR(double(d.target), (2 * pi / 2 + 6 * 1) / 8, 1e-6);  // control 0 is clamped to 1
}

TEST(Mjcf, TiesAndTendons) {
  const Reading r =
      read_mjcf(std::string(R"(<worldbody><site name='top' pos='0 0 2'/><body name='a'><site name='s'/>)") + ball +
                "</body><body name='b' pos='1 0 0'>" + ball + R"(</body></worldbody>
    <tendon><spatial name='string' limited='true' range='0 2.5'><site site='top'/><site site='s'/></spatial></tendon>
    <equality><weld body1='a' body2='b'/><connect body1='b' anchor='0.5 0 0'/></equality>)");
  ASSERT_TRUE(r.made) << text_of(r, Severity::warning);
  EXPECT_NEAR(double(joint<Rope>(r.model(), "string").length), 2.5, 1e-6);
  EXPECT_EQ(count<Fixed>(r.model()), 1);
  EXPECT_NEAR(joint<Ball>(r.model(), "").at.x, 1.5, 1e-6);
}

TEST(Mjcf, WhatIsNotSupportedIsNamedByItsLineAndTheRestIsRead) {
  const Reading r = read_mjcf(
      std::string("<option density='1.2'/>\n<worldbody>\n<geom type='hfield' hfield='h'/>\n<flexcomp/>\n<body>") +
      ball + "</body></worldbody>\n<extension/>\n");
  ASSERT_TRUE(r.made);
  EXPECT_EQ(r.model().bodies.size(), 1u);
  for (const char* words : {"file.xml:2: warning: option density", "file.xml:4: warning: geom type",
                            "file.xml:5: warning: flexcomp", "file.xml:7: warning: extension"}) {
    EXPECT_TRUE(says(r, words)) << words << "\n" << text_of(r, Severity::warning);
  }
  EXPECT_TRUE(says(read_mjcf("<worldbody><geom size='1' colour='red'/></worldbody>"), "\"colour\" is not known"));
}

TEST(Mjcf, BadFilesAreRefusedWithTheirLine) {
  const auto refused = [](const std::string& inside, const std::string& words) {
    const Reading r = read_mjcf(inside);
    EXPECT_FALSE(r.made) << inside;
    EXPECT_NE(text_of(r, Severity::error).find(words), std::string::npos)
        << text_of(r, Severity::warning) << "instead of " << words;
  };
  refused("<worldbody>\n<geom size='nan'/></worldbody>", "file.xml:3: error: geom size: \"nan\" is no number");
  refused("<worldbody>\n<geom size='1e999'/></worldbody>", "file.xml:3");
  refused("<worldbody><geom size='-1'/></worldbody>", "must be positive");
  refused("<worldbody><geom type='cube' size='1'/></worldbody>", "must be one of plane, sphere");
  refused("<worldbody><geom class='none' size='1'/></worldbody>", "there is no class of defaults \"none\"");
  refused("<worldbody><body><joint axis='0 0 0'/><geom size='1'/></body></worldbody>", "has no direction");
  refused("<worldbody><body name='a'/><body name='a'/></worldbody>", "two elements of that name");
  refused("<actuator>\n<motor joint='j'/></actuator>", "file.xml:3: error: motor joint: there is no joint \"j\"");
  refused("<include file='file.xml'/>", "included for the second time");
  refused("<include file='../../etc/passwd'/>", "outside the folder");
  refused("<compiler coordinate='global'/>", "global coordinates");
  refused("<worldbody><replicate count='1000000'><replicate count='1000000'/></replicate></worldbody>",
          "more than 1000000");
}

TEST(Mjcf, IncludesAndAttachedModelsLieWhereTheFileIs) {
  const Folder folder;
  folder.write("parts/leg.xml",
               "<mujoco><default><geom size='0.2'/></default><worldbody><body "
               "name='leg'><freejoint/><geom/></body></worldbody></mujoco>");
  folder.write("common.xml", "<mujocoinclude><option timestep='0.01'/></mujocoinclude>");
  const Reading r = io::read(folder.write("main.xml", R"(<mujoco><include file='common.xml'/>
    <asset><model name='leg' file='parts/leg.xml'/></asset>
    <worldbody><replicate count='12' offset='1 0 0' sep='-'><attach model='leg' body='leg' prefix='x_'/></replicate></worldbody></mujoco>)"));
  ASSERT_TRUE(r.made) << text_of(r, Severity::warning);
  EXPECT_DOUBLE_EQ(r.model().config.dt, 0.01);
  EXPECT_EQ(r.model().bodies.size(), 12u);
  EXPECT_NEAR(body(r.model(), "x_leg-11").at.x, 11, 1e-9);
}

}
}
