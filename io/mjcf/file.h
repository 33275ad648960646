// An MJCF file as one tree: its includes in their places, its default classes at hand.
#pragma once

#include "io/fields.h"

namespace sudar::inline SUDAR_PRECISION::io {

class MjcfFile {
 public:
  // `path`: the source's own, or that of a model which it attaches.
  MjcfFile(Source&, Remarks&, const std::filesystem::path& path);

  const std::filesystem::path& path() const { return path_; }
  const XmlElement& root() const { return root_; }
  // Its attributes over those of its default class: its own `class`, else `childclass`, else the main one. `kind`: of
  // whose defaults, where it is not the element's name that says so.
  Fields fields(const XmlElement&, const std::string& childclass = {}, std::string kind = {}) const;
  // Throws FileError where there is no such class.
  void require_class(const Origin& at, const std::string& name) const;
  // Visits the elements in all sections of that name, also where they lie in several.
  template <class Visit>
  void each_in(std::string_view section, Visit visit) const {
    for (const XmlElement& s : root_.children) {
      if (s.name != section) continue;
      for (const XmlElement& e : s.children) visit(e);
    }
  }

 private:
  // A class and what it says of each kind of element.
  struct Class {
    std::string parent{};  // empty: none, of the main one
    std::map<std::string, std::vector<XmlAttribute>> attributes{};
  };
  void expand(XmlElement&, std::size_t depth);
  void read_defaults(const XmlElement&, const std::string& parent);

  Source& source_;
  Remarks& remarks_;
  std::filesystem::path path_;
  std::vector<std::filesystem::path> included_;
  XmlElement root_;
  std::map<std::string, Class> classes_;
};

}
