#include "io/mjcf/file.h"

#include <algorithm>

namespace sudar::inline SUDAR_PRECISION::io {

namespace {

constexpr const char* main_class = "main";

bool is_orientation(std::string_view name) {
  return name == "quat" || name == "axisangle" || name == "euler" || name == "xyaxes" || name == "zaxis";
}

// Kinds of elements that share their defaults.
std::string kind_of(const std::string& element) {
  for (const char* actuator :
       {"general", "motor", "position", "velocity", "intvelocity", "damper", "cylinder", "muscle", "adhesion"}) {
    if (element == actuator) return "general";
  }
  if (element == "fixed" || element == "spatial") return "tendon";
  if (element == "connect" || element == "weld") return "equality";
  return element;
}

// One way of saying how something is turned replaces another.
void lay_over(std::vector<XmlAttribute>& all, const std::vector<XmlAttribute>& more) {
  if (std::ranges::any_of(more, [](const auto& a) { return is_orientation(a.name); }))
    std::erase_if(all, [](const auto& a) { return is_orientation(a.name); });
  for (const XmlAttribute& a : more) {
    const auto it = std::ranges::find(all, a.name, &XmlAttribute::name);
    if (it == all.end())
      all.push_back(a);
    else
      *it = a;
  }
}

}

MjcfFile::MjcfFile(Source& source, Remarks& remarks, const std::filesystem::path& path)
    : source_(source), remarks_(remarks), path_(path), included_{path.lexically_normal()} {
  const bool own = path == source.file();
  const Bytes bytes = own ? Bytes{} : source.read(path);
  const std::string_view text{reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  root_ = parse_xml(source, own ? source.text() : text, path.string());
  if (root_.name != "mujoco" && root_.name != "mujocoinclude")
    throw FileError(root_.at, "is no MJCF: its root is " + in_quotes(root_.name) + ", not \"mujoco\"" +
                                  (root_.name == "robot" ? "; a URDF is read where its name ends with .urdf" : ""));
  expand(root_, 1);
  classes_[main_class] = {};
  for (const XmlElement& section : root_.children) {
    if (section.name == "default") read_defaults(section, {});
  }
}

// Each include becomes the children of the root of the file that it names.
void MjcfFile::expand(XmlElement& e, std::size_t depth) {
  if (depth > source_.options().limits.nesting) throw FileError(e.at, "lies too deep in other elements and files");
  const auto is_include = [](const XmlElement& c) { return c.name == "include"; };
  if (std::ranges::any_of(e.children, is_include)) {
    std::vector<XmlElement> children;
    for (XmlElement& c : e.children) {
      if (!is_include(c)) {
        children.push_back(std::move(c));
        continue;
      }
      Fields fields(remarks_, c);
      const std::string name = fields.text("file");
      fields.finish();
      try {
        const std::filesystem::path file = source_.find(name, path_).lexically_normal();
        if (std::ranges::find(included_, file) != included_.end())
          throw Error("", in_quotes(name) + " is included for the second time");
        included_.push_back(file);
        const Bytes bytes = source_.read(file);
        XmlElement root =
            parse_xml(source_, {reinterpret_cast<const char*>(bytes.data()), bytes.size()}, file.string());
        expand(root, depth + 1);
        std::ranges::move(root.children, std::back_inserter(children));
      } catch (const FileError&) { throw; } catch (const Error& error) {
        throw FileError(c.at, error.what());
      }
    }
    e.children = std::move(children);
  }
  for (XmlElement& c : e.children) expand(c, depth + 1);
}

void MjcfFile::read_defaults(const XmlElement& e, const std::string& parent) {
  const XmlAttribute* own = e.find("class");
  if (own == nullptr && !parent.empty()) throw FileError(e.at, "a class of defaults needs the attribute \"class\"");
  const std::string name = own != nullptr ? own->value : main_class;
  if (!parent.empty() && classes_.contains(name)) throw FileError(own->at, "there are two classes " + in_quotes(name));
  // The outermost class is the main one, whatever it is called.
  if (parent.empty() && name != main_class) classes_[name].parent = main_class;
  if (!parent.empty()) classes_[name].parent = parent;
  for (const XmlElement& c : e.children) {
    if (c.name != "default")
      lay_over(classes_[parent.empty() ? main_class : name].attributes[kind_of(c.name)], c.attributes);
  }
  for (const XmlElement& c : e.children) {
    if (c.name == "default") read_defaults(c, parent.empty() ? main_class : name);
  }
}

void MjcfFile::require_class(const Origin& at, const std::string& name) const {
  if (!classes_.contains(name)) throw FileError(at, "there is no class of defaults " + in_quotes(name));
}

Fields MjcfFile::fields(const XmlElement& e, const std::string& childclass, std::string kind) const {
  const XmlAttribute* own = e.find("class");
  std::string name = own != nullptr ? own->value : childclass.empty() ? main_class : childclass;
  require_class(own != nullptr ? own->at : e.at, name);
  std::vector<const std::vector<XmlAttribute>*> layers{&e.attributes};
  if (kind.empty()) kind = kind_of(e.name);
  for (; !name.empty(); name = classes_.at(name).parent) {
    const auto& known = classes_.at(name).attributes;
    if (const auto it = known.find(kind); it != known.end()) layers.push_back(&it->second);
  }
  std::vector<XmlAttribute> all;
  for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer) lay_over(all, **layer);
  Fields fields(remarks_, e.at, std::move(all));
  fields.pass({"class"});
  return fields;
}

}
