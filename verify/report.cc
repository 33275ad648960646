#include "verify/report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "verify/peers.h"
#include "verify/svg.h"

namespace sudar::verify {

namespace {

constexpr const char* style = R"(
:root { --paper: #fbfaf8; --card: #fff; --ink: #1d232b; --faint: #6b7480; --rule: #e2e0da; --good: #1f7a4d; --bad: #b3322b;
        --theory: #d0702a; --dots: #2a6f97; }
@media (prefers-color-scheme: dark) {
  :root { --paper: #15181c; --card: #1c2026; --ink: #e4e6e9; --faint: #98a1ac; --rule: #313841; --good: #5cc48f;
          --bad: #ef7d74; --theory: #f0a35e; --dots: #74b7dd; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink); font: 16px/1.5 system-ui, sans-serif; }
main { max-width: 72rem; margin: 0 auto; padding: 2.2rem 1.5rem 4rem; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0 0 .3rem; letter-spacing: -.015em; }
h2 { font-size: 1.15rem; margin: 2.2rem 0 .7rem; }
h3 { font-size: .95rem; margin: 0 0 .5rem; font-weight: 600; }
p { margin: .4rem 0; } a { color: inherit; text-decoration-color: var(--faint); text-underline-offset: .15em; }
.faint, figcaption { color: var(--faint); font-size: .9rem; }
.law { font: 1.05rem/1.6 "STIX Two Text", Cambria, Georgia, serif; background: var(--card); border-left: 3px solid var(--theory);
       padding: .6rem 1rem; margin: 1rem 0; }
.counts { display: flex; gap: 2.5rem; margin: 1.4rem 0 .8rem; } .counts b { display: block; font-size: 2rem; line-height: 1.1; }
.bar { display: flex; height: .5rem; border-radius: .25rem; overflow: hidden; background: var(--rule); max-width: 34rem; }
.bar i { display: block; } .bar .good { background: var(--good); } .bar .bad { background: var(--bad); }
.good { color: var(--good); } .bad { color: var(--bad); }
.wide { overflow-x: auto; background: var(--card); border: 1px solid var(--rule); border-radius: .5rem; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; font-size: .9rem; }
th, td { text-align: left; padding: .38rem .75rem; border-top: 1px solid var(--rule); white-space: nowrap; }
tr:first-child > * { border-top: 0; } th { font-weight: 600; color: var(--faint); vertical-align: bottom; }
td.n, th.n { text-align: right; } td.text, .peers th { white-space: normal; } tr.ours td { font-weight: 650; }
.grid2 figure { max-width: 38rem; }
.grid2 { display: grid; grid-template-columns: repeat(auto-fit, minmax(25rem, 1fr)); gap: 1rem; margin: 1rem 0; }
figure { margin: 0; background: var(--card); border: 1px solid var(--rule); border-radius: .5rem; padding: .8rem; }
svg { display: block; width: 100%; height: auto; } svg text { font: 12px system-ui, sans-serif; fill: var(--faint); }
svg .name { fill: var(--ink); } svg .grid { stroke: var(--rule); } svg .axis { fill: none; stroke: var(--faint); }
svg .theory { fill: none; stroke: var(--theory); stroke-width: 2.2; } svg .dots { fill: var(--dots); fill-opacity: .8; }
svg.scene .before { opacity: .3; } svg.scene .floor { fill: var(--rule); stroke: none; } svg.scene circle.joint { fill: var(--theory); }
svg.scene polyline.joint { fill: none; stroke: var(--theory); stroke-width: 1.6; }
svg.scene polygon { stroke: rgb(0 0 0 / .45); stroke-width: .6; stroke-linejoin: round; }
.key i { display: inline-block; width: 1.4em; height: .22em; margin: 0 .35em .2em .9em; background: var(--theory); }
.key i.s { width: .55em; height: .55em; border-radius: 50%; background: var(--dots); margin-bottom: 0; }
)";

std::string number(double v, const char* pattern = "%.6g") {
  if (!std::isfinite(v)) return "–";
  char text[64];
  std::snprintf(text, sizeof text, pattern, v);
  return text;
}

std::string cell(const std::string& text, const char* kind = "") {
  return std::string("<td") + (*kind != 0 ? std::string(" class=\"") + kind + "\"" : "") + ">" + text + "</td>";
}

std::string page(const std::string& title, const std::string& body) {
  return "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
         "content=\"width=device-width\">\n<title>" +
         escaped(title) + "</title><link rel=\"stylesheet\" href=\"style.css\"></head>\n<body><main>\n" + body +
         "</main></body></html>\n";
}

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  if (!out.flush()) throw Error("--report", "cannot write " + file.string());
}

using Group = std::vector<const Result*>;  // of one case

bool passed(const Group& g) {
  return std::all_of(g.begin(), g.end(), [](const Result* r) { return r->passed(); });
}
const char* kind(const Group& g) { return passed(g) ? "good" : "bad"; }
const char* verdict(const Group& g) { return passed(g) ? "✓ passes" : "✗ fails"; }

// The largest error in tolerances.
double worst(const Group& g) {
  double most = 0;
  for (const Result* r : g) {
    for (const Quantity& q : r->quantities) {
      const double share = q.tolerance > 0 ? q.error() / q.tolerance : q.pass() ? 0 : std::nan("");
      if (std::isnan(share) || std::isnan(most))
        most = std::nan("");
      else
        most = std::max(most, share);
    }
  }
  return most;
}

std::string quantities(const Result& r) {
  std::string s =
      "<div class=\"wide\"><table><tr><th>quantity<th class=\"n\">exact<th class=\"n\">got<th class=\"n\">error<th "
      "class=\"n\">tolerance<th>unit<th></tr>\n";
  for (const Quantity& q : r.quantities) {
    s += "<tr>" + cell(escaped(q.name), "text") + cell(number(q.exact, "%.9g"), "n") +
         cell(number(q.got, "%.9g"), "n") + cell(number(q.error(), "%.3g"), "n") +
         cell(number(q.tolerance, "%.3g"), "n") + cell(escaped(q.unit)) +
         cell(q.pass() ? "✓" : "✗", q.pass() ? "good" : "bad") + "</tr>\n";
  }
  return s + "</table></div>\n";
}

std::string figures(const Result& r) {
  std::string s;
  const auto figure = [&](const std::string& drawing, const std::string& caption) {
    if (!drawing.empty()) s += "<figure><h3>" + escaped(caption) + "</h3>" + drawing + "</figure>\n";
  };
  for (const Plot& p : r.plots) figure(draw_curves(p), p.title);
  if (!r.sweep.empty())
    figure(draw_convergence(r.sweep, r.of->order),
           "Error against step size: order " + number(r.of->order, "%g") + " is the line");
  figure(r.picture, "The scene: before (faint) and after");
  return s.empty() ? "" : "<div class=\"grid2\">\n" + s + "</div>\n";
}

std::string case_page(const Group& g, const std::string& engine) {
  const Case& c = *g.front()->of;
  std::string s = "<p class=\"faint\"><a href=\"index.html\">All cases</a> · " + escaped(c.group) + "</p>\n<h1>" +
                  c.id + " " + escaped(c.title) + "</h1>\n";
  s += std::string("<p class=\"") + kind(g) + "\">" + verdict(g) + "</p>\n";
  s += "<p class=\"law\">" + escaped(c.formula) + "</p>\n<p class=\"faint\">Source: " + escaped(c.source) + "</p>\n";
  if (*c.others != 0) s += "<p><b>Other engines:</b> " + escaped(c.others) + "</p>\n";
  s += "<p class=\"faint key\">" + escaped(engine) + "<i></i>theory<i class=\"s\"></i>simulation</p>\n";
  for (const Result* r : g) {
    s += "<h2>" + escaped(r->set) + (r->solver ? " · " + std::string(solver_name(*r->solver)) : "") +
         "</h2>\n<p class=\"faint\">";
    for (const Parameter& p : c.parameters) {
      s += escaped(p.name) + " = " + number(r->parameters.at(p.name)) + " " +
           (p.whole() || std::string_view(p.unit) == "1" ? "" : escaped(p.unit)) + " &nbsp; ";
    }
    s += "</p>\n";
    if (!r->failure.empty()) s += "<p class=\"bad\">" + escaped(r->failure) + "</p>\n";
    if (!r->quantities.empty()) s += quantities(*r) + figures(*r);
  }
  return page(std::string(c.id) + " " + c.title, s);
}

std::string peers(const std::vector<Result>& results) {
  std::string s =
      "<h2>Beside other engines</h2>\n<p class=\"faint\">The exact value is in the head. The other rows were measured "
      "on the same scenes with "
      "the engines' default settings: reachable errors, not a ranking.</p>\n<div class=\"wide\"><table "
      "class=\"peers\"><tr><th>engine";
  for (const PeerColumn& c : peer_columns()) s += "<th>" + escaped(c.title);
  s += "</tr>\n<tr class=\"ours\"><td>Sudar</td>";
  for (const PeerColumn& c : peer_columns()) s += cell(our_value(c, results));
  s += "</tr>\n";
  for (const PeerRow& row : peer_rows()) {
    s += "<tr>" + cell(row.engine);
    for (const char* value : row.values) s += cell(value);
    s += "</tr>\n";
  }
  return s + "</table></div>\n";
}

std::string index_page(const std::vector<Group>& groups, const std::vector<Result>& results,
                       const std::string& engine) {
  const Tally t = count(results);
  const int failed = t.cases - t.passed;
  std::string s = "<h1>How right is Sudar?</h1>\n<p class=\"faint\">" + escaped(engine) + "</p>\n";
  s += "<div class=\"counts\"><span class=\"good\"><b>" + std::to_string(t.passed) +
       "</b>pass</span><span class=\"bad\"><b>" + std::to_string(failed) + "</b>fail</span></div>\n<div class=\"bar\">";
  const auto part = [&](const char* name, int n) {
    s += std::string("<i class=\"") + name + "\" style=\"width:" + number(100.0 * n / std::max(1, t.cases), "%.2f") +
         "%\"></i>";
  };
  part("good", t.passed), part("bad", failed);
  s += "</div>\n<p>Each case is a law of mechanics with an exact result, computed on the spot, and the scene in which "
       "the engine has to obey it.</p>\n";
  s += peers(results);
  std::vector<std::string> names;
  for (const Group& g : groups) {
    if (std::find(names.begin(), names.end(), g.front()->of->group) == names.end())
      names.push_back(g.front()->of->group);
  }
  for (const std::string& name : names) {
    s += "<h2>" + escaped(name) +
         "</h2>\n<div class=\"wide\"><table><tr><th>case<th>law<th class=\"n\">largest error / tolerance<th "
         "class=\"n\">s<th></tr>\n";
    for (const Group& g : groups) {
      const Case& c = *g.front()->of;
      if (c.group != name) continue;
      double seconds = 0;
      for (const Result* r : g) seconds += r->seconds;
      s += "<tr><td><a href=\"" + std::string(c.id) + ".html\">" + c.id + " " + escaped(c.title) + "</a></td>" +
           cell(escaped(c.formula), "text faint") + cell(number(worst(g), "%.2g"), "n") +
           cell(number(seconds, "%.2f"), "n") + cell(verdict(g), kind(g)) + "</tr>\n";
    }
    s += "</table></div>\n";
  }
  return page("How right is Sudar?", s);
}

}

void write_report(const std::vector<Result>& results, const std::filesystem::path& folder, const std::string& engine) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) throw Error("--report", "cannot make " + folder.string() + ": " + failed.message());
  std::vector<Group> groups;
  for (const Result& r : results) {
    if (groups.empty() || groups.back().front()->of != r.of) groups.emplace_back();
    groups.back().push_back(&r);
  }
  write(folder / "style.css", style);
  for (const Group& g : groups) write(folder / (std::string(g.front()->of->id) + ".html"), case_page(g, engine));
  write(folder / "index.html", index_page(groups, results, engine));
}

}
