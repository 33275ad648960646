// The bodies of an MJCF file as links, with all that hangs on them: joints, geoms, sites, inertia.
#pragma once

#include "io/mjcf/settings.h"

namespace sudar::inline SUDAR_PRECISION::io {

// What other sections of the file call by name.
struct MjcfNames {
  template <class T>
  using Table = std::map<std::string, T>;
  struct Place {
    int link;
    Vec3d at;  // in the link's frame
  };
  Table<int> bodies;
  struct Joint {
    int link;
    std::size_t degree;  // its number among the link's
    double reference;    // MuJoCo's coordinate where that of the degree is 0
  };
  Table<Joint> joints;
  Table<Place> sites;
};

struct MjcfBodies {
  Articulation mechanism;
  MjcfNames names;
};

MjcfBodies mjcf_bodies(Source&, Remarks&, const MjcfFile&, const MjcfSettings&);

}
