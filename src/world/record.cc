// A recording: header, title, snapshot; per step: dt, the operations before it, hashes after it; the number of steps, seal.
// An open one begins with another word and lacks the last two.
#include <sudar/record.h>

#include "base/hash.h"
#include "world/impl.h"
#include "world/stages.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

constexpr std::uint64_t magic = 0x31302e6365727573;  // "surec.01" as bytes
constexpr std::uint64_t open_magic = 0x6e65706f72727573;  // "surropen" as bytes
static_assert(sizeof magic == Recorder::head);
constexpr std::uint32_t version = 1;

// What a step led to: enough to name the first stage, field and body that differ.
struct StepHashes {
  std::vector<std::uint64_t> stages, fields, bodies;
  bool operator==(const StepHashes&) const = default;
  friend void write(Writer& w, const StepHashes& h) { w.array(h.stages), w.array(h.fields), w.array(h.bodies); }
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
  Writer w;
  w.value(open_magic), w.value(version);
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
  Writer w;
  w.value(world_.last_dt);
  w.value(std::uint64_t(world_.log.size()));
  for (const Operation& op : world_.log) write(w, op);
  write(w, hashes_of(world_));
  data_.insert(data_.end(), w.bytes().begin(), w.bytes().end());
  world_.log.clear();
  ++steps_;
}

Bytes Recorder::bytes() const {
  Writer w;
  w.value(magic);
  w.raw(data_.data() + head, data_.size() - head);
  w.value(steps_);
  return w.take_sealed();
}

namespace {

struct Step {
  double dt;
  StepHashes hashes;
};

// `perform` is given each operation before the next one is read.
template <class F>
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
std::int64_t count_whole_steps(Reader r) {
  std::int64_t steps = 0;
  try {
    for (; r.left() > 0; ++steps) read_step(r, [](const Operation&) {});
  } catch (const Error&) {}
  return steps;
}

}

Replay::Replay(Bytes recording) : data_(std::move(recording)) {
  Reader r(data_);
  const std::uint64_t kind = r.left() < sizeof magic ? 0 : r.value<std::uint64_t>();
  if (kind != magic && kind != open_magic) throw Error("recording", "is not a recording");
  cut_off_ = kind == open_magic;
  if (const auto v = r.value<std::uint32_t>(); v != version) {
    throw Error("version", "is " + std::to_string(v) + ", this program reads " + std::to_string(version));
  }
  if (!cut_off_) data_.resize(unseal(data_).size());
  r = Reader(data_, r.position());
  title_ = r.text();
  Bytes snapshot;
  r.array(snapshot);
  world_.load(snapshot);
  world_.impl().recording = true;  // for the stages' hashes
  position_ = r.position();
  steps_ = cut_off_ ? count_whole_steps(r) : Reader(data_, data_.size() - sizeof steps_).value<std::int64_t>();
}

bool Replay::done() const { return next_ >= steps_; }

std::optional<Divergence> Replay::step(bool check) {
  if (done()) throw Error("recording", "has no more steps");
  Reader r(data_, position_, world_.impl().number);
  const Step recorded = read_step(r, [&](const Operation& op) {
    world_.impl().replay(op);
    r = Reader(data_, r.position(), world_.impl().number);  // which a load changes
  });
  position_ = r.position();
  world_.impl().log.clear();
  world_.step(recorded.dt);
  ++next_;
  if (!check) return {};
  const StepHashes is = hashes_of(world_.impl());
  if (recorded.hashes == is) return {};
  return divergence(next_, recorded.hashes, is, world_.impl().bodies);
}

}
