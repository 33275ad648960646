#include <sudar/session.h>

#include <algorithm>
#include <cstdlib>

#include "base/file_header.h"
#include "base/text.h"
#include "world/impl.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

// Edit distance: for "did you mean".
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t above = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0u : 1u)});
      diagonal = above;
    }
  }
  return row[b.size()];
}

// A slip of the finger: a third of the letters at most.
bool near(std::string_view given, std::string_view name) {
  return distance(given, name) <= std::max<std::size_t>(1, name.size() / 3);
}

double checked_seconds(double seconds) {
  if (!(seconds >= 0) || std::isinf(seconds)) throw Error("seconds", "is " + text(seconds) + ", must be finite and not negative");
  return seconds;
}

constexpr std::uint64_t magic = 0x32302e6e73647573;  // "sudsn.02" as bytes
constexpr std::uint64_t kind = 0xffffffffffff;       // of it: without the version

}

ScenarioPointer make_scenario(const ScenarioEntry& entry) {
  ScenarioPointer scenario(entry.create(entry), entry.destroy);
  if (!scenario) throw Error(entry.name, "the plugin makes no scenario");
  return scenario;
}

void Catalogue::add(const ScenarioEntry* entry) {
  if (entry == nullptr) throw Error("plugin", "has no entry");
  if (entry->abi == nullptr) throw Error("plugin", "does not say what it was built for");
  const std::string engine = abi_of_this_engine();
  if (engine != entry->abi) {
    throw Error("plugin", "was built for [" + std::string(entry->abi) + "], this engine is [" + engine + "]");
  }
  const bool whole = entry->name != nullptr && *entry->name != '\0' && entry->place != nullptr &&
                     entry->about != nullptr && entry->create != nullptr && entry->destroy != nullptr;
  if (!whole) throw Error("plugin", "has an entry with holes");
  if (!(entry->seconds >= 0 && entry->seconds <= 1e12 && entry->picture >= 0 && entry->picture <= 1e12)) {
    throw Error("plugin", "lasts no time that can be run");
  }
  for (const ScenarioEntry* e : entries_) {
    if (std::strcmp(e->name, entry->name) == 0) throw Error(entry->name, "is there twice");
  }
  entries_.push_back(entry);
  std::sort(entries_.begin(), entries_.end(), [](const ScenarioEntry* a, const ScenarioEntry* b) {
    const int order = std::strcmp(a->place, b->place);
    return order != 0 ? order < 0 : std::strcmp(a->name, b->name) < 0;
  });
}

const ScenarioEntry& Catalogue::find(std::string_view name) const {
  if (const ScenarioEntry* opened = opener_ ? opener_(name) : nullptr) return *opened;
  const ScenarioEntry* nearest = nullptr;
  for (const ScenarioEntry* e : entries_) {
    if (name == e->name) return *e;
    if (nearest == nullptr || distance(name, e->name) < distance(name, nearest->name)) nearest = e;
  }
  std::string hint = entries_.empty() ? ": there are none" : "; sudar list names all";
  if (nearest != nullptr && near(name, nearest->name)) hint = "; did you mean '" + std::string(nearest->name) + "'?";
  throw Error("scene", "'" + std::string(name) + "' does not exist" + hint);
}

KeyScript::KeyScript(std::string_view text) {
  std::size_t i = 0;
  while (i < text.size()) {
    const std::size_t end = std::min(text.find(' ', i), text.size());
    const std::string word(text.substr(i, end - i));
    i = end + 1;
    if (word.empty()) continue;
    char* rest = nullptr;
    const double time = std::strtod(word.c_str(), &rest);
    if (!std::isfinite(time) || rest == word.c_str() || *rest != ':' || rest[1] == '\0' || !(time >= 0) ||
        (!entries_.empty() && time < entries_.back().first)) {
      throw Error("keys", "'" + word + "' is not TIME:KEY+KEY or TIME:none, with times that do not fall");
    }
    std::vector<std::string> keys;
    const std::string list = rest + 1;
    for (std::size_t k = 0; k <= list.size() && list != "none";) {
      const std::size_t plus = std::min(list.find('+', k), list.size());
      if (plus == k) throw Error("keys", "'" + word + "' names a key without a name");
      keys.push_back(list.substr(k, plus - k));
      if (!Input::is_key(keys.back())) {
        throw Error("keys", "'" + keys.back() + "' is no key: a to z, 0 to 9, " + Input::named_keys + " are");
      }
      k = plus + 1;
    }
    entries_.push_back({time, keys});
  }
}

