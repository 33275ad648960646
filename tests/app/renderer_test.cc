// Pictures are compared by what is seen where (ids) and by mean colours, never pixel by pixel: drivers differ.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>

#include "view/offscreen.h"
#include "view/palette.h"

using namespace sudar;
using namespace sudar::view;

namespace {

constexpr int width = 320, height = 180;

// A red box left, a green ball in the middle, a blue capsule right, on a floor; seen from the front.
Scene three_bodies() {
  Scene scene;
  add_instance(scene, half_space(), {.fixed = true});
  const auto put = [&](const Shape& shape, double x, const Vec3f& colour) {
    add_instance(scene, shape, {.pose = {{x, 1, 0}, {}}, .colour = colour});
  };
  put(box({2, 2, 2}), -4, {0.6f, 0.05f, 0.05f});
  put(sphere(1), 0, {0.05f, 0.5f, 0.05f});
  put(capsule(0.5, 1), 4, {0.05f, 0.05f, 0.6f});
  return scene;
}

Camera front() { return {.eye = {0, 2, 14}, .target = {0, 1, 0}}; }

std::map<std::uint32_t, int> count(const IdImage& image) {
  std::map<std::uint32_t, int> pixels;
  for (const std::uint32_t id : image.ids) ++pixels[id];
  return pixels;
}

struct Mean {
  double red = 0, green = 0, blue = 0;
};
Mean mean_colour(const Image& image, const IdImage& ids, std::uint32_t id) {
  Mean mean;
  int pixels = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (ids.at(x, y) != id) continue;
      const std::uint8_t* p = image.pixel(x, y);
      mean.red += p[0], mean.green += p[1], mean.blue += p[2];
      ++pixels;
    }
  }
  return {mean.red / pixels, mean.green / pixels, mean.blue / pixels};
}

int brightness(const Image& image, int x, int y) {
  const std::uint8_t* p = image.pixel(x, y);
  return int(p[0]) + p[1] + p[2];
}

struct Drawing : testing::Test {
  Offscreen offscreen;
  Scene scene = three_bodies();
};

TEST_F(Drawing, EveryBodyIsSeenWhereItIs) {
  const IdImage ids = offscreen.ids(scene, front(), width, height);
  const auto pixels = count(ids);
  ASSERT_EQ(pixels.size(), 4u) << "background and three bodies";
  // The ball of radius 1 at distance 14: a disk of radius 90 / tan(0.35) / 14 = 17.6 pixels, 974 in area.
  EXPECT_NEAR(pixels.at(3), 974, 60);
  EXPECT_EQ(ids.at(width / 2, height / 2), 3u);
  EXPECT_EQ(ids.at(width / 2 - 70, height / 2), 2u);
  EXPECT_EQ(ids.at(width / 2 + 70, height / 2), 4u);
}

TEST_F(Drawing, IdsAreTheSameAgain) {
  EXPECT_EQ(offscreen.ids(scene, front(), width, height).ids, offscreen.ids(scene, front(), width, height).ids);
}

TEST_F(Drawing, BodiesHaveTheirColours) {
  const Image image = offscreen.picture(scene, front(), {}, width, height);
  const IdImage ids = offscreen.ids(scene, front(), width, height);
  const Mean red = mean_colour(image, ids, 2), green = mean_colour(image, ids, 3), blue = mean_colour(image, ids, 4);
  EXPECT_GT(red.red, red.green + 40);
  EXPECT_GT(green.green, green.red + 15);
  EXPECT_GT(blue.blue, blue.red + 15);
}

TEST_F(Drawing, SkyIsBrighterThanShadowOnTheGround) {
  const Image image = offscreen.picture(scene, front(), {}, width, height);
  int darkest = 3 * 255;  // the sun stands behind the left shoulder: the shadows lie behind, to the right
  for (int x = 0; x < width; ++x) darkest = std::min(darkest, brightness(image, x, height * 3 / 5));
  EXPECT_GT(brightness(image, width / 2, 2), 350);
  EXPECT_LT(darkest, 300);
}

TEST_F(Drawing, FarFromTheOriginNothingChanges) {
  const IdImage here = offscreen.ids(scene, front(), width, height);
  Camera camera = front();
  const Vec3d far{4e6, 0, -3e6};
  for (Instance& i : scene.instances) i.pose.p = i.pose.p + far;
  camera.eye = camera.eye + far;
  camera.target = camera.target + far;
  EXPECT_EQ(offscreen.ids(scene, camera, width, height).ids, here.ids);
}

