// Which geoms of an MJCF file may touch: contype and conaffinity, <exclude> and <pair>. Geoms alike in all of these are
// a class; a world has room for 32 of them.
#pragma once

#include <set>

#include "io/mjcf/settings.h"

namespace sudar::inline SUDAR_PRECISION::io {

class MjcfContacts {
 public:
  MjcfContacts(Remarks&, const MjcfFile&, const MjcfSettings&);
  // The class of a geom, by the names of itself and its body.
  std::size_t meets(const Origin& at, std::uint32_t contype, std::uint32_t conaffinity, const std::string& geom,
                    const std::string& body);
  // Of two classes, whether they touch.
  std::vector<std::vector<bool>> touching() const;

 private:
  struct Class {
    std::uint32_t contype, conaffinity;
    std::string geom, body;  // empty: of no pair, of no exclusion
    bool operator==(const Class&) const = default;
  };
  bool touch(const Class&, const Class&) const;
  Remarks& remarks_;
  bool all_off_;
  using Pairs = std::set<std::pair<std::string, std::string>>;
  Pairs excluded_, pairs_;                        // of bodies, of geoms
  std::set<std::string> of_exclusion_, of_pair_;  // all names in them
  std::vector<Class> classes_;
};

}
