#include "view/png.h"

#include <gtest/gtest.h>

#include <fstream>

using namespace sudar;
using namespace sudar::view;

namespace {

std::string path(const char* name) { return testing::TempDir() + "sudar_png_test_" + name; }

Image gradient() {
  Image image{5, 3, {}};
  for (int i = 0; i < 5 * 3 * 4; ++i) image.rgba.push_back(std::uint8_t(i * 4));
  return image;
}

TEST(Png, ComesBackAsItWasWithItsText) {
  const std::string file = path("round_trip.png");
  const PngText text{{"Software", "sudar"}, {"time", "1.25 s"}};
  write_png(file, gradient(), text);
  PngText read_text;
  const Image image = read_png(file, &read_text);
  EXPECT_EQ(image.width, 5);
  EXPECT_EQ(image.height, 3);
  EXPECT_EQ(image.rgba, gradient().rgba);
  EXPECT_EQ(read_text, text);
}

TEST(Png, WhatCannotBeWrittenIsNamed) {
  try {
    write_png("/no/such/folder/a.png", gradient());
    FAIL();
  } catch (const std::runtime_error& e) {
    EXPECT_NE(std::string(e.what()).find("/no/such/folder/a.png"), std::string::npos);
  }
}

TEST(Png, GarbageIsRefusedByName) {
  const std::string file = path("garbage.png");
  std::ofstream(file) << "this is not a picture, however long it is";
  try {
    read_png(file);
    FAIL();
  } catch (const std::runtime_error& e) { EXPECT_NE(std::string(e.what()).find(file), std::string::npos); }
}

}