TEST_F(Drawing, ContactsAreDrawnOverTheBodies) {
  scene.contacts = {{{0, 1, 0}, {0, 1, 0}, false}, {{-4, 1, 0}, {0, 1, 0}, true}};
  const Image image = offscreen.picture(scene, front(), {.contacts = true}, width, height);
  const std::uint8_t *stick = image.pixel(width / 2, height / 2 - 1), *slip = image.pixel(width / 2 - 70, height / 2);
  EXPECT_GT(stick[1], stick[0] + 60) << "green inside the green ball";
  int reddest = 0;
  for (int dx = -6; dx <= 6; ++dx) reddest = std::max(reddest, int(slip[4 * dx]) - int(slip[4 * dx + 1]));
  EXPECT_GT(reddest, 120);
}

// The arrow of a force is as long as the scale says, and has the colour of its kind.
TEST_F(Drawing, ForcesAreArrows) {
  scene.metres_per_newton = 0.5f;
  scene.forces = {{ForceMark::Kind::weight, {0, 1, 0}, {0, 6, 0}}};
  const Image without = offscreen.picture(scene, front(), {}, width, height);
  const Image with = offscreen.picture(scene, front(), {.forces = true}, width, height);
  const auto bluer = [&](double metres) {
    int best = -255;
    const int row = int(height / 2.0 - metres / 14 / std::tan(0.35) * height / 2);
    for (int dx = -4; dx <= 4; ++dx) {
      const std::uint8_t *p = with.pixel(width / 2 + dx, row), *q = without.pixel(width / 2 + dx, row);
      best = std::max(best, q[0] - p[0]);
    }
    return best;
  };
  EXPECT_GT(bluer(2.2), 40);
  EXPECT_LT(bluer(3.6), 10) << "only the sky";
}

int differing(const Image& a, const Image& b) {
  int pixels = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    if (std::abs(int(a.rgba[i]) - int(b.rgba[i])) > 30 || std::abs(int(a.rgba[i + 2]) - int(b.rgba[i + 2])) > 30)
      ++pixels;
  }
  return pixels;
}

TEST_F(Drawing, JointsShowAxesAndLimits) {
  scene.joints = {
      {.anchor_a = {0, 1, 0}, .anchor_b = {0, 1, 0}, .center_a = {0, 1, 0}, .center_b = {0, 1, 0}, .size = 2}};
  const auto picture = [&] { return offscreen.picture(scene, front(), {.joints = true}, width, height); };
  const Image ball = picture();
  scene.joints[0].axis = {0, 1, 0};
  const Image axis = picture();
  EXPECT_GT(differing(ball, axis), 20);
  scene.joints[0].freedom = FreedomMark{{0, 0, 1}, {1, 0, 0}, true, -1, 1, 0.2f};
  EXPECT_GT(differing(axis, picture()), 60) << "a sector";
  scene.joints[0].freedom = FreedomMark{{1, 0, 0}, {0, 1, 0}, false, -2, 2, 0.5f};
  EXPECT_GT(differing(axis, picture()), 20) << "a track";
}

TEST_F(Drawing, BoxesOfTheBroadPhase) {
  scene.boxes = {{{-5.2, -0.2, -1.2}, {-2.8, 2.2, 1.2}}};
  scene.cells = {{{-6, -1, -2}, {6, 3, 2}}};
  const Image plain = offscreen.picture(scene, front(), {}, width, height);
  const int boxes = differing(plain, offscreen.picture(scene, front(), {.boxes = true}, width, height));
  const int cells = differing(plain, offscreen.picture(scene, front(), {.cells = true}, width, height));
  EXPECT_GT(boxes, 40);
  EXPECT_GT(cells, boxes);
}

// The fastest body has the brightest colour, bodies of one island have one, and the sleeping differ from the waking.
TEST_F(Drawing, Colourings) {
  scene.instances[1].speed = 3.9f, scene.instances[2].speed = 0.1f;
  scene.instances[1].alone = scene.instances[3].alone = false;
  scene.instances[1].island = scene.instances[3].island = 7;
  scene.instances[3].asleep = true;
  EXPECT_EQ(top_speed(scene), 4);
  const IdImage ids = offscreen.ids(scene, front(), width, height);
  const auto colours = [&](Colouring by) {
    const Image image = offscreen.picture(scene, front(), {.colouring = by}, width, height);
    return std::array{mean_colour(image, ids, 2), mean_colour(image, ids, 3), mean_colour(image, ids, 4)};
  };
  const auto speed = colours(Colouring::speed);
  EXPECT_GT(speed[0].green, speed[1].green + 60);
  const auto island = colours(Colouring::island);
  EXPECT_NEAR(island[0].red - island[0].blue, island[2].red - island[2].blue, 40);
  const auto sleep = colours(Colouring::sleep);
  EXPECT_GT(sleep[1].red, sleep[1].blue + 20);
  EXPECT_LT(sleep[2].red, sleep[2].blue);
}

