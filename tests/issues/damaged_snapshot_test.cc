// A snapshot with a turned bit was taken as long as its lengths agreed: a wrong world, or one that wrote where nothing
// was as soon as it stepped. Snapshots are sealed now; and what a sealed one says is looked at before it is believed.
#include "base/archive.h"
#include "unit/random.h"
#include "unit/worlds.h"

namespace sudar_test {
namespace {

World small_world() {
  World w(sleepy());
  w.add(Gravity{});
  add_floor(w);
  const Body a = w.add(cube({0, 0.5, 0})), b = w.add({.shape = sphere(Real(0.5)), .at = {0, 1.5, 0}});
  w.remove(w.add(cube({3, 3, 3})));
  w.join(Hinge{.a = a, .at = {0, 0, 0}, .limit = {.low = -1, .high = 1}});
  w.add(Thruster{.body = b, .force = {1, 0, 0}});
  w.add(Sensor{.a = a, .b = b});
  step(w, 5);
  return w;
}

// Cut anywhere, or any bit turned: refused.
TEST(DamagedSnapshot, IsRefused) {
  const Bytes whole = small_world().save();
  World w(steady());
  w.add(cube({0, 0, 0}));
  const std::uint64_t hash = w.hash();
  for (std::size_t n = 0; n < whole.size(); ++n) {
    EXPECT_THROW(w.load(std::span(whole).first(n)), Error) << "cut to " << n;
    Bytes turned = whole;
    turned[n] ^= std::byte(1 << (n % 8));
    EXPECT_THROW(w.load(turned), Error) << "bit turned at " << n;
  }
  Bytes longer = whole;
  longer.push_back({});
  EXPECT_THROW(w.load(longer), Error);
  EXPECT_EQ(w.hash(), hash);
  w.load(whole);
}

// A snapshot whose seal is right but whose content is not, as somebody could write by hand: refused, or a world that
// goes on somehow. It must not crash; the sanitizer build looks closely.
TEST(DamagedSnapshot, DoesNotCrashIfForged) {
  Random random(11);
  const Bytes whole = small_world().save();
  const std::size_t content = whole.size() - 8;
  int taken = 0, refused = 0;
  const auto load = [&](std::span<const std::byte> data) {
    ByteWriter sealed;
    sealed.raw(data);
    World forged;
    try {
      forged.load(sealed.take_sealed());
      Config c = forged.config();
      c.substeps = 1, c.impulse_2007.contact_passes = c.impulse_2007.collision_passes = 2;
      forged.set_config(c);
      for (int i = 0; i < 3; ++i) forged.step();
      forged.add(cube({0, 2, 0}));
      forged.contacts(), forged.energy(), forged.quality();
      for (const Joint j : forged.joints()) forged[j].load();
      for (const Body body : forged.bodies()) forged.remove(body);
      forged.step();
      ++taken;
    } catch (const Error&) { ++refused; }
  };
  for (std::size_t n = 0; n < content; ++n) {
    load(std::span(whole).first(n));
    Bytes forged(whole.begin(), whole.begin() + std::ptrdiff_t(content));
    for (const int value : {0x00, 0x01, 0x7f, 0xff, random.whole(0, 255)}) {
      forged[n] = std::byte(value);
      load(forged);
    }
  }
  EXPECT_GT(taken, 100);
  EXPECT_GT(refused, 100);
}

}
}
