// A damaged count in the saved state of a scenario asked for as much memory as it said, before anything looked whether
// so much was there: std::bad_alloc instead of an Error.
#include <sudar/scenario.h>

#include "unit/worlds.h"

namespace sudar_test {
namespace {

struct Memory {
  int dropped = 0;
  Body last;
  std::vector<double> heights;
  void visit(State& s) { s("dropped", dropped), s("last", last), s("heights", heights); }
};

// Cut anywhere, or with a count that cannot be: refused by the name of what is missing, and no memory taken for it.
TEST(ScenarioStateCount, IsRefusedIfTooLarge) {
  Memory before{7, {3, 1}, {1.5, 2.5}};
  State write;
  before.visit(write);
  for (std::size_t n = 0; n < write.bytes().size(); ++n) {
    State read(Bytes(write.bytes().begin(), write.bytes().begin() + std::ptrdiff_t(n)));
    Memory after;
    try {
      after.visit(read);
      ADD_FAILURE() << "cut to " << n;
    } catch (const Error& e) { EXPECT_EQ(e.field, n < 4 ? "dropped" : n < 12 ? "last" : "heights"); }
  }
  Bytes many = write.bytes();
  many[12 + 7] = std::byte{0x7f};  // the count's highest byte
  State read(many);
  Memory after;
  EXPECT_THROW(after.visit(read), Error);
}

}
}
