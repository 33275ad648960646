#include "io/mjcf/contacts.h"

#include <algorithm>

namespace sudar::inline SUDAR_PRECISION::io {

namespace {

constexpr std::size_t most_classes = 32;  // bits of a filter

template <class Pairs>
bool contains(const Pairs& pairs, const std::string& a, const std::string& b) {
  return pairs.contains({a, b}) || pairs.contains({b, a});
}

}

MjcfContacts::MjcfContacts(Remarks& remarks, const MjcfFile& file, const MjcfSettings& settings)
    : remarks_(remarks), all_off_(!settings.contacts) {
  file.each_in("contact", [&](const XmlElement& e) {
    Fields f = file.fields(e);
    f.pass({"name"});
    const auto both = [&](const char* first, const char* second, Pairs& pairs, std::set<std::string>& names) {
      const auto [it, fresh] = pairs.emplace(f.text(first), f.text(second));
      names.insert(it->first), names.insert(it->second);
    };
    if (e.name == "exclude") {
      both("body1", "body2", excluded_, of_exclusion_);
    } else if (e.name == "pair") {
      both("geom1", "geom2", pairs_, of_pair_);
      for (const char* own : {"friction", "condim"})
        f.leave_out(own, "of a pair is not supported: the pair has the friction of its two geoms");
      f.pass({"solref", "solreffriction", "solimp", "margin", "gap"});
    } else {
      remarks.warn(e.at, "is not known, and left out");
      return;
    }
    f.finish();
  });
}

std::size_t MjcfContacts::meets(const Origin& at, std::uint32_t contype, std::uint32_t conaffinity,
                                const std::string& geom, const std::string& body) {
  Class own{contype, conaffinity, of_pair_.contains(geom) ? geom : "", of_exclusion_.contains(body) ? body : ""};
  for (int attempt = 0; attempt < 2; ++attempt) {
    const auto it = std::ranges::find(classes_, own);
    if (it != classes_.end()) return std::size_t(it - classes_.begin());
    if (classes_.size() < most_classes) {
      classes_.push_back(own);
      return classes_.size() - 1;
    }
    remarks_.warn(
        at,
        "there are more than 32 sorts of contacts (contype, conaffinity, exclude, pair): some pairs touch that "
        "should not");
    own.geom.clear(), own.body.clear();
  }
  return 0;
}

bool MjcfContacts::touch(const Class& a, const Class& b) const {
  if (all_off_) return false;
  if (!a.geom.empty() && !b.geom.empty() && contains(pairs_, a.geom, b.geom)) return true;
  if (!a.body.empty() && !b.body.empty() && contains(excluded_, a.body, b.body)) return false;
  return (a.contype & b.conaffinity) != 0 || (b.contype & a.conaffinity) != 0;
}

std::vector<std::vector<bool>> MjcfContacts::touching() const {
  const std::size_t n = std::max<std::size_t>(classes_.size(), 1);
  std::vector<std::vector<bool>> result(n, std::vector<bool>(n));
  for (std::size_t i = 0; i < classes_.size(); ++i) {
    for (std::size_t k = 0; k < classes_.size(); ++k) result[i][k] = touch(classes_[i], classes_[k]);
  }
  return result;
}

}