void KeyScript::apply(double time, Input& input) {
  for (; next_ < entries_.size() && entries_[next_].first <= time + 1e-9; ++next_) input.set(entries_[next_].second);
}

void KeyScript::skip(double time) {
  while (next_ < entries_.size() && entries_[next_].first <= time + 1e-9) ++next_;
}

Session::Session(const ScenarioEntry& entry, const Settings& settings)
    : entry_(&entry), scenario_(make_scenario(entry)), seconds_(checked_seconds(settings.seconds.value_or(entry.seconds))) {
  Params params(settings.set);
  scenario_->params(params);
  params.require_all_known();
  params_ = params.entries();
  Config config;
  scenario_->config(config);
  for (const auto& [path, value] : settings.config) set_field(config, path, value);
  world_ = World(config);
  scenario_->build(world_);
}

double Session::dt() const { return world_.config().dt * double(world_.config().time_factor); }

bool Session::done() const { return world_.time() >= seconds_ - dt() / 2; }

template <class F>
void Session::unless_abandoned(F does) {
  if (!abandoned_.empty()) return;
  try {
    does();
  } catch (const Error& e) { abandoned_ = e.what(); }
}

void Session::step() {
  unless_abandoned([&] { scenario_->control(world_, input); });
  input.clear_pressed();
  const double before = world_.time();
  world_.step();
  check_.visit(world_.time(), world_.time() - before, true);
  unless_abandoned([&] { scenario_->observe(world_, check_); });
}

const Check& Session::finish() {
  check_.visit(world_.time(), dt(), world_.time() >= entry_->seconds - dt() / 2);
  unless_abandoned([&] { scenario_->check(world_, check_); });
  if (!abandoned_.empty()) check_.that("goes on to the end: " + abandoned_, false);
  return check_;
}

Bytes Session::save() const {
  ByteWriter w;
  write_header(w, magic, layout_of_state());
  w.text(entry_->name);
  w.value(std::uint64_t(params_.size()));
  for (const Params::Entry& p : params_) w.text(p.name), w.value(p.value);
  State state;
  scenario_->state(state);  // writes: changes nothing
  w.array(state.bytes());
  w.array(check_.save());
  w.array(input.save());
  w.value(seconds_);
  w.text(abandoned_);
  w.array(world_.save());
  return w.take_sealed();
}

bool Session::begins(std::span<const std::byte> file) {
  return file.size() >= sizeof magic && (Reader(file).value<std::uint64_t>() & kind) == (magic & kind);
}

Session Session::load(const Catalogue& catalogue, std::span<const std::byte> bytes, std::int32_t workers) {
  Reader r(bytes);
  if (begins(bytes) && !has_magic(bytes, magic)) {
    throw Error("version", "of the saved run is another one than this program reads");
  }
  read_header(r, magic, layout_of_state(), "a saved run");
  r = Reader(unseal(bytes), r.position());
  Session s;
  s.entry_ = &catalogue.find(r.text());
  s.scenario_ = make_scenario(*s.entry_);
  std::map<std::string, double> values;
  for (std::size_t n = r.count(1); n > 0; --n) {
    std::string name = r.text();
    values[std::move(name)] = r.value<double>();
  }
  Params params(values);
  s.scenario_->params(params);
  params.require_all_known();
  s.params_ = params.entries();
  Bytes part;
  r.array(part);
  State state(part);
  s.scenario_->state(state);
  if (!state.all_read()) throw Error("data", "holds more than the scenario remembers");
  r.array(part);
  s.check_.load(part);
  r.array(part);
  s.input.load(part);
  s.seconds_ = checked_seconds(r.value<double>());
  s.abandoned_ = r.text();
  r.array(part);
  s.world_ = World(Config{.workers = workers});
  s.world_.load(part);
  return s;
}

}
