// A recording: header, title, snapshot; per step: dt, the operations before it, hashes after it; the number of steps,
// seal. An open one begins with another word and lacks the last two.
#include <sudar/difference.h>

#include "base/file_header.h"
#include "world/stages.h"
#include "world/state_list.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

constexpr std::uint64_t magic = 0x31302e6365727573;       // "surec.01" as bytes
constexpr std::uint64_t open_magic = 0x6e65706f72727573;  // "surropen" as bytes
static_assert(sizeof magic == Recorder::head);

// What a step led to: enough to name the first stage, field and body that differ.
struct StepHashes {
  std::vector<std::uint64_t> stages, fields, bodies;
  bool operator==(const StepHashes&) const = default;
  friend void write(Writer& w, const StepHashes& h) {
    w.named("stages", h.stages), w.named("fields", h.fields), w.named("bodies", h.bodies);
  }
  friend void read(Reader& r, StepHashes& h) { r.array(h.stages), r.array(h.fields), r.array(h.bodies); }
};

std::vector<std::uint64_t> body_hashes(const Bodies& b) {
  std::vector<std::uint64_t> hashes(b.size(), 0);
  for (std::uint32_t i = 0; i < b.size(); ++i) {
    if (!b.slots.used(i)) continue;
    hashes[i] = Hasher{}.add(b.position[i]).add(b.orientation[i]).add(b.velocity[i]).add(b.angular_momentum[i]).value();
  }
  return hashes;
}

// Of a recording's parts.
std::uint64_t layout_of_recording() {
  LayoutWriter w;
  write(w, Operation{});
  write(w, StepHashes{});
  return Hasher{}.add(layout_of_state()).add(w.layout()).value();
}

StepHashes hashes_of(const World::Impl& w) { return {w.stage_hashes, field_hashes(w.bodies), body_hashes(w.bodies)}; }

template <class T>
std::size_t first_difference(const std::vector<T>& a, const std::vector<T>& b) {
  std::size_t i = 0;
  while (i < a.size() && i < b.size() && a[i] == b[i]) ++i;
  return i;
}

Divergence divergence(std::int64_t step, const StepHashes& was, const StepHashes& is, const Bodies& bodies) {
  Divergence d{step, "", "", {}};
  if (const std::size_t s = first_difference(was.stages, is.stages); s < std::size(stages)) d.stage = stages[s].name;
  const std::vector<FieldInfo> fields = body_fields();
  if (const std::size_t f = first_difference(was.fields, is.fields); f < fields.size()) d.field = fields[f].name;
  const std::size_t b = first_difference(was.bodies, is.bodies);
  if (b < bodies.size() && was.bodies != is.bodies) d.body = bodies.slots.handle<BodyTag>(std::uint32_t(b));
  return d;
}

}

Recorder::Recorder(World& world, std::string title) : world_(world.impl()) {
  ByteWriter w;
  write_header(w, open_magic, layout_of_recording());
  w.text(title);
  w.array(world.save());
  data_ = w.take();
  world_.recording = true;
  world_.log.clear();
}

Recorder::~Recorder() {
  world_.recording = false;
  world_.log.clear();
}

void Recorder::after_step() {
  ByteWriter w;
  w.value(world_.last_dt);
  w.value(std::uint64_t(world_.log.size()));
  for (const Operation& op : world_.log) write(w, op);
  write(w, hashes_of(world_));
  data_.insert(data_.end(), w.bytes().begin(), w.bytes().end());
  world_.log.clear();
  ++steps_;
}

Bytes Recorder::bytes() const {
  ByteWriter w;
  w.value(magic);
  w.raw(std::span(data_).subspan(head));
  w.value(steps_);
  return w.take_sealed();
}

struct Replay::Step {
  double dt;
  StepHashes hashes;
};

namespace {

// `perform` is given each operation before the next one is read.
template <class Step, class F>
Step read_step(Reader& r, F perform) {
  Step s{r.value<double>(), {}};
  for (std::size_t n = r.count(1); n > 0; --n) {
    Operation op;
    read(r, op);
    perform(op);
  }
  read(r, s.hashes);
  return s;
}

// Of a recording that was cut off.
template <class Step>
std::int64_t count_whole_steps(Reader r) {
  std::int64_t steps = 0;
  try {
    for (; r.left() > 0; ++steps) read_step<Step>(r, [](const Operation&) {});
  } catch (const Error&) {}
  return steps;
}

}

