// Every sign that the window writes has a picture in the fonts that it loads, and not the box for what is missing.
#include "ui/fonts.h"

#include <gtest/gtest.h>
#include <imgui.h>

using namespace sudar;

namespace {

TEST(Fonts, HaveTheSignsOfPhysicsAndCyrillic) {
  ImGui::CreateContext();
  ui::load_fonts();
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  atlas.GetTexDataAsAlpha8(&pixels, &width, &height);
  const ImFont& font = *atlas.Fonts[0];
  for (const ImWchar sign : u"μωΣ°²→↺×−…µ▶■●№АЯбжщюяЂљњћџ") {
    if (sign == 0) continue;
    const ImFontGlyph* glyph = font.FindGlyphNoFallback(sign);
    ASSERT_NE(glyph, nullptr) << "U+" << std::hex << unsigned(sign);
    int ink = 0;
    for (int y = int(glyph->V0 * float(height)); y < int(glyph->V1 * float(height)); ++y) {
      for (int x = int(glyph->U0 * float(width)); x < int(glyph->U1 * float(width)); ++x) {
        ink += pixels[y * width + x] > 100 ? 1 : 0;
      }
    }
    EXPECT_GT(ink, 5) << "U+" << std::hex << unsigned(sign);
  }
  ImGui::DestroyContext();
}

}
