// A house of cards: pairs that lean on each other carry cards that lie flat, and these the next storey. Friction alone
// holds the feet; a pair that leans by α needs μ ≥ tan(α) / 2, and more where it carries others.
#include "thesis.h"

using namespace sudar;

struct CardHouse : Scenario {
  static constexpr double seconds = 10;
  static constexpr double picture = 5;
  static constexpr const char* about = "a house of cards, held by friction alone";
  static constexpr double width = 6, height = 9, thick = 0.2;
  int storeys = 3;
  Real gravity = 5, friction = 0.6, lean = 22;
  std::vector<Body> cards;
  std::vector<Pos> built;

  void params(Params& p) override {
    p("storeys", storeys, 1, 8), p("gravity", gravity, 0, 20, "m/s²"), p("friction", friction, 0, 2);
    p("lean", lean, 10, 40, "degrees, of a card");
  }
  void state(State& s) override { s("cards", cards), s("built", built); }
  void config(Config& c) override { c = thesis_config(); }

  void add(World& w, const Vec3& edges, const Pos& at, double turn) {
    cards.push_back(add_box(w, edges, at, {friction, friction}, turned({0, 0, 1}, turn)));
    built.push_back(at);
  }
  void build(World& w) override {
    add_floor(w, 0, gravity);
    const double sine = sudar::sin(lean * pi / 180), cosine = sudar::cos(lean * pi / 180);
    // Two cards touch along an inner edge at x = 0; their other corners are thick · cos α to the sides of it.
    const double off = (thick * cosine + height * sine) / 2, half = (thick * sine + height * cosine) / 2;
    const double pitch = 2 * (thick * cosine + height * sine) + 0.1;
    for (int storey = 0; storey < storeys; ++storey) {
      const double y = storey * (2 * half + thick);
      const int pairs = storeys - storey;
      for (int i = 0; i < pairs; ++i) {
        const double x = (i - (pairs - 1) / 2.0) * pitch;
        for (double side : {-1.0, 1.0}) add(w, {thick, height, width}, {x + side * off, y + half, 0}, side * lean);
        if (i + 1 < pairs) {
          add(w, {Real(pitch - 0.05), thick, width}, {x + pitch / 2, y + 2 * half + thick / 2, 0}, 0);
        }
      }
    }
  }

  void check(const World& w, Check& c) override {
    double moved = 0;
    for (std::size_t i = 0; i < cards.size(); ++i) {
      moved = max(moved, double(length(w[cards[i]].pose().p - built[i])));
    }
    c.below("largest movement of a card", moved, 0.2, "m");
  }
  std::optional<Camera> camera() const override { return Camera{{18, 20, 52}, {0, 12, 0}}; }
};
SUDAR_SCENARIO(CardHouse, "Stacking/House of cards")
