// sudar render: a picture or a movie of a scenario or a recording.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <sstream>

#include "main/command.h"
#include "main/files.h"
#include "main/interrupt.h"
#include "main/movie.h"
#include "main/playback.h"
#include "main/progress.h"
#include "view/offscreen.h"

namespace sudar::app {

using namespace view;

namespace {

struct RenderOptions {
  SceneOptions scene;
  std::string out, size = "1280x720", camera;
  std::optional<double> at;
  int frames_per_second = 30;
  Style style;
};

Camera parse_camera(const std::string& text) {
  std::vector<double> v;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) v.push_back(parse_number("--camera", part, {-1e12, 1e12}));
  if (v.size() != 6 && v.size() != 7) {
    throw Error("--camera", "\"" + text + "\" given, EYE_X,EYE_Y,EYE_Z,TARGET_X,TARGET_Y,TARGET_Z[,DEGREES] expected");
  }
  Camera c{.eye = {v[0], v[1], v[2]}, .target = {v[3], v[4], v[5]}};
  if (v.size() == 7) c.field_of_view = Real(v[6] * pi / 180);
  if (unset(c)) throw Error("--camera", "the eye is where it looks at");
  if (!(c.field_of_view > Real(0.01) && c.field_of_view < 3))
    throw Error("--camera", "an angle from 1 to 170 degrees expected");
  return c;
}

// The picture's camera: the one asked for, else the scenario's, else one that shows everything.
Camera choose_camera(const std::string& asked, const Playback& p, const Scene& scene, double aspect) {
  if (!asked.empty()) return parse_camera(asked);
  const std::optional<Camera> own = p.camera();
  return own && !unset(*own) ? *own : framing(scene, aspect);
}

void draw_picture(const RenderOptions& o, Playback& p, int width, int height, const Interrupt& interrupt) {
  const double at = o.at.value_or(o.scene.seconds.value_or(p.telling_moment()));
  {
    Progress progress(p.title(), at);
    while (!p.over() && p.world().time() < at - 1e-9 && !interrupt.wished()) p.step(), progress.show(p.world().time());
  }
  if (interrupt.wished()) {
    std::fprintf(stderr, "sudar: interrupted at %.6g s, before the picture\n", p.world().time());
    return;
  }
  if (p.world().time() < at - p.world().config().dt) {
    throw Error("--at", "the recording ends at " + std::to_string(p.world().time()) + " s");
  }
  const Scene scene = scene_of(p, needed_for(o.style));
  Offscreen offscreen;
  write_png(o.out,
            offscreen.picture(scene, choose_camera(o.camera, p, scene, double(width) / height), o.style, width, height),
            provenance(p));
  std::printf("%s: %s at %.4g s\n", o.out.c_str(), p.title().c_str(), p.world().time());
}

// Pictures at even times, each a mixture of the steps before and after it.
void draw_movie(const RenderOptions& o, Playback& p, int width, int height, const Interrupt& interrupt) {
  const double start = o.at.value_or(0), length = o.scene.seconds.value_or(p.seconds() - start);
  p.advance_to(start);
  Scene before = scene_of(p, needed_for(o.style)), after = before;
  double before_time = p.world().time(), after_time = before_time;
  const Camera camera = choose_camera(o.camera, p, before, double(width) / height);
  Offscreen offscreen;
  const std::unique_ptr<Movie> movie = make_movie(o.out, width, height, o.frames_per_second, provenance(p));
  // A movie runs as fast as a window would: time_factor is simulated time per second of it.
  const double frame = double(p.world().config().time_factor) / o.frames_per_second;
  const auto frames = std::int64_t(std::floor(length / frame + 1e-6)) + 1;
  Progress progress(p.title(), double(frames));
  for (std::int64_t i = 0; i < frames && !interrupt.wished(); ++i) {
    const double time = start + double(i) * frame;
    while (after_time < time - 1e-9 && !p.over()) {
      before = std::move(after), before_time = after_time;
      p.step();
      after = scene_of(p, needed_for(o.style)), after_time = p.world().time();
    }
    const double share =
        after_time > before_time ? std::clamp((time - before_time) / (after_time - before_time), 0.0, 1.0) : 1;
    movie->add(offscreen.picture(mix(before, after, share), camera, o.style, width, height));
    progress.show(double(i + 1));
  }
  progress.clear();
  const std::string made = movie->finish();
  if (interrupt.wished()) std::fprintf(stderr, "sudar: interrupted at %.6g s; the movie ends there\n", after_time);
  std::printf("%s\n", made.c_str());
}

int render(const RenderOptions& o, const Catalogue& catalogue) {
  const auto [width, height] = parse_size(o.size);
  const std::string kind = std::filesystem::path(o.out).extension().string();
  if (kind != ".png" && kind != ".mp4" && kind != ".webm") {
    throw Error("--output", "\"" + o.out + "\" given, a name that ends with .png, .mp4 or .webm expected");
  }
  expect_writable(o.out);
  const std::unique_ptr<Playback> p = open_playback(o.scene, catalogue);
  const Interrupt interrupt;
  kind == ".png" ? draw_picture(o, *p, width, height, interrupt) : draw_movie(o, *p, width, height, interrupt);
  return interrupt.wished() ? interrupted : 0;
}

}

void add_render(CLI::App& app, Action& chosen) {
  CLI::App* sub = app.add_subcommand("render", "draw a picture or a movie of a scenario or a recording");
  const auto o = std::make_shared<RenderOptions>();
  sub->add_option("what", o->scene.scene, "a name from sudar list, a file (docs/files.md), or one written by sudar run --record")
      ->required();
  sub->add_option("-o,--output", o->out, "FILE.png, FILE.mp4 or FILE.webm")->required();
  add_number(*sub, "--at", o->at, simulated_time, "time of the picture, or of the movie's start, s");
  sub->add_option("--size", o->size, "WIDTHxHEIGHT")->capture_default_str();
  add_whole(*sub, "--fps", o->frames_per_second, 1, 240, "pictures per second of a movie")->default_str("30");
  sub->add_option("--camera", o->camera, "EYE_X,EYE_Y,EYE_Z,TARGET_X,TARGET_Y,TARGET_Z[,DEGREES]; else the scenario's");
  add_whole(*sub, "--samples", o->style.samples, 1, 4, "per pixel along each side: anti-aliasing")
      ->default_str(std::to_string(o->style.samples));
  sub->add_flag("--contacts", o->style.contacts, "show contact points and normals: green sticks, red slips");
  sub->add_flag("--joints", o->style.joints, "show joints");
  sub->add_flag("--forces", o->style.forces, "show weights and the forces of contacts and joints");
  sub->add_flag("--boxes", o->style.boxes, "show the boxes that the broad phase compares");
  sub->add_flag("--cells", o->style.cells, "show the cells or the tree of the broad phase");
  sub->add_option("--colour", o->style.colouring, "bodies' colours: body, speed, island or sleep")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, Colouring>{{"body", Colouring::body},
                                           {"speed", Colouring::speed},
                                           {"island", Colouring::island},
                                           {"sleep", Colouring::sleep}}));
  sub->add_flag("--axes", o->style.axes, "show the bodies' axes");
  sub->add_flag("--wireframe", o->style.wireframe, "edges only");
  sub->add_flag("--sleep", o->style.sleep, "show bodies asleep pale");
  o->scene.add_to(*sub);
  sub->callback([&chosen, o] { chosen = [o](const Catalogue& c) { return render(*o, c); }; });
}

}
