// A mechanism as files of robots tell it: links in each other's frames, each with the degrees of freedom against its
// parent. URDF and MJCF become this, and this becomes a model: what is welded together is one body, the degrees of
// freedom between two bodies are joints.
#pragma once

#include "io/fields.h"
#include "io/rigid.h"

namespace sudar::inline SUDAR_PRECISION::io {

inline constexpr int ground = -1;  // among links: the world

enum class Freedom : std::uint8_t { hinge, slide, ball };

// Pulls a coordinate to where it rests, and damps its rate: in N m and rad, or N and m.
struct Spring {
  double stiffness = 0, rest = 0, damping = 0;
  double rate = 0;                                         // at which damping does nothing
  double force = std::numeric_limits<double>::infinity();  // the most that it pulls with
};

// One degree of freedom, or a ball's three. Its coordinate is 0 as the file places the links.
struct Degree {
  Freedom kind = Freedom::hinge;
  std::string name{};
  Origin from{};
  Vec3d at{}, axis{0, 0, 1};  // in the link's frame
  std::optional<std::pair<double, double>> range{};
  std::vector<Spring> springs{};
  double friction = 0;  // N m or N, whatever the speed
  double armature = 0;  // kg m² or kg, of a rotor: inertia along the coordinate alone

  void add(const Spring&);
};

// One shape of a link.
struct Piece {
  std::string name{};
  Origin from{};
  Shape shape{};
  Frame at{};             // of the shape's frame, in the link's
  MassProperties unit{};  // in the shape's frame; volume 0: has no mass
  double mass = 0;        // kg
  Material material{};
  std::size_t meets = 0;  // its number among Articulation::classes
};

struct Link {
  std::string name{};
  Origin from{};
  int parent = ground;
  Frame at{};                     // in the parent's
  bool free = false;              // nothing holds it to its parent
  bool kinematic = false;         // moved by hand
  double gravity = 1;             // times what gravity does to it
  std::vector<Degree> degrees{};  // from the parent outwards
  Inertial inertial{};            // in its own frame
  std::vector<Piece> pieces{};
};

struct Articulation {
  std::vector<Link> links;  // parents first
  // Which pieces touch each other, by classes of them: row and column for each.
  std::vector<std::vector<bool>> touching{{true}};
  bool meets_nothing(std::size_t c) const;
};

// Where the links have come to in a model.
class Assembly {
 public:
  // Adds bodies and joints to the model, in a world in which y is up. What cannot be made exactly is remarked.
  Assembly(Articulation, Model&, Source&, Remarks&);

  const Articulation& mechanism() const { return mechanism_; }
  Frame frame_of(int link) const;  // in the model's world
  Body body_of(int link) const;    // its number; null: the world
  // Another joint between two links.
  void join(JointDef, const Origin& from, const std::string& name);

 private:
  int root_of(int link) const { return link == ground ? ground : roots_[std::size_t(link)]; }
  void find_roots();
  void shorten();
  void add_bodies();
  void add_body(int root);
  void add_still(int link);
  ShapeDef shape_def(const Piece&, const Frame& in_body) const;

  Articulation mechanism_;
  Model& model_;
  Source& source_;
  Remarks& remarks_;
  std::vector<Frame> frames_;            // by link, in the world
  std::vector<int> roots_;               // by link: that which moves, and carries it; ground: nothing does
  std::vector<std::vector<int>> parts_;  // by root: the links that it carries, itself included
  std::vector<int> bodies_;              // by link: number of its body; -1: none
};

// Joints that leave b those degrees of freedom against a, added to the model. The degrees are in the world.
void connect(Model&, Remarks&, Body a, Body b, std::span<const Degree>);

}
