// XML that is broken in every way is refused with a line, and soon.
#include "unit/io/robot_files.h"
#include "unit/random.h"

namespace sudar_test {
namespace {

void refused(const std::string& text, const std::string& words) {
  const Reading r = read_text(".xml", text);
  EXPECT_FALSE(r.made) << text;
  EXPECT_NE(text_of(r, Severity::error).find(words), std::string::npos)
      << text_of(r, Severity::warning) << "instead of " << words;
}

TEST(Xml, WhatIsBrokenIsNamedByItsLine) {
  refused("", "has no element");
  refused("mujoco", "is no XML");
  refused("<mujoco>\n<a>\n</b></mujoco>", "file.xml:3: error: \"a\" of line 2 should end here");
  refused("<mujoco>\n<a", "file.xml:2");
  refused("<mujoco><a x=1/></mujoco>", "value in quotes");
  refused("<mujoco><a x='1' x='2'/></mujoco>", "twice");
  refused("<mujoco><a x='&bomb;'/></mujoco>", "entity is not known");
  refused("<mujoco/><mujoco/>", "follows the end");
  refused("<!DOCTYPE m [<!ENTITY a 'aaaa'><!ENTITY b '&a;&a;&a;'>]><mujoco/>", "entities");
  refused(std::string("<mujoco>\0</mujoco>", 18), "zero byte");
  refused("\xff\xfe<", "UTF-16");
  std::string deep = "<mujoco><worldbody>";
  for (int i = 0; i < 100'000; ++i) deep += "<body>";
  refused(deep, "deeper in each other than");
}

TEST(Xml, WhatIsAllowedIsRead) {
  const Reading r = read_text(
      ".xml",
      "\xef\xbb\xbf<?xml version=\"1.0\"?>\n<!DOCTYPE mujoco>\n<!-- <a> -->\n<mujoco model='&lt;&#65;&#x42;&amp;'>"
      "text <![CDATA[ <b> ]]><worldbody >\n<geom\n size = '1'\n/></worldbody></mujoco>\n<!-- end -->\n");
  ASSERT_TRUE(r.made) << text_of(r, Severity::warning);
  EXPECT_EQ(r.model().name, "<AB&");
  EXPECT_EQ(r.model().bodies.size(), 1u);
}

// A file is either read, and can be built, or refused with an error; it never throws.
TEST(Xml, DamagedFilesAreReadOrRefused) {
  const std::string whole =
      R"(<mujoco model="m"><compiler angle="radian"/><default><geom size="0.1" density="500"/><default class="c"><joint damping="1" range="-1 1"/></default></default>
<worldbody><geom type="plane" size="1 1 1"/><body name="a" pos="0 0 1" euler="0.1 0.2 0.3"><freejoint/><geom/><body name="b" childclass="c" pos="0.3 0 0"><joint name="j" axis="0 1 0" ref="0.1"/>
<joint axis="1 0 0"/><geom type="capsule" fromto="0 0 0 0.1 0.2 0.3"/><site name="s"/></body></body></worldbody><actuator><position joint="j" kp="3"/></actuator>
<tendon><spatial range="0 1"><site site="s"/></spatial></tendon><equality><connect body1="a" anchor="0 0 0"/></equality><contact><exclude body1="a" body2="b"/></contact></mujoco>)";
  ASSERT_TRUE(read_text(".xml", whole).made);
  Random random(1);
  int made = 0, bad = 0;
  for (int i = 0; i < 200; ++i) {
    std::string text = whole;
    if (i % 3 == 0) text.resize(std::size_t(random.whole(0, int(text.size()) - 1)));
    for (int k = 0; k < 1 + i % 4 && !text.empty(); ++k) {
      const auto at = std::size_t(random.whole(0, int(text.size()) - 1));
      text[at] = i % 2 == 0 ? char(text[at] ^ char(1 << random.whole(0, 7)))
                            : "0123456789-.e\"<> /"[std::size_t(random.whole(0, 17))];
    }
    const Reading r = read_text(".xml", text);
    (r.made ? made : bad) += 1;
    EXPECT_NE(r.made.has_value(), text_of(r, Severity::error) != "") << text;
  }
  EXPECT_GT(made, 5);
  EXPECT_GT(bad, 50);
}

}
}
