// Slots hand out generational handles; archives write and read every kind of value, and say where they end too soon.
#include "base/slots.h"

#include <gtest/gtest.h>

#include <sudar/definitions.h>

#include "geometry/archive.h"
#include "unit/random.h"

namespace sudar_test {
namespace {

using namespace sudar;

TEST(Slots, HandlesLiveAndDie) {
  Slots s;
  const std::uint32_t a = s.take(), b = s.take();
  const Body first = s.handle<BodyTag>(a), second = s.handle<BodyTag>(b);
  EXPECT_TRUE(s.alive(first) && s.alive(second));
  s.give_back(a);
  EXPECT_FALSE(s.alive(first));
  EXPECT_FALSE(s.used(a));
  EXPECT_EQ(s.live(), 1u);
  EXPECT_EQ(s.take(), a);
  EXPECT_FALSE(s.alive(first));
  EXPECT_TRUE(s.alive(s.handle<BodyTag>(a)));
  EXPECT_EQ(s.size(), 2u);
  EXPECT_FALSE(s.alive(Body{}));
  EXPECT_FALSE(s.alive(Body{99, 1}));
}

// A slot whose generations are used up is not used again: an old handle would come to life.
TEST(Slots, WearOut) {
  Slots s;
  const std::uint32_t i = s.take();
  const Body first = s.handle<BodyTag>(i);
  Body last = first;
  for (std::uint32_t next = i; next == i; next = s.take()) {
    last = s.handle<BodyTag>(i);
    ASSERT_TRUE(s.alive(last));
    s.give_back(i);
    ASSERT_FALSE(s.alive(last));
  }
  EXPECT_EQ(last.generation, Body::last_generation);
  EXPECT_FALSE(s.alive(first));
  EXPECT_EQ(s.live(), 1u);
  ByteWriter w;
  write(w, s);
  Reader r(w.bytes());
  Slots restored;
  read(r, restored);
  EXPECT_FALSE(restored.used(i));
  EXPECT_EQ(restored.take(), 2u);
}

// Freed slots come back last in, first out; that survives saving.
TEST(Slots, SaveTheirOrder) {
  Random random(4);
  Slots s;
  std::vector<std::uint32_t> taken;
  for (int i = 0; i < 300; ++i) {
    if (taken.empty() || random.whole(0, 2) > 0) {
      taken.push_back(s.take());
    } else {
      const auto k = std::ptrdiff_t(random.whole(0, int(taken.size()) - 1));
      s.give_back(taken[std::size_t(k)]);
      taken.erase(taken.begin() + k);
    }
    EXPECT_EQ(s.live(), taken.size());
  }
  ByteWriter w;
  write(w, s);
  Slots restored;
  Reader r(w.bytes());
  read(r, restored);
  EXPECT_EQ(r.left(), 0u);
  for (int i = 0; i < 200; ++i) {
    const std::uint32_t slot = s.take();
    ASSERT_EQ(restored.take(), slot);
    EXPECT_EQ(restored.generation(slot), s.generation(slot));
  }
}

TEST(Slots, RefuseInconsistentData) {
  const auto load = [](const std::vector<std::uint32_t>& generations, const std::vector<std::uint32_t>& free,
                       std::uint32_t live) {
    ByteWriter w;
    w.value(live), w.array(generations), w.array(free);
    Reader r(w.bytes());
    Slots s;
    read(r, s);
  };
  EXPECT_NO_THROW(load({1, 2, 3}, {1}, 2));
  EXPECT_THROW(load({1, 2, 3}, {7}, 2), Error);
  EXPECT_THROW(load({1, 2, 3}, {0}, 2), Error);
  EXPECT_THROW(load({1, 2, 4}, {1, 1}, 1), Error);
  EXPECT_THROW(load({1, 2, 3}, {}, 2), Error);
  EXPECT_THROW(load({1, 2, 3}, {1}, 3), Error);
}

TEST(Archive, WritesAndReadsEveryKind) {
  ByteWriter w;
  w.value(std::int32_t(-5)), w.value(2.5), w.value(true), w.value(Mix::max);
  w.text("čćžšđ"), w.array(std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}});
  const Force force = Drag{.body = {3, 1}, .linear = 2};
  write(w, force);
  Config config;
  config.dt = 0.125, config.impulse_2007.slop = Real(0.5);
  write(w, config);
  Reader r(w.bytes());
  EXPECT_EQ(r.value<std::int32_t>(), -5);
  EXPECT_EQ(r.value<double>(), 2.5);
  EXPECT_EQ(r.value<bool>(), true);
  EXPECT_EQ(r.value<Mix>(), Mix::max);
  EXPECT_EQ(r.text(), "čćžšđ");
  std::vector<Vec3> array;
  r.array(array);
  EXPECT_EQ(array.at(1), (Vec3{4, 5, 6}));
  Force other;
  read(r, other);
  EXPECT_EQ(std::get<Drag>(other).body, (Body{3, 1}));
  EXPECT_EQ(std::get<Drag>(other).linear, 2);
  Config copy;
  read(r, copy);
  EXPECT_EQ(copy.dt, 0.125);
  EXPECT_EQ(copy.impulse_2007.slop, Real(0.5));
  EXPECT_EQ(r.left(), 0u);
}

TEST(Archive, SaysWhereItEndsTooSoon) {
  ByteWriter w;
  w.value(std::uint64_t(1) << 60);  // a count that cannot be
  Reader count(w.bytes());
  std::vector<double> array;
  EXPECT_THROW(count.array(array), Error);
  Reader text(w.bytes());
  EXPECT_THROW(text.text(), Error);
  Reader past(w.bytes());
  past.value<std::uint64_t>();
  EXPECT_THROW(past.value<std::uint8_t>(), Error);
  ByteWriter alternative;
  alternative.value(std::uint32_t(99));
  Reader r(alternative.bytes());
  Force force;
  EXPECT_THROW(read(r, force), Error);
}

TEST(Archive, SealsAgainstDamage) {
  ByteWriter w;
  w.text("something to keep");
  const std::vector<std::byte> sealed = w.take_sealed();
  EXPECT_EQ(Reader(unseal(sealed)).text(), "something to keep");
  for (std::size_t n = 0; n < sealed.size(); ++n) {
    EXPECT_THROW(unseal(std::span(sealed).first(n)), Error);
    for (int bit = 0; bit < 8; ++bit) {
      std::vector<std::byte> turned = sealed;
      turned[n] ^= std::byte(1 << bit);
      EXPECT_THROW(unseal(turned), Error);
    }
  }
}

// A shape is written as its own data; what is read is equal and has the same mass.
TEST(Archive, Shapes) {
  for (const Shape& shape : {sphere(2), capsule(1, 3), half_space(), box({1, 2, 3}), dodecahedron(1)}) {
    ByteWriter w;
    write(w, shape);
    Reader r(w.bytes());
    Shape copy;
    read(r, copy);
    EXPECT_TRUE(copy == shape);
    EXPECT_EQ(copy.bounding_radius(), shape.bounding_radius());
    for (std::size_t n = 0; n < w.bytes().size(); ++n) {
      Reader cut(std::span(w.bytes()).first(n));
      EXPECT_THROW(read(cut, copy), Error);
    }
  }
}

}
}
