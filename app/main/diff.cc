// sudar diff: what tells two recordings, or two saved runs, apart.
#include <sudar/difference.h>

#include <cstdio>
#include <iostream>

#include "main/command.h"
#include "main/files.h"
#include "main/report.h"

namespace sudar::app {

namespace {

struct Comparison {
  std::optional<RecordingDifference> difference;
  std::int64_t steps;     // of a
  std::string body_name;  // of the body that differs
};

Comparison result(const std::optional<RecordingDifference>& d, const World& a) {
  if (!d || d->difference.body.null() || !a.alive(d->difference.body)) return {d, a.steps(), ""};
  return {d, a.steps(), a[d->difference.body].name()};
}

std::optional<Difference> difference(const Session& a, const Session& b) {
  const auto differs = [](std::string field, const Json& of_a, const Json& of_b) {
    return Difference{.field = std::move(field), .a = of_a.dump(), .b = of_b.dump()};
  };
  const std::string name = a.entry().name, other_name = b.entry().name;
  if (name != other_name) return differs("scenario", name, other_name);
  for (std::size_t i = 0; i < a.params().size(); ++i) {
    const double of_a = a.params()[i].value, of_b = b.params()[i].value;
    if (of_a != of_b) return differs("parameters." + a.params()[i].name, of_a, of_b);
  }
  if (a.world().steps() != b.world().steps()) return differs("steps", a.world().steps(), b.world().steps());
  if (auto d = difference(a.world(), b.world())) return d;
  if (a.save() != b.save()) return Difference{.field = "what the scenario remembers", .a = "", .b = ""};
  return {};
}

// Opened recordings or saved runs; which of the two, the first bytes tell.
std::variant<Replay, Session> open(const Catalogue& catalogue, const std::string& file) {
  return load_file(file, [&](Bytes bytes) -> std::variant<Replay, Session> {
    if (Replay::begins(bytes)) return Replay(std::move(bytes));
    if (Session::begins(bytes)) return Session::load(catalogue, bytes);
    throw Error("", "is neither a recording nor a saved run");
  });
}

Comparison compare(const Catalogue& catalogue, const std::string& file_a, const std::string& file_b) {
  auto a = open(catalogue, file_a), b = open(catalogue, file_b);
  if (a.index() != b.index()) {
    throw Error(file_b, "cannot be compared with " + file_a + ": one is a recording, the other a saved run");
  }
  if (auto* of_a = std::get_if<Replay>(&a)) {
    const auto d = difference(*of_a, std::get<Replay>(b));
    return result(d, of_a->world());
  }
  const Session& of_a = std::get<Session>(a);
  const auto d = difference(of_a, std::get<Session>(b));
  return result(d ? std::optional(RecordingDifference{of_a.world().steps(), "saved", *d}) : std::nullopt, of_a.world());
}

Json value_of(const std::string& text) { return text.empty() ? Json() : Json::parse(text); }

void print_json(const Comparison& c) {
  Json j = {{"same", !c.difference.has_value()}};
  if (!c.difference) {
    j["steps"] = c.steps;
  } else {
    const auto& [step, stage, d] = *c.difference;
    j["step"] = step, j["stage"] = stage;
    j["body"] = d.body.null() ? Json() : Json{{"index", d.body.index}, {"name", c.body_name}};
    j["field"] = d.field;
    j["index"] = d.index < 0 ? Json() : Json(d.index);
    j["a"] = value_of(d.a), j["b"] = value_of(d.b);
  }
  std::cout << j.dump(2) << '\n';
}

void print(const Comparison& c) {
  if (!c.difference) {
    std::printf("the same, %lld steps\n", static_cast<long long>(c.steps));
    return;
  }
  const auto& [step, stage, d] = *c.difference;
  std::string whose;
  if (!d.body.null()) {
    whose = "body " + std::to_string(d.body.index) + (c.body_name.empty() ? "" : " (" + c.body_name + ")") + ", ";
  } else if (d.index >= 0) {
    whose = "row " + std::to_string(d.index) + ", ";
  }
  const auto shown = [](const std::string& value) { return value.empty() ? std::string("not known") : value; };
  std::printf("differ at step %lld, stage %s, %sfield %s\n  a: %s\n  b: %s\n", static_cast<long long>(step),
              stage.c_str(), whose.c_str(), d.field.c_str(), shown(d.a).c_str(), shown(d.b).c_str());
}

int diff(const Catalogue& catalogue, const std::string& a, const std::string& b, bool json) {
  const Comparison c = compare(catalogue, a, b);
  json ? print_json(c) : print(c);
  return c.difference ? 1 : 0;
}

}

void add_diff(CLI::App& app, Action& chosen) {
  CLI::App* sub = app.add_subcommand("diff", "compare two recordings, or two saved runs; exit 1 if they differ");
  struct Options {
    std::string a, b;
    bool json = false;
  };
  const auto o = std::make_shared<Options>();
  sub->add_option("a", o->a, "written by sudar run --record or --save")->required();
  sub->add_option("b", o->b, "the other one")->required();
  sub->add_flag("--json", o->json, "the first difference as JSON (docs/json.md)");
  sub->callback([&chosen, o] { chosen = [o](const Catalogue& c) { return diff(c, o->a, o->b, o->json); }; });
}

}
