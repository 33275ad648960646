#include "ui/app.h"

#include <epoxy/gl.h>
#include <sudar/io.h>

#include <algorithm>

#include "ui/filming.h"
#include "ui/gui.h"
#include "ui/hand.h"
#include "ui/panels.h"
#include "ui/status.h"
#include "ui/window.h"
#include "view/canvas.h"

namespace sudar::ui {

using namespace view;

namespace {

class App {
 public:
  App(const Catalogue& catalogue, const Options& options)
      : window_(options.width, options.height, "Sudar"),
        controls_(catalogue, simulation_),
        status_(options.status),
        fixed_quality_(options.quality) {}

  void loop() {
    draw_panels(), gui_.end();  // what they leave for the picture decides from where a scene is seen
    Clock::time_point last = Clock::now();
    while (!window_.closing()) {
      const double due = frame_length() - std::chrono::duration<double>(Clock::now() - last).count();
      const std::vector<InputEvent> events = window_.wait(std::max(0.0, due));
      if (!events.empty()) events_left_ = 2, last_event_ = Clock::now();  // what follows may show a picture later
      gui_.take(events);
      const double passed = std::chrono::duration<double>(Clock::now() - last).count();
      if (passed < frame_length() && events_left_ == 0) continue;
      last = Clock::now();
      hand_.fly(passed);
      draw();
      frame_ += 0.1 * (passed - frame_);
      serve();
    }
    if (movie_) movie_->finish();
  }
  void start(const ScenarioEntry& entry) { controls_.start(entry); }

 private:
  // 60 pictures a second; where nothing moves, 30 of the panels, and 10 when nobody has touched anything for a while.
  double frame_length() const {
    if (!controls_.view().paused || events_left_ > 0) return 1.0 / 60;
    return Clock::now() - last_event_ < std::chrono::milliseconds(500) ? 1.0 / 30 : 1.0 / 10;
  }

  void draw() {
    controls_.look(simulation_.view(), double(controls_.area.width) / std::max(1, controls_.area.height));
    draw_panels();
    while (gui_.pending()) gui_.end(), draw_panels();
    events_left_ = std::max(0, events_left_ - 1);
    if (controls_.area.width > 0 && controls_.area.height > 0 && controls_.moment()) {
      draw_scene();
      canvas_->show(controls_.area.x, window_.height() - controls_.area.y - controls_.area.height);
    }
    gui_.draw();
    window_.show();
  }

  // Everything that the picture of the bodies depends on: while it stays the same, so does the picture.
  struct Drawn {
    std::int64_t scene = -1;
    Pos eye, target;
    Real field_of_view = 0;
    Style style;
    Body selected;
    bool operator==(const Drawn&) const = default;
  };

  void draw_scene() {
    if (!canvas_ || canvas_->width() != controls_.area.width || canvas_->height() != controls_.area.height) {
      canvas_.emplace(controls_.area.width, controls_.area.height);
      drawn_ = {};
    }
    const Camera& camera = controls_.camera.camera();
    Drawn now{controls_.scenes, camera.eye, camera.target, camera.field_of_view, controls_.style, controls_.selected};
    now.style.set(quality());
    if (now == drawn_) return;
    drawn_ = now;
    renderer_.draw(marked(controls_.scene), camera, now.style, canvas_->target());
  }

  void draw_panels() {
    const std::optional<InputEvent> event = gui_.begin();
    controls_.area = panels_.draw(window_.width(), window_.height(), 1 / frame_);
    if (event) hand_.take(*event, controls_.area);
  }

  // A beautiful picture where that is quick, or where nothing has moved for a moment and nobody waits for the next;
  // else a plain one. Each change is given time to be judged, and the two limits lie far apart, so that it does not
  // flicker.
  Finish quality() {
    if (fixed_quality_) return *fixed_quality_;
    if (!controls_.view().paused || events_left_ > 0) moved_ = Clock::now();
    if (Clock::now() - moved_ > std::chrono::milliseconds(400)) return Finish::fine;
    if (++judged_ < 30) return quality_;
    const Finish wanted = frame_ > 0.045 ? Finish::plain : frame_ < 0.02 ? Finish::fine : quality_;
    if (wanted != quality_) judged_ = wanted == Finish::plain ? -600 : 0;
    return quality_ = wanted;
  }

