#include "ui/camera_control.h"

#include <algorithm>

namespace sudar::ui {

using namespace view;

namespace {

constexpr double turn_per_pixel = 0.006;  // rad
constexpr Real steepest = Real(1.54);     // rad: the eye stays just off the vertical

double distance(const Camera& c) { return double(length(c.target - c.eye)); }

Frame3 axes(const Camera& c) { return looking_along(relative(c.target, c.eye)); }

// The direction turned by the mouse: about the vertical, and up and down between the poles.
Vec3 turned(const Vec3& direction, double dx, double dy) {
  const Real flat = sudar::sqrt(direction.x * direction.x + direction.z * direction.z);
  const Real azimuth = atan2(direction.x, direction.z) - Real(dx * turn_per_pixel);
  const Real elevation = std::clamp(atan2(direction.y, flat) + Real(dy * turn_per_pixel), -steepest, steepest);
  return Vec3{sudar::sin(azimuth) * sudar::cos(elevation), sudar::sin(elevation),
              sudar::cos(azimuth) * sudar::cos(elevation)} *
         length(direction);
}

}

void CameraControl::orbit(double dx, double dy) {
  camera_.eye = camera_.target + turned(camera_.eye - camera_.target, dx, dy);
}

void CameraControl::look(double dx, double dy) {
  camera_.target = camera_.eye + turned(camera_.target - camera_.eye, dx, -dy);
}

void CameraControl::look_as_far_as(double distance) {
  camera_.target = camera_.eye + normalize(camera_.target - camera_.eye) * Real(distance);
}

void CameraControl::pan(double dx, double dy, double height) {
  const Frame3 f = axes(camera_);
  const double pixel = 2 * distance(camera_) * double(sudar::tan(camera_.field_of_view / 2)) / height;
  const Vec3f way = f.right * float(-dx * pixel) + f.up * float(dy * pixel);
  camera_.eye = camera_.eye + way;
  camera_.target = camera_.target + way;
}

void CameraControl::zoom(double clicks, const Ray& towards) {
  const double factor = double(std::clamp(1 - 0.12 * clicks, 0.3, 3.0)), depth = distance(camera_);
  const Pos fixed = towards.from + towards.direction * Real(depth / double(dot(towards.direction, towards.forward)));
  const auto closer = [&](const Pos& p) { return fixed + (p - fixed) * Real(factor); };
  camera_.eye = closer(camera_.eye);
  camera_.target = closer(camera_.target);
}

void CameraControl::fly(const Vec3& way, double seconds) {
  const Frame3 f = axes(camera_);
  const float speed = float(distance(camera_) * seconds);  // a distance to the target each second
  const Vec3f step = (f.right * float(way.x) + Vec3f{0, float(way.y), 0} - f.back * float(way.z)) * speed;
  camera_.eye = camera_.eye + step;
  camera_.target = camera_.target + step;
}

void CameraControl::look_at(const Pos& p) {
  const Vec3 way = p - camera_.target;
  camera_.eye = camera_.eye + way;
  camera_.target = p;
}

void CameraControl::frame(const Pos& centre, double radius) {
  const Vec3 back = normalize(camera_.eye - camera_.target);
  camera_.target = centre;
  camera_.eye = centre + back * Real(1.3 * radius / double(sudar::tan(camera_.field_of_view / 2)));
}

Ray CameraControl::ray(double x, double y, double width, double height) const {
  const Frame3 f = axes(camera_);
  const double slope = double(sudar::tan(camera_.field_of_view / 2));
  const double right = (2 * x / width - 1) * slope * width / height, up = (1 - 2 * y / height) * slope;
  const Vec3f d = normalize(f.right * float(right) + f.up * float(up) - f.back);
  return {camera_.eye, convert<Real>(d), convert<Real>(-f.back)};
}

std::optional<CameraControl::Seen> CameraControl::project(const Pos& p, double width, double height) const {
  const Frame3 f = axes(camera_);
  const Vec3f v = relative(p, camera_.eye);
  const double depth = double(-dot(v, f.back)), slope = double(sudar::tan(camera_.field_of_view / 2));
  if (depth < 1e-6 * distance(camera_)) return {};
  const double pixels = height / (2 * slope * depth);
  return Seen{width / 2 + double(dot(v, f.right)) * pixels, height / 2 - double(dot(v, f.up)) * pixels, depth};
}

}
