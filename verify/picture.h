// A world as an SVG picture without OpenGL: parallel projection, bodies as the outlines of their faces, the nearer over
// the farther. Enough to see what a case is about. Several moments may be drawn into one picture, the earlier ones
// faint.
#pragma once

#include <sudar/world.h>

#include <string>

namespace sudar::verify {

class Picture {
 public:
  void add(const World&);
  std::size_t moments() const { return moments_.size(); }
  std::string svg() const;

 private:
  struct Point {
    double x, y;
  };
  struct Patch {  // a closed outline of one shade
    std::vector<Point> outline;
    double light;  // 0 … 1
  };
  struct Item {
    double depth;
    std::string colour;  // "hsl(hue saturation", to which the patch adds its lightness
    std::vector<Patch> patches;
    bool fixed;
  };
  struct Floor {  // a half space: some point of its surface, two directions in it
    Vec3d at, along, across;
  };
  struct Moment {
    std::vector<Item> items;
    std::vector<Floor> floors;
    std::vector<std::vector<Point>> joints;  // from one end by way of the pulleys to the other
    Vec3d middle;                            // of the bodies that move
  };
  struct Frame;  // what part of the plane is seen, and where on the paper
  Frame frame() const;
  static std::string draw(const Item&, const Frame&);
  static std::vector<Point> outline_of(std::vector<Point>);
  static Item draw_shape(const ShapeView&, bool fixed, std::size_t number);
  std::vector<Moment> moments_;
};

}
