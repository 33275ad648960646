// Files that other programs wrote: read as a model, which becomes a world, or a scenario that runs like any other.
//   const io::Reading r = io::read("robot.glb");
//   for (const io::Finding& f : r.findings) std::puts(io::text(f).c_str());   // what is not supported, by file and
//   line World w(r.model().config); io::build(r.model(), w);
// docs/files.md says which formats there are and what is read of each. Link sudar::io.
#pragma once

#include <sudar/scenario.h>

#include <filesystem>
#include <functional>
#include <mutex>

namespace sudar::inline SUDAR_PRECISION::io {

// --- what was found while reading ---

enum class Severity : std::uint8_t {
  note,     // read in a way that one may want to know of
  warning,  // something is left out or replaced, and the rest is read
  error,    // the file is refused
};
inline const char* const* names(Severity) {
  static constexpr const char* n[] = {"note", "warning", "error", nullptr};
  return n;
}

// A place in a file.
struct Origin {
  std::string file{};   // as a user would name it
  int line = 0;         // from 1; 0: none, as in a binary file
  std::string field{};  // what stands there: a JSON pointer (RFC 6901), or an XML element with its attribute
};
std::string text(const Origin&);  // "robot.gltf:12: /nodes/3/scale"
struct Finding {
  Severity severity = Severity::note;
  Origin at{};
  std::string message{};
};
// Refuses a file, or something in it.
class FileError : public Error {
 public:
  FileError(Origin place, const std::string& reason)
      : Error(text(place), reason), at(std::move(place)), message(reason) {}
  Origin at;
  std::string message;
};
// "robot.gltf:12: warning: /nodes/3/scale: is not uniform; …"
std::string text(const Finding&);

// --- what a file describes ---

// A definition, and where it came from. `name` is its own in the file; a body's is in its BodyDef, too.
template <class Def>
struct Item {
  Def def{};
  Origin from{};
  std::string name{};
};

struct PairMaterial {  // World::set_pair_material()
  Body a{}, b{};
  std::optional<Material> material{};
};
template <class V, Like<PairMaterial> T>
void describe(V& v, T& d) {
  v("a", d.a, any), v("b", d.b, any), v("material", d.material, any);
}

// A joint, and where one of its bodies has to be while it is made, if that is not where it is: a joint's coordinate is
// 0 where it is made, and its points and axes are those that meet there.
struct JointItem {
  JointDef def{};
  Origin from{};
  std::string name{};
  struct Place {
    Body body{};
    Pose at{};
  };
  std::optional<Place> made_at{};
};

// Plain data: the definitions of which a world is made. Where one of them names a body, body_number(i) stands for
// bodies[i] and a null body for the world.
struct Model {
  std::string name{};  // of the file's scene; may be empty
  Config config{};
  std::vector<Item<BodyDef>> bodies{};
  std::vector<JointItem> joints{};
  std::vector<Item<Force>> forces{};  // Gravity included
  std::vector<Item<PairMaterial>> pair_materials{};
  std::optional<Camera> camera{};
  double seconds = 10;  // that a run of it usually lasts
};
inline Body body_number(std::size_t i) { return {.index = std::uint32_t(i)}; }

// The handles of what was made, in the model's order.
struct Built {
  std::vector<Body> bodies;
  std::vector<Joint> joints;
};
// Adds everything to the world. Throws FileError for what the world refuses; what was added before it then stays.
Built build(const Model&, World&);

// --- reading and writing ---

struct ReadOptions {
  // Folders whose files may be read, too. Without them nothing outside the file's own folder and those in it is,
  // whatever the file says: "..", absolute paths and symbolic links are followed only where they end inside.
  std::vector<std::filesystem::path> allow{};
  double unit = 0;  // m: length of the file's unit, for formats that do not say it (STL, OBJ, PLY); 0: 1, with a
                    // warning where that makes a body larger than 10 m
  // What a file may ask for, so that a bad one fails soon and with a reason.
  struct Limits {
    std::size_t bytes = std::size_t(1) << 30;  // of all files together
    std::size_t nesting = 256;                 // of elements, nodes and files in each other
    std::size_t items = 1'000'000;             // bodies, joints, shapes: of each
    std::size_t vertices = 10'000'000;         // of all meshes together, and as many triangles
    std::size_t findings = 1'000;
  } limits{};
};

struct Reading {
  std::vector<Finding> findings{};  // in the order in which they were found
  std::optional<Model> made{};      // none: the file was refused
  const Model& model() const;       // throws FileError with the reason where it was
};

// Reads a file by what its name ends with. Never throws for what the file holds, or that it is not there: those are
// findings. A model that is read can be built.
Reading read(const std::filesystem::path&, const ReadOptions& = {});
// May read() know what to do with a file of that name? And the endings that it knows, ".glb"…
bool is_readable(const std::filesystem::path&);
std::vector<std::string> readable_endings();

// What a file of that name would hold, by its ending; what the format has no place for is added to `lost`. Throws
// Error: no format has that ending.
Bytes write(const Model&, const std::filesystem::path&, std::vector<Finding>& lost);
bool is_writable(const std::filesystem::path&);
std::vector<std::string> writable_endings();
std::string list(const std::vector<std::string>&);  // ".glb, .gltf"

// --- running ---

// A model as a scenario with that name, for Catalogue, Session and whatever runs those; must outlive them.
class ModelEntry : public ScenarioEntry {
 public:
  ModelEntry(std::string name, Model);
  ModelEntry(const ModelEntry&) = delete;  // its base points into it
  ModelEntry& operator=(const ModelEntry&) = delete;
  const Model& model() const { return model_; }

 private:
  std::string name_, place_, about_;
  Model model_;
};

// Files as if they were scenarios, for Catalogue::open_with(). Owns what it opened for as long as it lives: sessions made of
// that must be gone before. Opens from any thread.
class FileScenes {
 public:
  // `tell` hears every finding when a file is read.
  FileScenes(ReadOptions options, std::function<void(const Finding&)> tell)
      : options_(std::move(options)), tell_(std::move(tell)) {}
  // Null: no file that can be read is called so. Reads it anew where it has changed. Throws FileError where it is refused.
  const ScenarioEntry* open(std::string_view name);

 private:
  struct Opened {
    std::filesystem::file_time_type written;
    std::unique_ptr<ModelEntry> entry;
  };
  ReadOptions options_;
  std::function<void(const Finding&)> tell_;
  std::mutex mutex_;
  std::vector<Opened> opened_;  // older states of a file stay, for those who run them
};

}