// The plain picture is simpler, but of the same things in the same colours.
TEST_F(Drawing, PlainIsLikeFine) {
  Style plain, fine;
  plain.set(Finish::plain), fine.set(Finish::fine);
  const IdImage ids = offscreen.ids(scene, front(), width, height);
  const Image a = offscreen.picture(scene, front(), plain, width, height),
              b = offscreen.picture(scene, front(), fine, width, height);
  for (const std::uint32_t id : {0u, 2u, 3u, 4u}) {
    const Mean p = mean_colour(a, ids, id), f = mean_colour(b, ids, id);
    EXPECT_NEAR(p.red, f.red, 15) << id;
    EXPECT_NEAR(p.green, f.green, 15) << id;
    EXPECT_NEAR(p.blue, f.blue, 15) << id;
  }
}

TEST_F(Drawing, FramingShowsEveryBodyWhole) {
  const Camera camera = framing(scene, double(width) / height);
  const IdImage ids = offscreen.ids(scene, camera, width, height);
  EXPECT_EQ(count(ids).size(), 4u);
  for (int x = 0; x < width; ++x) EXPECT_EQ(ids.at(x, 0) + ids.at(x, height - 1), 0u);
  for (int y = 0; y < height; ++y) EXPECT_EQ(ids.at(0, y) + ids.at(width - 1, y), 0u);
}

TEST_F(Drawing, TwoThousandBoxes) {
  Scene many;
  const Shape shape = box({1, 1, 1});
  for (int i = 0; i < 2000; ++i) {
    add_instance(many, shape,
                 {.pose = {{i % 50 * 1.2, 0.5, i / 50 * 1.2}, {}}, .colour = body_colour(0, std::uint32_t(i))});
  }
  EXPECT_EQ(many.shapes.size(), 1u);
  const Camera above{.eye = {30, 90, 24.1}, .target = {30, 0, 24}};
  EXPECT_EQ(count(offscreen.ids(many, above, 1280, 720)).size(), 2001u);
  const Image image = offscreen.picture(many, above, {.samples = 1}, 1280, 720);
  EXPECT_EQ(image.rgba.size(), 1280u * 720u * 4u);
}

// The dark underside of a long wedge, seen at a flat angle: one colour that changes slowly. Ambient occlusion drew
// hatching on it, since the middle of a pixel lies on the corner of four samples of the depth, and rounding chose.
TEST(Occlusion, DrawsNoHatchingAtFlatAngles) {
  Scene scene;
  add_instance(scene, half_space(), {.fixed = true});
  const Vec3 outline[] = {{0, 0, 0}, {100, 20, 0}, {-100, 20, 0}};
  add_instance(scene, prism(outline, 60), {.pose = {{10, 0, 150}, axis_angle(Vec3{0, 1, 0}, Real(pi / 2))}});
  const Camera camera{.eye = {110, 25, 260}, .target = {0, 5, 140}};
  Offscreen offscreen;
  const Image image = offscreen.picture(scene, camera, {}, 640, 360);
  int lines = 0;
  for (int y = 130; y < 160; ++y) {
    for (int x = 340; x < 420; ++x) {
      const int left = brightness(image, x - 1, y), here = brightness(image, x, y), right = brightness(image, x + 1, y);
      lines += (here > left + 9 && here > right + 9) || (here < left - 9 && here < right - 9);
    }
  }
  EXPECT_LT(lines, 5) << "of 2400 pixels";
}

// A roof that is much larger than what the picture is about, and reaches far towards the sun, shades the ground.
TEST(Shadows, OfLargeFixedThingsAreWhole) {
  Scene scene;
  add_instance(scene, half_space(), {.fixed = true});
  add_instance(scene, sphere(1), {.pose = {{0, 1, 0}, {}}});
  add_instance(scene, box({400, 1, 400}), {.pose = {{0, 80, 0}, axis_angle(Vec3{0, 0, 1}, Real(-0.5))}, .fixed = true});
  Offscreen offscreen;
  const Camera camera{.eye = {0, 3, 12}, .target = {0, 1, 0}};
  const Image shaded = offscreen.picture(scene, camera, {}, width, height);
  scene.instances.pop_back();
  const Image open = offscreen.picture(scene, camera, {}, width, height);
  for (const int x : {40, 100, 280}) EXPECT_LT(brightness(shaded, x, 150), brightness(open, x, 150) - 100) << x;
}

TEST(Palette, NeighboursDifferAndStayInRange) {
  for (std::uint32_t body = 0; body < 60; ++body) {
    const Vec3f a = body_colour(0, body), b = body_colour(0, body + 1);
    EXPECT_GT(length(a - b), 0.005f);
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(a[i] >= 0 && a[i] <= 1);
  }
}

}
