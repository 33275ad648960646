#include "verify/case.h"

#include <cmath>
#include <sstream>

namespace sudar::verify {

bool Parameter::whole() const { return std::string_view(unit) == whole_number; }

std::string Parameter::range() const {
  std::ostringstream s;
  s << (whole() ? "a whole number " : "") << low << " … " << high;
  if (!whole() && std::string_view(unit) != "1") s << ' ' << unit;
  return s.str();
}

Values values_of(const Case& c, const Values& set) {
  Values values;
  for (const Parameter& p : c.parameters) values[p.name] = p.value;
  for (const auto& [name, value] : set) {
    if (!values.contains(name)) throw Error(name, std::string("is no parameter of ") + c.id);
    values[name] = value;
  }
  for (const Parameter& p : c.parameters) {
    const double value = values[p.name];
    if (value >= p.low && value <= p.high && (!p.whole() || value == std::round(value))) continue;
    std::ostringstream s;
    s << value << " given, " << c.id << " expects " << p.range();
    throw Error(p.name, s.str());
  }
  return values;
}

Run::Run(const Case& c, const Values& set, const Setting& setting) : values_(values_of(c, set)), setting_(setting) {}

double Run::operator[](std::string_view parameter) const { return values_.at(std::string(parameter)); }

Config Run::config() const {
  Config c;
  c.solver = setting_.solver;
  c.substeps = setting_.substeps;
  c.sleep = false;
  if (without("impulses")) {
    c.impulse_2007.collision_passes = c.impulse_2007.contact_passes = 0;
    c.impulse_2007.exact_joints = false;
  }
  c.impulse_2007.one_point_contact = without("contact areas");
  return c;
}

Config Run::fine_config() const {
  Config c = config();
  c.dt /= c.substeps;
  c.substeps = 1;
  return c;
}

void Run::until(World& w, double seconds, const std::function<void()>& visit) {
  const bool draws = picture_.moments() == 0;
  if (draws) draw(w);
  const double half_step = w.config().dt * double(w.config().time_factor) / 2;
  while (w.time() < seconds - half_step) {
    w.step();
    visit();
  }
  if (draws) draw(w);
}

void Run::draw(const World& w) {
  if (setting_.pictures && picture_.moments() < 2) picture_.add(w);
}

void Run::check(std::string name, std::string unit, double exact, double got, double tolerance) {
  quantities_.push_back({std::move(name), std::move(unit), exact, got, tolerance});
}

void Run::relative(std::string name, std::string unit, double exact, double got, double share) {
  check(std::move(name), std::move(unit), exact, got, share * std::fabs(exact));
}

void Run::refutes(std::string name, std::string unit, double exact, double wrong, double tolerance) {
  quantities_.push_back({std::move(name) + " (wrong)", std::move(unit), exact, wrong, tolerance, true});
}

Plot& Run::plot(std::string title, std::string x, std::string y) {
  return plots_.emplace_back(Plot{std::move(title), std::move(x), std::move(y)});
}

}