bool Replay::begins(std::span<const std::byte> file) { return has_magic(file, magic) || has_magic(file, open_magic); }

Replay::Replay(Bytes recording, std::int32_t workers)
    : data_(std::move(recording)), world_(Config{.workers = workers}) {
  cut_off_ = has_magic(data_, open_magic);
  Reader r(data_);
  read_header(r, cut_off_ ? open_magic : magic, layout_of_recording(), "a recording");
  if (!cut_off_) data_.resize(unseal(data_).size());
  r = Reader(data_, r.position());
  title_ = r.text();
  Bytes snapshot;
  r.array(snapshot);
  world_.load(snapshot);
  world_.impl().recording = true;  // for the stages' hashes
  position_ = r.position();
  steps_ = cut_off_ ? count_whole_steps<Step>(r) : Reader(data_, data_.size() - sizeof steps_).value<std::int64_t>();
}

bool Replay::done() const { return next_ >= steps_; }

Replay::Step Replay::begin_step() {
  if (done()) throw Error("recording", "has no more steps");
  Reader r(data_, position_, world_.impl().number);
  const Step step = read_step<Step>(r, [&](const Operation& op) {
    world_.impl().replay(op);
    r = Reader(data_, r.position(), world_.impl().number);  // which a load changes
  });
  position_ = r.position();
  world_.impl().log.clear();
  return step;
}

void Replay::end_step(const Step& step) {
  world_.step(step.dt);
  ++next_;
}

std::optional<Divergence> Replay::step(bool check) {
  const Step recorded = begin_step();
  end_step(recorded);
  if (!check) return {};
  const StepHashes is = hashes_of(world_.impl());
  if (recorded.hashes == is) return {};
  return divergence(next_, recorded.hashes, is, world_.impl().bodies);
}

namespace {

// The value of a body's field, as JSON.
std::string value_of(const World& w, const std::string& field, Body body) {
  const StateList state(w.impl());
  const StateList::Part* part = state.find("bodies." + field);
  if (part == nullptr || body.null()) return "";
  std::string text;
  for (const Leaf& leaf : part->leaves(body.index)) {
    if (leaf.path.empty()) return leaf.text;
    text.append(text.empty() ? "{" : ", ").append(quoted(leaf.path)).append(": ").append(leaf.text);
  }
  return text + "}";
}

}

std::optional<RecordingDifference> difference(Replay& a, Replay& b) {
  if (auto d = difference(a.world_, b.world_)) return RecordingDifference{a.next_, "start", *d};
  while (!a.done() && !b.done()) {
    const Replay::Step of_a = a.begin_step(), of_b = b.begin_step();
    const std::int64_t number = a.next_ + 1;
    if (a.world_.hash() != b.world_.hash()) {
      if (auto d = difference(a.world_, b.world_)) return RecordingDifference{number, "operation", *d};
    }
    if (of_a.dt != of_b.dt) {
      return RecordingDifference{
          number, "operation", {.field = "dt", .a = value_text(of_a.dt), .b = value_text(of_b.dt)}};
    }
    a.end_step(of_a), b.end_step(of_b);
    if (of_a.hashes == of_b.hashes) continue;
    const StepHashes here = hashes_of(a.world_.impl());
    const Divergence d = divergence(number, of_a.hashes, of_b.hashes, a.world_.impl().bodies);
    const std::string value = value_of(a.world_, d.field, d.body);
    return RecordingDifference{number,
                               d.stage,
                               {.field = d.field,
                                .body = d.body,
                                .index = d.body.null() ? -1 : std::int64_t(d.body.index),
                                .a = of_a.hashes == here ? value : "",
                                .b = of_b.hashes == here ? value : ""}};
  }
  if (a.done() && b.done()) return {};
  return RecordingDifference{a.next_, "end", {.field = "steps", .a = value_text(a.steps_), .b = value_text(b.steps_)}};
}

}
