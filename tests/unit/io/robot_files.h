// Small files of robots, written where a test runs and read back.
#pragma once

#include <gtest/gtest.h>
#include <sudar/io.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace sudar::io {

class Folder {
 public:
  Folder() {
    static int number = 0;
    path_ = std::filesystem::temp_directory_path() /
            ("sudar_io_" + std::to_string(::getpid()) + "_" + std::to_string(number++));
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    const std::filesystem::path file = path_ / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
    return file;
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline Reading read_text(const std::string& ending, const std::string& text) {
  const Folder folder;
  return read(folder.write("file" + ending, text));
}
inline Reading read_mjcf(const std::string& inside) { return read_text(".xml", "<mujoco>\n" + inside + "</mujoco>\n"); }
inline Reading read_urdf(const std::string& inside) {
  return read_text(".urdf", "<robot name='r'>\n" + inside + "</robot>\n");
}

// All findings from some severity on, one a line.
inline std::string told(const Reading& r, Severity least = Severity::warning) {
  std::string all;
  for (const Finding& f : r.findings) {
    if (f.severity < least) continue;
    Finding shown = f;
    shown.at.file = std::filesystem::path(f.at.file).filename().string();
    all.append(text(shown)).append("\n");
  }
  return all;
}
inline bool mentions(const Reading& r, const std::string& words) {
  return told(r, Severity::note).find(words) != std::string::npos;
}

inline const BodyDef& body(const Model& m, const std::string& name) {
  const auto it = std::ranges::find(m.bodies, name, [](const auto& b) { return b.def.name; });
  if (it == m.bodies.end()) throw Error("body", "there is none of that name: " + name);
  return it->def;
}
template <class Kind>
const Kind& joint(const Model& m, const std::string& name) {
  for (const auto& j : m.joints) {
    if (j.name == name && std::holds_alternative<Kind>(j.def)) return std::get<Kind>(j.def);
  }
  throw Error("joint", "there is none of that name and kind: " + name);
}
template <class Kind>
std::ptrdiff_t count(const Model& m) {
  return std::ranges::count_if(m.joints, [](const auto& j) { return std::holds_alternative<Kind>(j.def); });
}

}
