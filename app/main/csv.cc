#include "main/csv.h"

#include <algorithm>
#include <cstdio>

namespace sudar::app {

namespace {

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

std::string number(double v) {
  char text[32];
  std::snprintf(text, sizeof text, ",%.9g", v);
  return text;
}

const char* unit_of(SensorKind kind) {
  switch (kind) {
    case SensorKind::acceleration:
      return "m/s²";
    case SensorKind::maximum_speed:
      return "m/s";
    case SensorKind::distance:
    case SensorKind::odometer:
      break;
  }
  return "m";
}

}

Csv::Csv(const std::string& path, const World& world) : file_(path), sensors_(world.sensors()) {
  std::string out = "time [s],kinetic [J],potential [J],total [J]";
  for (const Body b : world.bodies()) {
    if (world[b].motion() == Motion::fixed) continue;
    bodies_.push_back(b);
    const std::string name = world[b].name().empty() ? "body " + std::to_string(b.index) : world[b].name();
    for (const char* column : {"x [m]", "y [m]", "z [m]", "vx [m/s]", "vy [m/s]", "vz [m/s]"}) {
      out += ',' + quoted(name + "." + column);
    }
  }
  for (const SensorId s : sensors_) {
    const Sensor& sensor = world[s];
    const std::string name =
        sensor.name.empty() ? std::string(names(sensor.kind)[std::size_t(sensor.kind)]) : sensor.name;
    out += ',' + quoted(name + " [" + unit_of(sensor.kind) + "]");
  }
  file_.append(out + '\n');
  row(world);
}

void Csv::row(const World& world) {
  const Energy e = world.energy();
  std::string line;
  for (const double v : {world.time(), e.kinetic, e.potential, e.total()}) line += number(v);
  for (const Body b : bodies_) {
    if (!world.alive(b)) {
      line += ",,,,,,";
      continue;
    }
    const Pos p = world[b].center();
    const Vec3 v = world[b].velocity();
    for (const double x : {p.x, p.y, p.z, double(v.x), double(v.y), double(v.z)}) line += number(x);
  }
  const std::vector<SensorId> living = world.sensors();
  for (const SensorId s : sensors_) {
    const bool lives = std::find(living.begin(), living.end(), s) != living.end();
    line += lives ? number(world.value(s)) : ",";
  }
  file_.append(line.substr(1) + '\n');
}

}
