#include "io/mjcf/mjcf.h"

#include "io/mjcf/forces.h"

namespace sudar::inline SUDAR_PRECISION::io {

namespace {

// Sections that say nothing of how bodies move.
bool is_silent(std::string_view section) {
  for (const char* known : {"compiler", "option", "default", "worldbody", "contact", "tendon", "equality", "actuator",
                            "asset", "size", "visual", "statistic", "custom", "sensor"}) {
    if (section == known) return true;
  }
  return false;
}

}

Model read_mjcf(Source& source) {
  Remarks remarks(source);
  const MjcfFile file(source, remarks, source.file());
  const MjcfSettings settings = mjcf_settings(file, remarks);
  Model model;
  if (const XmlAttribute* name = file.root().find("model")) model.name = name->value;
  model.config.dt = settings.timestep;
  model.config.friction_mix = Mix::max;
  const Vec3d down = rotate(z_up(), settings.gravity);
  model.forces.push_back({Gravity{convert<Real>(down)}, file.root().at, {}});

  MjcfBodies bodies = mjcf_bodies(source, remarks, file, settings);
  add_joint_forces(bodies, remarks, file, settings);
  Assembly assembly(std::move(bodies.mechanism), model, source, remarks);
  add_ties(assembly, bodies.names, remarks, file, settings);
  for (const XmlElement& section : file.root().children) {
    if (section.name == "keyframe")
      remarks.note(section.at, "key frames are left out: the model begins as its bodies are placed");
    else if (!is_silent(section.name))
      remarks.warn(section.at, "the section is not supported, and left out");
  }
  remarks.tell();
  return model;
}

}