  // The scene with the selected body and the spring that pulls it.
  Scene marked(Scene scene) const {
    for (Instance& i : scene.instances) {
      if (!i.body.null() && i.body == controls_.selected) i.colour = i.colour * 0.4f + Vec3f{0.9f, 0.5f, 0.05f} * 0.6f;
    }
    const Moment& m = *controls_.moment();
    if (m.spring) scene.links.push_back({m.spring->from, m.spring->to, float(0.006 * controls_.focus.radius)});
    return scene;
  }

  // Files of other programs, and saved runs.
  void open_dropped() {
    for (const std::string& path : window_.take_dropped()) {
      try {
        if (io::is_readable(path)) controls_.start(controls_.catalogue().find(path));
        else simulation_.open(controls_.catalogue(), path);
      } catch (const Error& e) { simulation_.say(e.what()); }
    }
  }

  // What was asked of the program itself.
  void serve() {
    open_dropped();
    if (std::exchange(controls_.wants_fullscreen, false)) window_.toggle_fullscreen();
    if (canvas_ && controls_.moment()) {
      const std::string scene = controls_.moment()->entry->name;
      if (std::exchange(controls_.wants_screenshot, false)) take_picture(background_, simulation_, scene, *canvas_);
      if (std::exchange(controls_.wants_movie, false)) start_or_finish_movie(scene);
      film();
    }
    if (controls_.wants_quit) window_.close();
    const Moment* m = controls_.moment();
    if (m && m->run != titled_) window_.set_title(std::string("Sudar: ") + m->entry->place), titled_ = m->run;
    status_.write(controls_, window_, 1 / frame_);
  }

  void start_or_finish_movie(const std::string& scene) {
    if (movie_) return movie_->finish(), movie_.reset();
    movie_ = std::make_unique<Filming>(background_, simulation_, scene, *canvas_);
  }

  void film() {
    if (movie_ && movie_->failed()) movie_.reset();
    if (movie_ && !movie_->fits(*canvas_)) movie_->finish(), movie_.reset();  // the window became smaller
    if (movie_) movie_->add(*canvas_);
    controls_.filming = movie_ != nullptr;
  }

  Body pick(int x, int y) {
    if (!controls_.moment() || x < 0 || y < 0 || x >= controls_.area.width || y >= controls_.area.height) return {};
    const std::uint32_t id =
        renderer_.ids(controls_.scene, controls_.camera.camera(), controls_.area.width, controls_.area.height).at(x, y);
    if (id == 0 || id > controls_.scene.instances.size()) return {};
    const Instance& i = controls_.scene.instances[id - 1];
    return controls_.scene.shapes[i.shape].kind() == ShapeKind::half_space ? Body{} : i.body;
  }

  Simulation simulation_;  // first: its thread goes before those that draw
  Window window_;          // all that draws needs its context
  Gui gui_{window_};
  Renderer renderer_;
  std::optional<Canvas> canvas_;
  Drawn drawn_;            // on it
  Background background_;  // ends before the simulation, to which it talks
  std::unique_ptr<Filming> movie_;
  Controls controls_;
  Panels panels_{controls_};
  Hand hand_{controls_, [this](int x, int y) { return pick(x, y); }};
  StatusFile status_;
  double frame_ = 0.03;  // s, smoothed
  std::optional<Finish> fixed_quality_;
  Finish quality_ = Finish::plain;
  int judged_ = 0;  // pictures since it changed
  Clock::time_point moved_ = Clock::now();
  int events_left_ = 0;
  Clock::time_point last_event_ = Clock::now();
  std::int64_t titled_ = 0;
};

const ScenarioEntry& first_scene(const Catalogue& catalogue, const std::string& asked) {
  if (!asked.empty()) return catalogue.find(asked);
  if (catalogue.all().empty()) throw Error("scene", "there are no scenarios");
  for (const ScenarioEntry* e : catalogue.all()) {
    if (std::string_view(e->name) == "wall") return *e;
  }
  return *catalogue.all().front();
}

}

int run_window(const Catalogue& catalogue, const Options& options) {
  const ScenarioEntry& entry = first_scene(catalogue, options.scene);
  App app(catalogue, options);
  app.start(entry);
  app.loop();
  return 0;
}

}
