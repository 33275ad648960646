// The meshes that an MJCF file names, each read when a geom asks for it.
#pragma once

#include "io/mjcf/settings.h"
#include "io/solid.h"

namespace sudar::inline SUDAR_PRECISION::io {

class MjcfMeshes {
 public:
  MjcfMeshes(Source&, Remarks&, const MjcfFile&, const MjcfSettings&);
  // Throws FileError where there is none of that name.
  const Solid& find(const Origin& at, const std::string& name);

 private:
  struct Entry {
    const XmlElement* element;
    std::optional<Solid> made{};
  };
  Solid make(const XmlElement&);

  Source& source_;
  Remarks& remarks_;
  const MjcfFile& file_;
  const MjcfSettings& settings_;
  std::map<std::string, Entry> meshes_;
};

}
