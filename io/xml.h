// XML as far as URDF and MJCF use it: elements and their attributes, each with its line. Text between elements is
// passed over; a document type with declarations is refused, so that no entity can blow up. Our own, because of the
// lines, and because it is compiled wherever the engine is.
#pragma once

#include "io/source.h"

namespace sudar::inline SUDAR_PRECISION::io {

// In quotes, as messages show what a file says: cut where it is long.
std::string in_quotes(std::string_view);

struct XmlAttribute {
  std::string name{}, value{};
  Origin at{};  // its field is the element with the attribute
};
struct XmlElement {
  std::string name;
  Origin at{};
  std::vector<XmlAttribute> attributes{};
  std::vector<XmlElement> children{};

  const XmlAttribute* find(std::string_view attribute) const;
  const XmlElement* child(std::string_view element) const;  // the first of that name; null: none
};

// The root element. `file`: as findings name it. Throws FileError with the line of what is no XML, and where there is
// more of it than the source's limits allow.
XmlElement parse_xml(Source&, std::string_view text, const std::string& file);

}
